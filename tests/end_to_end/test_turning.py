"""RS-274 for five axes: the interpreter's calls, by forward kinematics, against the CL."""
import json
import unittest

import numpy
from arelem_run import PROJECT
from test_ngc import NgcCase

import path as paths
import turning
from examples import REFUSED

RESOLUTION = 1e-3  # the last digits
AXIS = 1e-5
DATA = ["-I", PROJECT / "examples"]
TURN = 2e-6  # 1e-4 degrees, rounded, of two axes; times the distance from them
MACHINES = ["mill5_table_table", "mill5_head_head", "mill5_head_table"]
# A dome cut with the tool square to it, and a row of holes square to its edge.
DOME = """PARTNO DOME
UNITS/MM
CUTTER/6
MULTAX/ON
FROM/0,0,200,0,0,1
FEDRAT/500
RAPID,GOTO/0,0,70,0,0,1
""" + "".join(f"GOTO/{50 * i:.9f},{50 * j:.9f},{50 * k:.9f},{i:.9f},{j:.9f},{k:.9f}\n" for i, j, k in (
    (numpy.sin(0.05 * n) * numpy.cos(0.25 * n), numpy.sin(0.05 * n) * numpy.sin(0.25 * n), numpy.cos(0.05 * n))
    for n in range(1, 24))) + "FINI\n"


def poses(records):
    """(place, axis, rapid) of each location behind FROM."""
    rapid, out = False, []
    for line in records.splitlines():
        record = json.loads(line)
        if record["kind"] == "POST" and record["word"] == "RAPID":
            rapid = True
        elif record["kind"] in ("GOTO", "CONT"):
            out += [(p[:3], p[3:6] if len(p) > 3 else (0, 0, 1), rapid) for p in record["points"]]
            rapid = False
    return out


def off_segment(p, a, b):
    return paths.to_segment(tuple(p), tuple(a), tuple(b))


class Turning(NgcCase):
    def compare(self, text, name):
        """The trunnion of the library turns by 120 degrees; some guns point up from below."""
        file = self.folder / "machine.toml"
        library = (PROJECT / "stdlib" / "machines" / f"{name}.machine.toml").read_text()
        file.write_text(library.replace("range = [-120, 120]", "range = [-190, 190]"))
        machine = turning.Machine(file)
        calls = self.interpret(text, "--machine", "machine.toml", *DATA)
        swings = "W0668" in self.err  # rapid moves that have no even way, and say so
        source = self.write("cl.apt", text)
        self.assertExit(0, "compile", source, "--to", "json", "-o", "-", *DATA)
        wanted = poses(self.out)
        reached, at, before = 0, None, None
        for move in paths.canonical_moves(calls):
            self.assertIsNone(move.arc)
            self.assertTrue(machine.in_range(move.axes), move.axes)
            end, axis = machine.pose(move.end, move.axes)
            goal, goal_axis, rapid = wanted[reached]
            resolution = RESOLUTION + TURN * (numpy.linalg.norm(goal) + 300)
            # On the way the tool end keeps to the straight line, with all axes moving evenly.
            if at is not None and not (swings and rapid):
                for s in (0.25, 0.5, 0.75, 1.0):
                    place, _ = machine.pose([a + s * (b - a) for a, b in zip(before.end, move.end)],
                                            [a + s * (b - a) for a, b in zip(before.axes, move.axes)])
                    self.assertLess(off_segment(place, at, goal), machine.tolerance + resolution, move.end)
            before = move
            if numpy.linalg.norm(end - goal) < resolution and numpy.linalg.norm(axis - goal_axis) < AXIS:
                self.assertEqual(move.feed is None, rapid)
                reached, at = reached + 1, goal
                # A location that differs by less than the output can say has no move of its own.
                while reached < len(wanted) and numpy.linalg.norm(end - wanted[reached][0]) < resolution and \
                        numpy.linalg.norm(axis - wanted[reached][1]) < AXIS:
                    reached += 1
        self.assertEqual(reached, len(wanted), f"{name}: location {wanted[min(reached, len(wanted) - 1)]} is not reached")

    def test_dome(self):
        for name in MACHINES:
            with self.subTest(name):
                self.compare(DOME, name)

    def test_tilted_guns_of_the_examples(self):
        for example, (code, _) in REFUSED.items():
            if code == "E0672":
                with self.subTest(example):
                    self.compare((PROJECT / "examples" / example).read_text(), "mill5_table_table")

    def test_past_and_from_the_pole(self):
        """Straight over the pole, past it by less than the tolerance of the axis, and from it to a side."""
        head = "CUTTER/6\nMULTAX/ON\nFEDRAT/200\nFROM/0,0,90,0,.1,.9949874\nGOTO/0,0,60,0,.1,.9949874\n"
        for way, standing in (("GOTO/10,0,60,0,-.1,.9949874\n", False), ("GOTO/10,0,60,.00001,-.1,.9949874\n", False),
                              ("GOTO/10,0,60,0,0,1\nGOTO/20,0,60,.6,0,.8\n", True)):
            for name in MACHINES[:2]:
                with self.subTest(way=way, machine=name):
                    self.compare(head + way + "FINI\n", name)
                    self.write("pole.apt", head + way + "FINI\n")
                    self.assertExit(0, "compile", "pole.apt", "--to", "ngc", "-o", "-", "--machine", "machine.toml")
                    self.assertEqual("warning[W0692]" in self.err, standing, self.err)

    def test_holes_square_to_a_slope(self):
        text = ("CUTTER/6\nMULTAX/ON\nSPINDL/900,CLW\nFROM/0,0,90,0,0,1\nRAPID\nGOTO/0,0,60,0,0,1\nCYCLE/DRILL,8,MMPM,90,2\n"
                "GOTO/10,0,20,.6,0,.8\nGOTO/10,12,20,.6,0,.8\nCYCLE/OFF\nRAPID\nGOTO/0,0,90,0,0,1\nFINI\n")
        machine = turning.Machine(PROJECT / "stdlib" / "machines" / "mill5_table_table.machine.toml")
        calls = self.interpret(text, "--machine", "mill5_table_table.machine.toml")
        bottoms = [machine.pose(m.end, m.axes) for m in paths.canonical_moves(calls) if m.feed is not None]
        for y in (0, 12):  # 8 mm along the tool axis
            goal = numpy.array([10 - 8 * 0.6, y, 20 - 8 * 0.8])
            self.assertTrue(any(numpy.linalg.norm(end - goal) < 1e-3 and numpy.allclose(axis, (0.6, 0, 0.8), atol=1e-5)
                                for end, axis in bottoms), bottoms)


if __name__ == "__main__":
    unittest.main()
