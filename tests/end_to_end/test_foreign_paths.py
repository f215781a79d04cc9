"""`arelem verify PART CL` of files that another system may have written: plain CL text, arcs, other units, other cutters."""
import math
import random
import re
import unittest

from arelem_run import ArelemCase
from test_certify import SPHERE

# The path turns sharply within the check surface and leaves it with a short cut vector.
SHARP = """CUTTER/0.5,0.112030029296875,0.137969970703125,0.112030029296875,0,0,4
INTOL/0
OUTTOL/0.01
MAXDP/1
PS1=TORUS/-0.88037109375,-8.0107421875,-2.91845703125,0,0.040185546875000006,1,7.8583984375,3
DS1=TORUS/-0.55859375,-11.746337890625,-0.1494140625,0.06630859375,-0.03544921875,1,9.010498046875,2.5
CS1=PLANE/0.9746320007082999,-0.19092888607625488,-0.1167845180536215,3.869498436405853
FROM/-7.15,2.55,6.25
GO/PAST,DS1,TO,PS1,ON,(PLANE/1,0,0,-4.25)
INDIRV/1,0,0
TLLFT,GOFWD/DS1,PAST,CS1
FINI
"""


def chain_of_arcs(seed):
    """A contour of a line, arcs that turn either way, and a line, each tangent to the next."""
    r = random.Random(seed)
    radius = r.choice((1, 3, 5))
    x, y, course = r.uniform(10, 40), 0.0, 0.0
    surfaces = [f"LINE/-50,{-radius},50,{-radius}"]
    for _ in range(r.randint(2, 5)):
        turn, angle, bend = r.choice((1, -1)), r.uniform(0.4, 1.8), r.uniform(radius + 3, 40)
        center = x - turn * bend * math.sin(course), y + turn * bend * math.cos(course)
        surfaces.append(f"CIRCLE/{center[0]!r},{center[1]!r},{bend + turn * radius!r}")
        course += turn * angle
        x, y = center[0] + turn * bend * math.sin(course), center[1] - turn * bend * math.cos(course)
    along, across = (math.cos(course), math.sin(course)), (math.sin(course), -math.cos(course))
    edge = x + radius * across[0], y + radius * across[1]
    surfaces.append(f"LINE/{edge[0]!r},{edge[1]!r},{edge[0] + along[0]!r},{edge[1] + along[1]!r}")
    x, y = x + 30 * along[0], y + 30 * along[1]
    lines = [f"S{i}={s}" for i, s in enumerate(surfaces)]
    motions = [f"GOFWD/S{i},TANTO,S{i + 1}" for i in range(len(surfaces) - 1)]
    return "\n".join([f"CUTTER/{2 * radius}", f"OUTTOL/{r.choice(('.001', '.0005', '.01'))}", *lines,
                      f"LF=LINE/{x!r},{y!r},{x + across[0]!r},{y + across[1]!r}", "FROM/-5,0,0", "INDIRV/0,-1,0",
                      "GO/TO,S0,TO,(PLANE/0,0,1,0)", "INDIRV/1,0,0", "TLLFT", *motions,
                      f"GOFWD/S{len(surfaces) - 1},ON,LF", "FINI", ""]), (x, y)


