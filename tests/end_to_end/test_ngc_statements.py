"""What RS-274 makes of the statements for the machine: each parameter is written or told. Needs no interpreter."""
import unittest

from arelem_run import ArelemCase

HEAD = "PARTNO T\nCUTTER/2\nFROM/0,0,0\n"
TAIL = "\nFEDRAT/100\nGOTO/1,0,0\nFINI\n"

# Statements, and the lines they become.
WRITTEN = {
    "SPINDL/1000,CLW": ["S1000.0 M3"],
    "SPINDL/RPM,1000,CCLW": ["S1000.0 M4"],
    "SPINDL/1000,CCW": ["S1000.0 M4"],
    "SPINDL/1000,RPM,CW": ["S1000.0 M3"],
    "SPINDL/800\nSPINDL/OFF\nSPINDL/ON": ["S800.0 M3", "M5", "M3"],
    "SPINDL/800,CCLW\nSPINDL/900": ["S800.0 M4", "S900.0 M4"],
    "SPINDL/-200": ["S200.0 M4"],
    "SPINDL/-200,CCLW": ["S200.0 M4"],
    "COOLNT/ON": ["M8"],
    "COOLNT/MIST,ON": ["M7"],
    "COOLNT/MIST,FLOOD": ["M7", "M8"],
    "COOLNT/OFF": ["M9"],
    "SPINDL/600\nDELAY/3,REV": ["S600.0 M3", "G4 P0.300"],
    "DELAY/2": ["G4 P2.000"],
    "LOADTL/3,ADJUST,7": ["T3 M6", "G43 H7"],
    "LOADTL/6,1": ["T6 M6", "G43 H1"],
    "LOADTL/6,1\nLOADTL/6,2": ["T6 M6", "G43 H1", "G43 H2"],
    "LOADTL/6\nLOADTL/7\nLOADTL/6": ["T6 M6", "G43 H6", "T7 M6", "G43 H7", "T6 M6", "G43 H6"],
    "SELCTL/4": ["T4"],
}
# Statements, their lines and what the warning W0675 names: it stands in a comment.
PASSED = {
    "SPINDL/500,RPM,RANGE,2": (["S500.0 M3"], "SPINDL/RANGE,2"),
    "COOLNT/ON,TAPKUL": ([], "COOLNT/ON,TAPKUL"),
    "COOLNT/FLOOD,TAPKUL": (["M8"], "COOLNT/TAPKUL"),
    "LOADTL/3,SETOOL,4": (["T3 M6", "G43 H3"], "LOADTL/SETOOL,4"),
    "ROTABL/30": ([], "ROTABL/30"),
}
# Statements that no form fits, and what the error E0670 says of them.
REFUSED = {
    "SPINDL/BLAH,77": "`SPINDL/BLAH,77` cannot be written in RS-274: `BLAH` has no code",
    "SPINDL/300,SFM": "`SFM` has no code",
    "SPINDL/300,400": "`400` has no code",
    "SPINDL/ORIENT,90": "`ORIENT` has no code",
    "SPINDL/ON": "no speed came before it",
    "SPINDL/CLW": "no speed came before it",
    "SPINDL": "it has no speed",
    "SPINDL/0": "0 turns are no speed",
    "SPINDL/0,CLW": "0 turns are no speed",
    "SPINDL/-200,CLW": "a speed below 0 turns counterclockwise",
    "SPINDL/CW,-200": "a speed below 0 turns counterclockwise",
    "FEDRAT/100,FOO": "`FOO`: it takes one number",
    "FEDRAT/MMPM": "no number: it takes one number",
    "DELAY/3,FOO": "it takes the seconds to wait",
    "DELAY/3,REV": "the spindle has no speed",
    "DELAY/-1": "0 or more",
    "LOADTL/2.5": "whole number",
    "LOADTL/2,ADJUST,1.5": "ADJUST takes the whole number",
    "AUXFUN/1000": "one code from 0 to 999",
    "CUTCOM/LEFT": "no register, and no LOADTL",
    "CUTCOM/3": "no side",
    "CUTCOM/ON": "no LEFT or RIGHT came before it",
    "CUTCOM/LEFT,2.5": "a register is a whole number",
    "CUTCOM/LEFT,0": "a register is a whole number",
    "CUTCOM/LEFT,ZXPLAN,2": "`ZXPLAN` has no code",
    "CUTCOM/LEFT,2\nCUTCOM/RIGHT,2": "CUTCOM/OFF first",
    "CUTCOM/LEFT,2\nLOADTL/3": "changes tools without it",
}


