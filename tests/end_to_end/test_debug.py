#!/usr/bin/env python3
"""DEBUG: a trace of values and motions on standard error, from where it is switched on to where it is switched off."""
import unittest

from arelem_run import ArelemCase

PROGRAM = """CUTTER/2
A=3
DEBUG/{on}
B=A*2
L1=LINE/0,0,10,0
M1=MACRO/N
C=N+1
TERMAC
CALL/M1,N=4
FROM/0,5,0
GOTO/3,9,0
DEBUG/{off}
D=1
GOTO/0,0,0
FINI
"""


class Debug(ArelemCase):
    def trace(self, on, off, program=PROGRAM, code=0):
        self.write("a.apt", program.format(on=on, off=off))
        self.assertExit(code, "compile", "a.apt", "-o", "a.cls")
        return self.err.splitlines()

    # y = 0 of a line to the right: its normal points to -y, as the old system computes canonical forms
    values = ["a.apt:4: section 1: B = 6", "a.apt:5: section 1: L1 = LINE 0 -1 0 0", "a.apt:9: section 1: CALL M1",
              "a.apt:7: section 1:   C = 5"]
    motions = ["a.apt:10: section 2: FROM: 0 cut vectors, length 0, to 0, 5, 0", "a.apt:11: section 2: GOTO: 1 cut vectors, length 5, to 3, 9, 0"]

    def test_sections(self):
        values = self.values
        self.assertEqual(self.trace("ON", "OFF"), values + self.motions)
        self.assertEqual(self.trace("SEC1,ON", "SEC1,OFF"), values)
        self.assertEqual(self.trace("SEC2,ON", "OFF"), self.motions)
        plain = (self.folder / "a.cls").read_text()
        self.assertEqual(self.trace("OFF", "OFF"), [])
        self.assertEqual((self.folder / "a.cls").read_text(), plain)  # the CL data are the same

    def test_jumps_and_deviations(self):
        told = self.trace("ON", "OFF", "CUTTER/2\nINTOL/0\nOUTTOL/.01\nC1=CIRCLE/0,0,5\nFROM/0,9,0\nDEBUG/{on}\nLOOPST\nI=0\nL)I=I+1\n"
                          "IF(I-2)L,M,M\nM)GO/ON,C1\nLOOPND\nINDIRV/1,0,0\nTLON,GOFWD/C1,ON,(LINE/XAXIS)\nDEBUG/{off}\nFINI\n")
        self.assertIn("a.apt:10: section 1: IF -1 goes on at L", told)
        self.assertIn("a.apt:10: section 1: IF 0 goes on at M", told)
        row = [line for line in told if "GOFWD" in line]
        self.assertEqual(len(row), 1, told)
        self.assertRegex(row[0], r"section 2: GOFWD: \d+ cut vectors, length 7\.8\d+, to 5, 0, 0, off the drive surface by ")

    def test_of_a_program_with_errors(self):
        told = self.trace("ON", "OFF", "DEBUG/{on}\nA=2\nB=LOGF(A-3)\nFINI\n", 1)
        self.assertEqual(told[0], "a.apt:2: section 1: A = 2")

    def test_check_and_wrong_forms(self):
        self.write("a.apt", "DEBUG/SEC1,ON\nA=2\nFINI\n")
        self.assertExit(0, "check", "a.apt", "-q")
        self.assertEqual(self.err, "a.apt:2: section 1: A = 2\n")
        for wrong in ("DEBUG/7", "DEBUG/SEC1", "DEBUG/ON,OFF"):
            self.write("a.apt", wrong + "\nFINI\n")
            self.assertExit(1, "check", "a.apt")
            self.assertRegex(self.err, "E0472|E0204")


if __name__ == "__main__":
    unittest.main()