class ForeignPaths(ArelemCase):
    def test_tangent_motions_of_plain_text_end_where_their_chords_leave_the_band(self):
        for seed in range(60):
            program, (x, y) = chain_of_arcs(seed)
            with self.subTest(seed=seed, program=program):
                self.write("c.apt", program)
                self.assertExit(0, "c.apt", "--to", "cl", "-o", "c.cls")
                end = (self.folder / "c.cls").read_text().split("GOTO /")[-1].split("\n")[0].split(",")
                self.assertAlmostEqual(float(end[0]), x, delta=0.01)
                self.assertAlmostEqual(float(end[1]), y, delta=0.01)
                self.assertExit(0, "verify", "c.apt", "c.cls")

    def test_a_stop_is_the_one_that_is_counted(self):
        program = """CUTTER/10
OUTTOL/.001
L=LINE/0,0,1,0
C=CIRCLE/60,0,12
FROM/0,10,0
GO/TO,L,TO,(PLANE/0,0,1,0)
INDIRV/1,0,0
TLLFT,GOFWD/L,%s,C
GOTO/0,0,50
FINI
"""
        stops = ("ON", "ON,2,INTOF", "TO", "PAST", "TO,2,INTOF", "PAST,2,INTOF")
        for asked in stops:
            for cut in stops:
                with self.subTest(asked=asked, cut=cut):
                    self.write("cut.apt", program % cut)
                    self.assertExit(0, "cut.apt", "-o", "cut.jsonl", "-o", "cut.cls")
                    self.write("asked.apt", program % asked)
                    for output in ("cut.jsonl", "cut.cls"):
                        self.assertExit(0 if asked == cut else 5, "verify", "asked.apt", output)
        self.write("asked.apt", program % "ON")
        self.write("cut.apt", program % "ON,2,INTOF")
        self.assertExit(0, "cut.apt", "-o", "cut.jsonl")
        self.assertExit(5, "verify", "asked.apt", "cut.jsonl")
        self.assertRegex(self.err, r"asked.apt:8:1: error\[E0919\]: the path passes its stop ON `C` before \(49\.")
        self.assertExit(0, "asked.apt", "-o", "cut.jsonl")
        self.assertExit(5, "verify", "cut.apt", "cut.jsonl")
        self.assertIn("error[E0928]: the motion ends at stop 1 ON `C`; the program asks for stop 2", self.err)

    def test_a_stop_behind_a_sharp_turn_is_of_one_side(self):
        self.write("w.apt", SHARP)
        self.assertExit(0, "compile", "w.apt", "-o", "w.jsonl")
        self.assertExit(0, "verify", "w.apt", "w.jsonl")
        self.write("w.apt", SHARP.replace("PAST,CS1", "TO,CS1"))
        self.assertExit(5, "verify", "w.apt", "w.jsonl")
        self.assertIn("w.apt:11:1: error[E0907]: the motion ends -0.9514 from the position TO check surface `CS1`", self.err)

    def test_a_stop_that_was_moved_is_told_as_such_in_plain_text(self):
        """Without statement numbers a motion goes on to its check surface; where the path leaves its surfaces before, for good, it
        ended there."""
        self.write("s.apt", SPHERE)
        self.assertExit(0, "compile", "s.apt", "--to", "cl", "--decimals", "7")
        whole = self.out
        last = [line for line in whole.splitlines() if line.startswith("GOTO")][-2]
        self.write("s.cls", whole.replace(last, f"GOTO / 5.9, 0.0, {math.sqrt(100 - 5.9 ** 2) - 1:.7f}"))
        self.assertEqual(self.run_arelem("verify", "s.apt", "s.cls"), 5)
        self.assertIn("s.apt:12:1: error[E0907]: the motion ends -0.1 from the position ON check surface `L3`", self.err)
        self.assertEqual(self.err.count("error["), 1, self.err)
        walls = ("CUTTER/10\nTOLER/.01\nL1=LINE/0,0,100,0\nW=LINE/50,0,50,-100\nL3=LINE/0,-50,100,-50\nFROM/0,-20,0\n"
                 "GO/TO,L1,TO,(PLANE/0,0,1,0),ON,(LINE/0,0,0,9)\nINDIRV/1,0,0\nTLRGT,GOFWD/L1,TO,W\nGORGT/W,TO,L3\nGOTO/0,0,20\nFINI\n")
        self.write("w.apt", walls)
        places = ["FROM/0,-20,0", "GOTO/0,-5,0", "GOTO/45.4,-5,0", "GOTO/45,-45,0", "GOTO/0,0,20", "FINI", ""]
        self.write("w.cls", "\n".join(places))
        self.assertEqual(self.run_arelem("verify", "w.apt", "w.cls"), 5)
        self.assertIn("w.apt:9:1: error[E0907]: the motion ends -0.4 from the position TO check surface `W`", self.err)
        self.assertIn("w.apt:10:1: error[E0904]: the cutter is 0.4 inside `W` at (45.4, -5, 0) on cut vector 1", self.err)
        self.assertEqual(self.err.count("error["), 2, self.err)
        # A place that is displaced between others is none: the motion goes on behind it.
        places[2:3] = ["GOTO/20,-5,0", "GOTO/30,-4.7,0", "GOTO/45,-5,0"]
        self.write("w.cls", "\n".join(places))
        self.assertEqual(self.run_arelem("verify", "w.apt", "w.cls"), 5)
        self.assertIn("w.apt:9:1: error[E0904]: the cutter is 0.3 inside `L1` at (30, -4.7, 0) on cut vector 2", self.err)
        self.assertEqual(self.err.count("error["), 1, self.err)

    def test_arcs_of_a_file_are_judged_themselves(self):
        """A CIRCLE over a sphere of radius 9 with a ball of radius 1: its radius says where in the band of .001 either way it is.
        In it chords of a whole band would leave the tolerance."""
        self.write("s.apt", SPHERE)

        def at(radius):
            z = math.sqrt(radius ** 2 - 36) - 1
            self.write("s.cls", f"FROM/-8,0,9\nGOTO/-6,0,{z:.9f}\nCIRCLE/0,0,-1,0,1,0,{radius:.9f}\nGOTO/6,0,{z:.9f}\nGOTO/8,0,9\nFINI\n")
            return self.run_arelem("verify", "s.apt", "s.cls")

        for radius in (10, 9.9991, 10.0009, 9.999, 10.001):
            self.assertEqual(at(radius), 0, f"{radius} {self.out}{self.err}")
        for radius, code in ((9.99899, "E0904"), (10.00101, "E0905")):
            self.assertEqual(at(radius), 5)
            self.assertIn(f"error[{code}]: the cutter is 0.00101 ", self.err)

    def test_lengths_of_a_file_are_converted_to_the_unit_of_its_program(self):
        part = self.write("s.apt", "UNITS/MM\n" + SPHERE)
        self.assertExit(0, "compile", part, "-o", "s.cls")
        text = (self.folder / "s.cls").read_text()

        def scaled(line, factor):
            word, _, rest = line.partition(" / ")
            if word not in ("FROM", "GOTO", "CUTTER", "INTOL", "OUTTOL"):
                return line
            return f"{word} / " + ", ".join(repr(float(v) * factor) for v in rest.split(","))
        inches = "\n".join(scaled(line, 1 / 25.4) for line in text.replace("UNITS / MM", "UNITS / INCHES").splitlines()) + "\n"
        self.write("inch.cls", inches)
        for words in (("verify", part, "inch.cls"), ("verify", "inch.cls", "--with", part)):
            self.assertExit(0, *words)
            self.assertNotIn("W09", self.err)
        # The same numbers under another unit are another path.
        self.write("wrong.cls", text.replace("UNITS / MM", "UNITS / INCHES"))
        self.assertExit(5, "verify", part, "wrong.cls")
        self.assertExit(5, "verify", "wrong.cls", "--with", part)
        # A program without a unit cannot be converted to.
        self.write("bare.apt", SPHERE)
        self.assertExit(0, "verify", "bare.apt", "s.cls")
        self.assertIn("W0917", self.err)

    def test_a_file_for_another_cutter_is_told(self):
        part = self.write("s.apt", SPHERE)
        self.assertExit(0, "compile", part, "-o", "s.cls")
        text = (self.folder / "s.cls").read_text()
        self.assertExit(0, "verify", part, "s.cls")
        self.assertNotIn("W0918", self.err)
        for other in ("CUTTER / 4.0, 1.0", "CUTTER / 2.0"):
            self.write("t.cls", re.sub("CUTTER / .*", other, text))
            self.assertExit(0, "verify", part, "t.cls")
            self.assertIn("t.cls:", self.err)
            self.assertIn("W0918", self.err)

    def test_long_ways_in_a_lying_hole_are_decided(self):
        """A flat cutter of radius 2 in a hole of radius 5 along x, 1000 long: its rim touches at z = -sqrt(21), on each cut vector of
        ten exactly at the limit."""
        self.write("h.apt", "CUTTER/4\nINTOL/0\nOUTTOL/.001\nNUMPTS/1000\nHOLE=CYLNDR/0,0,0,1,0,0,5\nDS=PLANE/0,1,0,0\nFROM/0,0,-4\n"
                   "GO/ON,DS,TO,HOLE,ON,(PLANE/1,0,0,0)\nINDIRV/1,0,0\nTLON,GOFWD/DS,ON,(PLANE/1,0,0,1000)\nFINI\n")
        self.assertExit(0, "verify", "h.apt")
        z = -math.sqrt(21)
        for places, code in ((((0, z), (1000, z)), 0), (((0, z), (500, z - 2e-5), (1000, z)), 5)):
            lines = ["FROM/0,0,-4", *(f"GOTO/{x},0,{height:.9f}" for x, height in places), "FINI", ""]
            self.write("h.cls", "\n".join(lines))
            self.assertEqual(self.run_arelem("verify", "h.apt", "h.cls"), code, self.err)
        self.assertIn("h.apt:10:1: error[E0904]: the cutter is 1.8", self.err)

    def test_the_top_face_of_a_cutter_does_not_cut(self):
        """A flat cutter of radius 1 below a surface of radius 100: half way its top face still touches, its edge is sqrt(1 + 100^2) - 100 =
        .004999875 off. Where it begins off the middle and .001 higher, its edge goes .001 deep under the lowest place."""
        for surface in ("SPHERE/0,0,105,100", "QADRIC/1,1,1,0,0,0,0,0,-210,1025"):
            for x, z, tolerance, end, error in ((-1, 0, .004, 1, "E0905]: the cutter is 0.005 off `S`"), (-1, 0, .00501, 1, None),
                                                (-.3, .001, .01, 1.7, "E0904]: the cutter is 0.00"), (-.3, -1e-6, .01, 1.7, None)):
                part = self.write("t.apt", f"CUTTER/2\nINTOL/0\nOUTTOL/{tolerance}\nS={surface}\nDS=LINE/0,0,1,0\nFROM/{x},0,-5\n"
                                           f"GO/ON,DS,TO,S,ON,(PLANE/1,0,0,{x})\nINDIRV/1,0,0\nTLON,GOFWD/DS,ON,(PLANE/1,0,0,{end})\nFINI\n")
                self.write("t.cls", f"FROM/{x},0,-5\nGOTO/{x},0,{z}\nGOTO/{end},0,{z}\nFINI\n")
                with self.subTest(surface=surface, x=x, tolerance=tolerance):
                    self.assertEqual(self.run_arelem("verify", part, "t.cls"), 5 if error else 0, self.err)
                    self.assertIn(error or "", self.err)
                    self.assertExit(0, "verify", part)

    def test_a_last_cut_vector_shorter_than_the_tolerance_of_its_stop(self):
        """Across the top of a torus; a location .0053 before the stop, within the .01 that it has, divides the last cut vector."""
        part = self.write("t.apt", "S=TORUS/0,0,-20,0,0,1,60,20\nCUTTER/6\nTOLER/.01\nDS=PLANE/.2,1,0,12\nFROM/48,2.4,60\n"
                                   "GO/ON,DS,TO,S,ON,(PLANE/1,0,0,48)\nINDIRV/1,0,0\nTLON,GOFWD/DS,ON,(PLANE/1,0,0,72)\nFINI\n")
        self.assertExit(0, "compile", part, "-o", "t.cls")
        lines = (self.folder / "t.cls").read_text().splitlines()
        last = max(i for i, line in enumerate(lines) if line.startswith("GOTO"))
        before, end = ([float(x) for x in lines[i].split("/")[1].split(",")] for i in (last - 1, last))
        self.assertAlmostEqual(end[0], 72, delta=1e-9)
        share = 0.0053 / (end[0] - before[0])
        lines.insert(last, "GOTO / " + ", ".join(repr(e + share * (b - e)) for b, e in zip(before, end)))
        last += 1
        self.write("t.cls", "\n".join(lines) + "\n")
        self.assertExit(0, "verify", part, "t.cls")
        # Without the last one the motion still ends within its tolerance; one more location is too much.
        self.write("short.cls", "\n".join(lines[:last] + lines[last + 1:]) + "\n")
        self.assertExit(0, "verify", part, "short.cls")
        self.write("more.cls", "\n".join(lines[:last + 1] + ["GOTO / 73.0, -2.6, -2.9"] + lines[last + 1:]) + "\n")
        self.assertExit(5, "verify", part, "more.cls")
        self.assertIn("E0911", self.err)


if __name__ == "__main__":
    unittest.main()