class Statements(ArelemCase):
    def convert(self, statements):
        source = self.write("part.apt", HEAD + statements + TAIL)
        return self.run_arelem("compile", source, "--to", "ngc", "-o", "part.ngc")

    def lines(self):
        """The lines between the opening and FROM, and those between FROM and the move."""
        text = (self.folder / "part.ngc").read_text().splitlines()
        return text[text.index("(FROM 0 0 0)") + 1:next(i for i, t in enumerate(text) if t.startswith("G1 "))]

    def test_written(self):
        for statements, lines in WRITTEN.items():
            with self.subTest(statements):
                self.assertEqual(self.convert(statements), 0, self.err)
                self.assertEqual(self.lines(), lines)
                self.assertNotIn("W0675", self.err)

    def test_passed_on_as_comments(self):
        for statements, (lines, told) in PASSED.items():
            with self.subTest(statements):
                self.assertEqual(self.convert(statements), 0, self.err)
                self.assertEqual(self.lines(), [*lines, f"({told})"])
                self.assertIn(f"warning[W0675]: `{told}`", self.err)

    def test_refused(self):
        for statements, why in REFUSED.items():
            with self.subTest(statements):
                self.assertEqual(self.convert(statements), 6, self.err)
                self.assertIn("error[E0670]", self.err)
                self.assertIn(why, self.err)
                self.assertFalse((self.folder / "part.ngc").exists())

    def test_the_sign_of_a_depth(self):
        """A hole ends its depth below the location, written as a length or as a way down; 0 is none."""
        for depth, code in (("8", 0), ("-8", 0), ("0", 6)):
            source = self.write("part.apt", HEAD + f"FEDRAT/100\nCYCLE/DRILL,{depth},MMPM,90,2\nGOTO/1,1,0\nCYCLE/OFF\nFINI\n")
            self.assertExit(code, "compile", source, "--to", "ngc", "-o", "part.ngc", "--dialect", "cl")
            if code == 0:
                self.assertRegex((self.folder / "part.ngc").read_text(), r"G81 X1\.0+ Y1\.0+ Z-8\.0+ R2\.0+ ")
            else:
                self.assertIn("error[E0673]", self.err)

    def test_a_feed_is_above_zero_in_every_output(self):
        for feed in ("0", "-5", "0,MMPM", "MMPM,0"):
            for target in ("cl", "ngc", "json"):
                with self.subTest(feed=feed, target=target):
                    source = self.write("part.apt", f"CUTTER/2\nFROM/0,0,0\nFEDRAT/{feed}\nGOTO/1,0,0\nFINI\n")
                    self.assertNotEqual(self.run_arelem("compile", source, "--to", target, "-o", "part.out"), 0)
                    self.assertIn("error[E0590]", self.err)
                    self.assertEqual(self.files(), ["part.apt"])


class Holes(ArelemCase):
    """Under a cycle each location is a hole: nothing fits, smooths or divides what is no path."""
    CYCLE = "CUTTER/6\nSPINDL/900,CLW\nFEDRAT/200\nFROM/0,0,50\n{}CYCLE/DRILL,8,MMPM,90,2\n{}CYCLE/OFF\n{}FINI\n"
    ROW = "GOTO/10,0,0\nGOTO/20,0,0\nGOTO/30,0,0\nGOTO/40,0,0\n"

    def holes(self, text, *options):
        self.write("p.apt", text)
        self.assertExit(0, "compile", "p.apt", "--dialect", "cl", "-o", "p.ngc", *options)
        lines = (self.folder / "p.ngc").read_text().splitlines()
        return [line.split()[2] for line in lines if " G81 " in f" {line} "]

    def test_holes_stay(self):
        wanted = ["X10.0000", "X20.0000", "X30.0000", "X40.0000"]
        self.assertEqual(self.holes(self.CYCLE.format("", self.ROW, "")), wanted)
        self.assertEqual(self.holes(self.CYCLE.format("GOTO/0,0,0\n", self.ROW, ""), "--fit", ".5"), wanted)
        path = "GOTO/50,0,5\nGOTO/60,1,5\nGOTO/70,0,5\nSMOOTH/NOMORE\n"
        self.assertEqual(self.holes(self.CYCLE.format("SMOOTH/.1\n", self.ROW, path)), wanted)
        arc = "GOTO/10,0,0\nCIRCLE/0,0,0,0,0,1,10\nGOTO/0,10,0\n"
        self.assertEqual(self.holes(self.CYCLE.format("", arc, "")), ["X10.0000", "X0.0000"])

    def test_moves_of_an_inverse_time_stay(self):
        self.write("p.apt", "CUTTER/6\nFROM/0,0,0\nFEDRAT/12,INVERS\nGOTO/10,0,0\nGOTO/20,0,0\nGOTO/30,0,0\nFINI\n")
        self.assertExit(0, "compile", "p.apt", "--dialect", "cl", "-o", "p.ngc", "--fit", ".5")
        self.assertEqual((self.folder / "p.ngc").read_text().count("F12.0000"), 3)


if __name__ == "__main__":
    unittest.main()
