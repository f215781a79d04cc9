"""RS-274 outputs, judged by the interpreter of LinuxCNC: every canonical call against the CL."""
import contextlib
import io
import math
import os
import pathlib
import re
import sys
import tempfile
import unittest
from unittest import mock

from arelem_run import ARELEM, PROJECT, ArelemCase

sys.path.insert(0, str(PROJECT / "tests" / "ngc"))
import path as paths  # noqa: E402
from examples import REFUSED  # noqa: E402
import rs274  # noqa: E402

RESOLUTION = 1.5e-4  # half of the last digit in each axis, of the output and of the interpreter's print
NUMBER = re.compile(r"[A-Z]-?\d+(\.\d+)?$")


class NgcCase(ArelemCase):
    @classmethod
    def setUpClass(cls):
        cls.interpreter = rs274.judge(pathlib.Path(ARELEM).resolve().parent)

    def interpret(self, text, *options, name="part"):
        source = self.write(f"{name}.apt", text)
        self.assertExit(0, "compile", source, "--to", "ngc", "-o", f"{name}.ngc", *options)
        program = self.folder / f"{name}.ngc"
        self.check_numbers(program.read_text())
        calls, error = self.interpreter.run(program, self.folder)
        self.assertEqual(error, "", program.read_text()[:2000])
        return calls

    def check_numbers(self, text):
        for line in text.splitlines():
            self.assertLessEqual(len(line), 255)
            if line.startswith("(") or line == "%":
                continue
            for word in line.split():
                self.assertRegex(word, NUMBER)
                self.assertNotRegex(word, r"-0+(\.0*)?$")

    def records(self, text, name="part"):
        source = self.write(f"{name}.apt", text)
        self.assertExit(0, "compile", source, "--to", "json", "-o", "-")
        return paths.cl_locations(self.out)


class WithoutInterpreter(unittest.TestCase):
    """On a developer's computer the tests are skipped and say so; CI, which sets the variable, fails."""

    def test_missing(self):
        nowhere = {"PATH": "", rs274.REQUIRED: ""}
        with tempfile.TemporaryDirectory() as build, mock.patch.dict(os.environ, nowhere):
            with contextlib.redirect_stderr(io.StringIO()) as told, self.assertRaises(unittest.SkipTest):
                rs274.judge(pathlib.Path(build))
            self.assertIn("SKIPPED: no RS-274 interpreter", told.getvalue())
            os.environ[rs274.REQUIRED] = "1"
            with contextlib.redirect_stderr(io.StringIO()) as told, self.assertRaises(rs274.Unavailable):
                rs274.judge(pathlib.Path(build))
            self.assertNotIn("SKIPPED", told.getvalue())

    def test_ci_requires_it(self):
        self.assertIn(f"export {rs274.REQUIRED}=1\n", (PROJECT / ".ci" / "run").read_text())


class EveryExample(NgcCase):
    def test_paths_agree(self):
        """All examples as they stand; those whose guns tilt need turning axes, which test_turning gives them."""
        files = sorted((PROJECT / "examples").glob("*.apt"))
        self.assertTrue(files)
        arcs = 0
        for file in files:
            with self.subTest(file.name):
                text = file.read_text()
                code, why = REFUSED.get(file.name, (None, None))
                if code is not None:
                    self.assertExit(6, "compile", file, "--to", "ngc", "-o", "refused.ngc")
                    self.assertIn(f"error[{code}]", self.err, why)
                    self.assertFalse((self.folder / "refused.ngc").exists())
                    continue
                moves = paths.canonical_moves(self.interpret(text))
                arcs += sum(m.arc is not None for m in moves)
                self.assertEqual(paths.compare(moves, self.records(text), RESOLUTION, 0.0021), [])
        self.assertGreater(arcs, 0)


ROUND = "PARTNO ROUND\nCUTTER/0\nTOLER/.001\nFEDRAT/200\nFROM/0,0,5\nC1=CIRCLE/0,0,20\nL1=LINE/0,0,1,0\n" \
        "RAPID,GOTO/20,0,5\nGOTO/20,0,0\nINDIRV/0,1,0\nTLON,GOFWD/C1,ON,3,INTOF,L1\nFINI\n"


