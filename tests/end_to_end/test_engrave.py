#!/usr/bin/env python3
"""ENGRAV: text as moves of a cutter, to CL text and RS-274; refusals that leave nothing behind."""
import pathlib
import re
import unittest

from arelem_run import ArelemCase

PROJECT = pathlib.Path(__file__).resolve().parents[2]


class Engrave(ArelemCase):
    def cut(self, statement, head="UNITS/MM\n"):
        self.write("part.apt", head + statement + "\nFINI\n")
        self.assertExit(0, "part.apt", "-o", "part.cls")
        lines = [line.strip() for line in (self.folder / "part.cls").read_text().splitlines()]
        return [line for line in lines if re.match(r"(GOTO|RAPID|FEDRAT)", line)]

    def places(self, lines):
        return [tuple(round(float(x), 6) for x in line.split("/")[1].split(",")[:3]) for line in lines if line.startswith("GOTO")]

    def test_one_line(self):
        # An I of 12 mm from its foot: over it, down, along it, up.
        lines = self.cut("ENGRAV/'I',HEIGHT,12,DEEP,.3,CLEARP,2,FEDRAT,400,120")
        self.assertEqual(self.places(lines), [(0, 0, 2), (0, 0, -.3), (0, 12, -.3), (0, 12, 2)])
        words = [line.split("/")[0].strip() for line in lines]
        self.assertEqual(words, ["RAPID", "GOTO", "FEDRAT", "GOTO", "FEDRAT", "GOTO", "RAPID", "GOTO"])

    def test_passes_go_back_and_forth(self):
        lines = self.cut("ENGRAV/'I',HEIGHT,12,DEEP,.3,.1,CLEARP,2")
        self.assertEqual([(y, z) for _, y, z in self.places(lines)],
                         [(0, 2), (0, -.1), (12, -.1), (12, -.2), (0, -.2), (0, -.3), (12, -.3), (12, 2)])

    def test_place_and_unit(self):
        # In inches, on a face 1 in high, written upwards: an I runs to -x.
        lines = self.cut("P1=POINT/3,4,1\nENGRAV/'I',HEIGHT,.5,DEEP,.01,CLEARP,.1,ORIGIN,P1,ATANGL,90", "UNITS/INCHES\n")
        self.assertEqual(self.places(lines), [(3, 4, 1.1), (3, 4, .99), (2.5, 4, .99), (2.5, 4, 1.1)])

    def test_leaning_face(self):
        # On a plane turned by 90 degrees about x: the tool stands along -y of the base.
        lines = self.cut("M1=MATRIX/YZROT,90\nMULTAX/ON\nREFSYS/M1\nENGRAV/'I',HEIGHT,12,DEEP,.3,CLEARP,2\nREFSYS/NOMORE")
        goto = [[float(x) for x in line.split("/")[1].split(",")] for line in lines if line.startswith("GOTO")]
        for got, want in zip(goto, [(0, -2, 0), (0, .3, 0), (0, .3, 12), (0, -2, 12)]):
            for a, b in zip(got, want + (0, -1, 0)):
                self.assertAlmostEqual(a, b, 6)

    def test_ngc(self):
        self.write("part.apt", "UNITS/MM\nSPINDL/9000,CLW\nENGRAV/'A1',HEIGHT,10,DEEP,.2,CLEARP,2,FEDRAT,300\nFINI\n")
        self.assertExit(0, "part.apt", "-o", "part.ngc")
        text = (self.folder / "part.ngc").read_text()
        self.assertIn("Z-0.2", text)
        self.assertGreaterEqual(len(re.findall(r"G0?0\b", text)), 2)

    def test_example(self):
        example = (PROJECT / "examples" / "name_plate.apt").read_text()
        self.write("part.apt", example)
        self.assertExit(0, "part.apt", "-o", "part.ngc", "-o", "part.cls")

    def test_chart_of_pen_lines(self):
        self.write("x.alphabet", "GRID 4 25\nPENGRID 4 6 1\nSYMBOL L\nPEN FROM 0,6 LINE 0,0 LINE 3,0\n")
        self.assertExit(0, "alphabet", "x.alphabet", "--pens", "--plain", "-o", "c.svg")
        chart = (self.folder / "c.svg").read_text()
        self.assertIn(">L</text>", chart)
        # 24 pixels a unit: 144 down, 72 to the right.
        self.assertIn('points="96,178 24,178 24,34"', chart)

    def test_refusals_leave_the_file_alone(self):
        for statement, code in [("ENGRAV/'A%',HEIGHT,10,DEEP,.3,CLEARP,2", "E0560"),
                                ("ENGRAV/' ',HEIGHT,10,DEEP,.3,CLEARP,2", "E0563"),
                                ("ENGRAV/'O',HEIGHT,10,DEEP,.3,CLEARP,2,CHORD,1.E-30", "E0564"),
                                ("ENGRAV/'I',HEIGHT,10,DEEP,.3,1.E-12,CLEARP,2", "E0564"),
                                ("ENGRAV/'A',HEIGHT,10,DEEP,.3", "E0568"),
                                ("ENGRAV/HEIGHT,10", "E0568"),
                                ("ENGRAV/'A',HEIGHT,10,DEEP,.3,CLEARP,2,CLEARP,3", "E0568"),
                                ("ENGRAV/'A',HEIGHT,10,DEEP,.3,CLEARP,2,TILT,OFF", "E0568"),
                                ("ENGRAV/'A',HEIGHT,0,DEEP,.3,CLEARP,2", "E0569"),
                                ("ENGRAV/'A',HEIGHT,10,DEEP,-.3,CLEARP,2", "E0569"),
                                ("ENGRAV/'A',HEIGHT,10,DEEP,.3,CLEARP,2,ALPHAB,'none.alphabet'", "E0731")]:
            self.write("part.apt", statement + "\nFINI\n")
            self.write("part.cls", "as it was\n")
            self.assertNotEqual(self.run_arelem("part.apt", "-o", "part.cls"), 0, statement)
            self.assertIn(code, self.err, statement)
            self.assertEqual((self.folder / "part.cls").read_text(), "as it was\n")


if __name__ == "__main__":
    unittest.main()