class Features(NgcCase):
    def test_circle_is_arcs(self):
        calls = self.interpret(ROUND)
        moves = paths.canonical_moves(calls)
        arcs = [m for m in moves if m.arc is not None]
        self.assertGreaterEqual(len(arcs), 1)
        self.assertLess(len(moves), 12)
        self.assertEqual(paths.compare(moves, self.records(ROUND), RESOLUTION, 0.0021), [])

    def test_words(self):
        text = ("PARTNO WORDS (A)\nUNITS/MM\nCUTTER/6\nLOADTL/2\nSPINDL/1200,CCLW\nCOOLNT/MIST\nFROM/0,0,50\nRAPID\n"
                "GOTO/10,0,5\nFEDRAT/120\nGOTO/10,0,0\nDELAY/1.5\nSTOP\nOPSTOP\nCOOLNT/OFF\nSPINDL/OFF\nEND\nFINI\n")
        calls = self.interpret(text)
        names = [name for name, _ in calls]
        for wanted in ("CHANGE_TOOL", "START_SPINDLE_COUNTERCLOCKWISE", "MIST_ON", "DWELL", "PROGRAM_STOP",
                       "OPTIONAL_PROGRAM_STOP", "STOP_SPINDLE_TURNING", "PROGRAM_END"):
            self.assertIn(wanted, names)
        self.assertIn(("DWELL", ["1.5000"]), calls)
        self.assertIn(("SET_SPINDLE_SPEED", ["0", "1200.0000"]), calls)
        self.assertEqual(paths.compare(paths.canonical_moves(calls), self.records(text), RESOLUTION, 0.0), [])

    CYCLES = ("CUTTER/6\nSPINDL/1000,CLW\nFROM/0,0,50\nRAPID\nGOTO/0,0,20\nCYCLE/DRILL,8,MMPM,90,2\nGOTO/10,0,0\n"
              "GOTO/20,5,0\nCYCLE/OFF\nCYCLE/DRILL,4,MMPM,80,2,DWELL,.5\nGOTO/30,0,0\nCYCLE/OFF\n"
              "CYCLE/DEEP,9,MMPM,70,2,STEP,4\nGOTO/40,0,0\nCYCLE/OFF\nCYCLE/BRKCHP,9,MMPM,60,2,STEP,4\nGOTO/50,0,0\n"
              "CYCLE/OFF\nCYCLE/BORE,6,MMPM,50,2\nGOTO/60,0,0\nCYCLE/OFF\nRAPID\nGOTO/0,0,50\nFINI\n")
    # Hole bottoms, and for the boring cycle the way out again at the feed.
    HOLES = (((10, 0, -8), 90), ((20, 5, -8), 90), ((30, 0, -4), 80), ((40, 0, -4), 70), ((40, 0, -8), 70),
             ((40, 0, -9), 70), ((50, 0, -9), 60), ((60, 0, -6), 50), ((60, 0, 2), 50))

    def check_holes(self, calls):
        moves = paths.canonical_moves(calls)
        for place, feed in self.HOLES:
            near = [m for m in moves if m.feed is not None and paths.distance(m.end, place) < 3]
            self.assertTrue(any(abs(m.feed - feed) < 1e-3 and m.end[:2] == place[:2] for m in near), (place, feed))
        bottoms = [m.end for m in moves if m.feed is not None]
        for place in (h[0] for h in self.HOLES if h[0] not in ((40, 0, -4), (40, 0, -8))):
            self.assertTrue(any(paths.distance(place, b) < 1e-4 for b in bottoms), place)
        for move in moves:  # never across a hole below its clearance, never rapid into fresh material
            if move.end[:2] != move.start[:2]:
                self.assertGreaterEqual(min(move.start[2], move.end[2]), 2 - 1e-9, move.end)
        self.assertIn(("DWELL", ["0.5000"]), calls)

    def test_canned_cycles(self):
        self.check_holes(self.interpret(self.CYCLES, "--dialect", "cl"))
        text = (self.folder / "part.ngc").read_text()
        for code in ("G81", "G82", "G83", "G73", "G85"):
            self.assertIn(code + " ", text)

    def test_height_between_holes(self):
        # RAPTO is where the feed begins, RTRCTO the height on the way to the next hole; the third hole lies 5 higher.
        text = ("CUTTER/6\nFROM/0,0,80\nCYCLE/{},MMPM,100,RAPTO,3,RTRCTO,30\nGOTO/10,0,0\nGOTO/20,0,0\nGOTO/30,0,5\n"
                "CYCLE/OFF\nRAPID\nGOTO/0,0,50\nFINI\n")
        self.write("plain.toml", "[control]\ncycles = false\n")
        for options in ((), ("--machine", "plain.toml")):
            moves = paths.canonical_moves(self.interpret(text.format("DRILL,FEDTO,10"), "--dialect", "cl", *options))
            feeds = [(m.start, m.end) for m in moves if m.feed is not None]
            self.assertEqual(feeds, [((10, 0, 3), (10, 0, -10)), ((20, 0, 3), (20, 0, -10)), ((30, 0, 8), (30, 0, -5))])
            across = [(m.start[2], m.end[2]) for m in moves if m.start[0] != m.end[0] and m.end[0] in (20, 30)]
            self.assertEqual(across, [(30, 30), (35, 35)])
            self.assertEqual([m for m in moves if m.feed is None and m.end[2] < 3], [])
        # CAMWorks writes ON before each cycle; ON alone is none.
        self.interpret(text.replace("CYCLE/{}", "CYCLE/ ON\nCYCLE/{}").format("DRILL,FEDTO,10"), "--dialect", "cl")
        self.write("on.apt", "FROM/0,0,80\nFEDRAT/9\nCYCLE/ON\nGOTO/1,2,3\nCYCLE/OFF\nFINI\n")
        self.assertExit(6, "compile", "on.apt", "--dialect", "cl", "--to", "ngc")
        self.assertIn("E0673", self.err)
        pecks = paths.canonical_moves(self.interpret(text.format("DRILL,G98,12,PECKING,5,4").replace("RAPTO,3,RTRCTO,30", "3,30 30 DWELL,0"),
                                                     "--dialect", "cl"))
        self.assertIn("G98 G83 X10.0000 Y0.0000 Z-12.0000 R3.0000 Q4.0000", (self.folder / "part.ngc").read_text())
        self.assertIn((10, 0, 30), [m.end for m in pecks])

    def test_a_cycle_keeps_its_feed_to_itself(self):
        text = ("CUTTER/6\nSPINDL/1000,CLW\nFROM/0,0,50\n{}CYCLE/{},3\nGOTO/10,0,0\nCYCLE/OFF\nGOTO/40,0,3\n"
                "RAPID\nGOTO/0,0,50\nFINI\n")
        self.write("plain.toml", "[control]\ncycles = false\n")
        for options in ((), ("--machine", "plain.toml")):
            for cycle in ("DRILL,8,MMPM,50", "DRILL,8,MMPR,.1", "DRILL,DEPTH,8,CLEAR"):
                moves = paths.canonical_moves(self.interpret(text.format("FEDRAT/600\n", cycle), "--dialect", "cl", *options))
                self.assertEqual([m.feed for m in moves if m.end == (40, 0, 3)], [600], cycle)
            self.write("p.apt", text.format("", "DRILL,8,MMPM,50"))
            self.assertExit(6, "compile", "p.apt", "--dialect", "cl", "-o", "q.ngc", *options)
            self.assertIn("E0671", self.err)
        inside = text.format("FEDRAT/600\n", "DRILL,8,MMPM,50").replace("CYCLE/OFF", "FEDRAT/700\nCYCLE/OFF")
        moves = paths.canonical_moves(self.interpret(inside, "--dialect", "cl"))
        self.assertEqual([m.feed for m in moves if m.end == (40, 0, 3)], [700])

    def test_tapping(self):
        for way, code, back in (("CLW", "G84", "COUNTERCLOCKWISE"), ("CCLW", "G74", "CLOCKWISE")):
            text = (f"CUTTER/6\nSPINDL/400,{way}\nFROM/0,0,50\nCYCLE/TAP,12,MMPR,1.25,3\nGOTO/10,0,0\nGOTO/20,0,0\nCYCLE/OFF\n"
                    "RAPID\nGOTO/0,0,50\nFINI\n")
            calls = self.interpret(text, "--dialect", "cl")
            self.assertIn(f"{code} X10.0000 Y0.0000 Z-12.0000 R3.0000 G95 F1.2500", (self.folder / "part.ngc").read_text())
            moves = [m for m in paths.canonical_moves(calls) if m.feed is not None]
            # Down and, with the spindle turning back, up again at the same feed, in both holes.
            self.assertEqual([m.end for m in moves], [(10, 0, -12), (10, 0, 3), (20, 0, -12), (20, 0, 3)])
            self.assertEqual(sum(name == f"START_SPINDLE_{back}" for name, _ in calls), 2)
        self.write("plain.toml", "[control]\ncycles = false\n")
        self.write("p.apt", text)
        self.assertExit(6, "compile", "p.apt", "--dialect", "cl", "--machine", "plain.toml", "-o", "q.ngc")
        self.assertIn("E0673", self.err)

    def test_cycles_one_by_one(self):
        self.write("plain.toml", "[control]\ncycles = false\n")
        self.check_holes(self.interpret(self.CYCLES, "--dialect", "cl", "--machine", "plain.toml"))
        self.assertNotRegex((self.folder / "part.ngc").read_text(), r"G8[1-9]|G73")

    def test_inches_line_numbers_and_blend(self):
        self.write("inch.toml", "[control]\nunits = 'inch'\nline_numbers = true\nblend = 0.02\nend = 'M30'\noffset = 'G55'\n")
        moves = paths.canonical_moves(self.interpret(ROUND, "--machine", "inch.toml"))
        self.assertEqual(paths.compare(moves, self.records(ROUND), 2.3e-3, 0.005), [])  # the interpreter prints 1e-4 inch
        text = (self.folder / "part.ngc").read_text()
        for words in ("G20 ", "G55\n", "M30\n", "G64 P0.00079 Q0.00039", "\nN10 "):
            self.assertIn(words, text)

    def test_arcs_in_three_planes_and_helix(self):
        def ring(u, v, w, rise):
            points = []
            for i in range(41):
                p, a = [0.0, 0.0, 0.0], 0.07 * i
                p[u], p[v], p[w] = 15 * math.cos(a), 15 * math.sin(a), rise * i
                points.append(p)
            return points
        for (u, v, w), plane in zip(((0, 1, 2), (2, 0, 1), (1, 2, 0)), ("G17", "G18", "G19")):
            for rise in (0.0, 0.05):
                points = ring(u, v, w, rise)
                say = lambda word, numbers: word + "/" + ",".join(f"{x:.9f}" for x in numbers) + "\n"
                text = ("CUTTER/6\nTOLER/.05\n" + "".join(say(f"P{i}=POINT", p) for i, p in enumerate(points)) +
                        "ROW=PATERN/RANDOM," + ",$\n".join(f"P{i}" for i in range(1, 41)) +
                        "\nFROM/0,0,90\nFEDRAT/200\nGOTO/P0\nGOTO/ROW\nFINI\n")
                with self.subTest(plane, rise=rise):
                    moves = paths.canonical_moves(self.interpret(text, "--fit", ".5"))
                    self.assertIn(plane, (self.folder / "part.ngc").read_text())
                    self.assertTrue(any(m.arc is not None for m in moves))
                    self.assertEqual(paths.compare(moves, self.records(text), RESOLUTION, 0.0126), [])

    def test_feed_modes(self):
        text = ("CUTTER/6\nSPINDL/500,CLW\nFROM/0,0,0\nFEDRAT/100,MMPM\nGOTO/10,0,0\nFEDRAT/.2,MMPR\nGOTO/20,0,0\nFEDRAT/5,MMPS\n"
                "GOTO/30,0,0\nFEDRAT/4,INVERS\nGOTO/50,0,0\nFEDRAT/2,IPM\nGOTO/60,0,0\nFINI\n")
        self.interpret(text, "--dialect", "cl")
        program = (self.folder / "part.ngc").read_text()
        for line in ("X10.0000 Y0.0000 Z0.0000 F100.0000", "X20.0000 G95 F0.2000", "X30.0000 G94 F300.0000", "X50.0000 G93 F4.0000",
                     "X60.0000 G94 F50.8000"):
            self.assertIn(line + "\n", program)

    OFFSET = ("CUTTER/{}\nFEDRAT/200\nLOADTL/{}\nFROM/-20,-20,0\nCUTCOM/LEFT\nGOTO/-10,0,0\nGOTO/20,0,0\nINDIRV/1,0,0\n"
              "C1=CIRCLE/20,15,15\nL1=LINE/20,15,20,50\nTLON,GOFWD/C1,ON,2,INTOF,L1\nCUTCOM/OFF\nGOTO/20,60,0\nFINI\n")

    def test_compensation(self):
        """Register 31 of the table is empty: the path of a new tool is that of the CL. Register 4 holds a radius."""
        text = self.OFFSET.format(0, 31)
        calls = self.interpret(text)
        moves = paths.canonical_moves(calls)
        self.assertEqual(paths.compare(moves, self.records(text), RESOLUTION, 0.0021), [])
        self.assertTrue(any(m.arc is not None for m in moves))
        program = (self.folder / "part.ngc").read_text()
        self.assertRegex(program, r"\nG41 D31 G1 X-10\.0000 Y0\.0000")
        self.assertRegex(program, r"\nG40 G1 (X20\.0000 )?Y60\.0000")
        self.assertNotIn("W0693", self.err)
        radius = 1.5 * 25.4  # of the table, which is in inches
        text = self.OFFSET.format(0, 4).replace("-20,-20", "-120,-120").replace("-10,0", "-60,0")
        text = text.replace("CIRCLE/20,15,15", "CIRCLE/20,60,60").replace("LINE/20,15,20,50", "LINE/20,60,20,90")
        text = text.replace("GOTO/20,60,0", "GOTO/20,200,0")
        moves = paths.canonical_moves(self.interpret(text))
        self.assertTrue(any(abs(m.end[1] - radius) < 1e-3 for m in moves), [m.end for m in moves])
        self.interpret(self.OFFSET.format(6, 31))
        self.assertIn("warning[W0693]", self.err)
        self.assertIn("(D31: WEAR ONLY, THE PATH IS OF CUTTER 6)", (self.folder / "part.ngc").read_text())

    def test_codes_of_the_control_and_tool_offsets(self):
        calls = self.interpret("CUTTER/6\nLOADTL/3,ADJUST,4\nFROM/0,0,50\nFEDRAT/100\nGOTO/1,0,0\nAUXFUN/8\nPREFUN/61\n"
                               "INSERT M9\nGOTO/2,0,0\nFINI\n", "--dialect", "cl")
        program = (self.folder / "part.ngc").read_text()
        self.assertIn("T3 M6\nG43 H4\n", program)
        names = [name for name, _ in calls]
        self.assertIn("FLOOD_ON", names)
        self.assertIn("FLOOD_OFF", names)

    def test_outputs_switch_with_the_next_move(self):
        calls = self.interpret("CUTTER/6\nFROM/0,0,50\nFEDRAT/100\nGOTO/1,0,0\nSPRAY/ON,2\nGOTO/2,0,0\nSPRAY/OFF,2\nGOTO/3,0,0\nFINI\n",
                               "--dialect", "cl")
        names = [name for name, _ in calls]
        self.assertIn("SET_MOTION_OUTPUT_BIT", names)
        self.assertIn("CLEAR_MOTION_OUTPUT_BIT", names)

    def test_refusals(self):
        head = "CUTTER/6\nFROM/0,0,50\n"
        for code, text in (("E0671", "GOTO/1,0,0\n"), ("E0674", "FEDRAT/.1,MMPR\nGOTO/1,0,0\n"),
                           ("E0669", "FEDRAT/9\nGOTO/1,0,0\nEND\nGOTO/2,0,0\n"), ("E0688", "FEDRAT/9\nGOTO/1E9,0,0\n"),
                           ("E0670", "SPINDL/100,SFM\n"), ("E0673", "FEDRAT/9\nCYCLE/TAP,9,MMPM,80,2\nGOTO/1,0,0\n"),
                           ("E0673", "FEDRAT/9\nCYCLE/MILL,9,MMPM,80,2\nGOTO/1,0,0\n"),
                           ("E0673", "FEDRAT/9\nCUTCOM/LEFT,2\nCYCLE/DRILL,9,MMPM,80,2\nGOTO/1,0,0\n")):
            with self.subTest(code):
                source = self.write("p.apt", head + text + "FINI\n")
                self.assertEqual(self.run_arelem("compile", source, "--dialect", "cl", "--to", "ngc", "-o", "p.ngc"), 6)
                self.assertIn(f"error[{code}]", self.err)
                self.assertFalse((self.folder / "p.ngc").exists())


if __name__ == "__main__":
    unittest.main()
