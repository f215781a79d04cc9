#!/usr/bin/env python3
"""Degenerate and tangent positions of definitions: the code with the old number, the entities and where they were
defined as labels, and for a modifier that does not decide both candidates with their coordinates."""
import json
import unittest

from arelem_run import ArelemCase

L = "L1=LINE/0,0,4,0\nL2=LINE/0,3,4,3\n"
C = "C1=CIRCLE/0,0,5\nC2=CIRCLE/20,0,5\n"
PL = "PL1=PLANE/0,0,1,0\nPL2=PLANE/0,0,1,4\nPL3=PLANE/1,0,0,0\n"
P = "P1=POINT/0,0\nP2=POINT/1,1\nP3=POINT/2,2\nP4=POINT/3,3\n"

# Program, code, names that must be labels, what the message or a note must say.
CASES = [
    (L + "X=POINT/INTOF,L1,L2", "E0310", "L1 L2", "3 apart"),
    (L + C + "X=POINT/XLARGE,INTOF,(L3=LINE/0,9,1,9),C1", "E0311", "C1", "9 apart where 5"),
    (C + "X=POINT/XLARGE,INTOF,C1,C2", "E0311", "C1 C2", "20 apart where 10"),
    (C + "L3=LINE/YAXIS\nX=POINT/XLARGE,INTOF,L3,C1", "E0312", "L3 C1", "(0, 5)|(0, -5)"),
    (C + "C3=CIRCLE/8,0,5\nX=POINT/XLARGE,INTOF,C1,C3", "E0312", "C1 C3", "(4, 3)|(4, -3)"),
    ("E1=ELLIPS/CENTER,(POINT/0,0),5,3,0\nL1=LINE/4,0,4,1\nX=POINT/XLARGE,INTOF,L1,E1", "E0312", "E1 L1", "(4, 1.8)|(4, -1.8)"),
    (PL + "X=POINT/INTOF,PL1,PL2,PL3", "E0310", "PL1 PL2 PL3", ""),
    ("P1=POINT/1,2\nP2=POINT/1,2,9\nX=LINE/P1,P2", "E0314", "P1 P2", "(1, 2)"),
    (C + "P1=POINT/1,0\nX=LINE/P1,LEFT,TANTO,C1", "E0318", "P1 C1", "inside"),
    (C + "C3=CIRCLE/1,0,2\nX=LINE/LEFT,TANTO,C1,LEFT,TANTO,C3", "E0318", "C1 C3", "inside"),
    (C + "C3=CIRCLE/8,0,5\nX=LINE/LEFT,TANTO,C1,RIGHT,TANTO,C3", "E0318", "C1 C3", "overlap"),
    (L + "X=LINE/PARLEL,L1,XLARGE,2", "E0313", "L1", "x component"),
    (PL + "X=LINE/INTOF,PL1,PL2", "E0310", "PL1 PL2", ""),
    (PL + "X=PLANE/PARLEL,PL1,XLARGE,2", "E0313", "PL1", "x component"),
    (P + "X=PLANE/P1,P2,P3", "E0315", "P1 P2 P3", ""),
    (PL + "P1=POINT/0,0,0\nP2=POINT/0,0,7\nX=PLANE/PERPTO,PL1,P1,P2", "E0314", "PL1 P1 P2", ""),
    (PL + "P1=POINT/0,0,0\nX=PLANE/P1,PERPTO,PL1,PL2", "E0310", "PL1 PL2", ""),
    (P + "X=CIRCLE/P1,P2,P3", "E0315", "P1 P2 P3", ""),
    (L + "P1=POINT/3,0\nX=CIRCLE/CENTER,P1,TANTO,L1", "E0319", "P1 L1", "greater than 0"),
    (P + "X=CIRCLE/CENTER,P1,P1", "E0319", "P1", "greater than 0"),
    (L + "X=CIRCLE/YLARGE,L1,YLARGE,L2,RADIUS,2", "E0310", "L1 L2", ""),
    (L + "X=CIRCLE/XLARGE,L1,YLARGE,L2,RADIUS,2", "E0313", "L1", "x component"),
    (L + "P1=POINT/0,9\nX=CIRCLE/TANTO,L1,XLARGE,P1,RADIUS,2", "E0311", "L1 P1", "twice the radius"),
    (L + C + "X=CIRCLE/YSMALL,L1,XLARGE,OUT,(C3=CIRCLE/0,50,1),RADIUS,2", "E0311", "L1", ""),
    (C + "X=CIRCLE/XLARGE,OUT,C1,OUT,C2,RADIUS,1", "E0311", "C1 C2", ""),
    (C + "C3=CIRCLE/8,0,5\nX=CIRCLE/XLARGE,OUT,C1,OUT,C3,RADIUS,1", "E0312", "C1 C3", "(4, 4.47213595)|(4, -4.47213595)"),
    ("X=CYLNDR/0,0,0,0,0,0,5", "E0314", "", "direction"),
    ("P1=POINT/0,0\nV1=VECTOR/0,0,0\nX=CONE/P1,V1,30", "E0314", "V1", ""),
    ("P1=POINT/0,0\nV1=VECTOR/0,0,1\nX=CONE/P1,V1,90", "E0320", "P1 V1", ""),
    ("P1=POINT/0,0\nX=ELLIPS/CENTER,P1,0,1,0", "E0320", "P1", "half axis"),
    (P + "X=LCONIC/5PT,P1,P2,P3,P4,P1", "E0325", "P1 P2 P3 P4", ""),
    (PL + "X=VECTOR/PERPTO,PL1,POSX", "E0313", "PL1", "x component"),
    (PL + "X=VECTOR/PARLEL,INTOF,PL1,PL2,POSX", "E0310", "PL1 PL2", ""),
    ("V1=VECTOR/0,0,0\nX=VECTOR/UNIT,V1", "E0314", "V1", ""),
    (L + "X=VECTOR/ATANGL,90,L1,POSX", "E0313", "L1", "x component"),
    ("M1=MATRIX/SCALE,0\nX=MATRIX/INVERS,M1", "E0322", "M1", "determinant"),
    (PL + "X=MATRIX/PL1,PL2,PL3", "E0321", "PL1 PL2 PL3", "cosine"),
    ("P1=POINT/0,0\nV1=VECTOR/1,0,0\nV2=VECTOR/2,0,0\nX=MATRIX/P1,V1,V2", "E0310", "V1 V2", ""),
    ("P1=POINT/0,0\nP2=POINT/1,0\nP3=POINT/0,1\nP4=POINT/1,1\nX=SPHERE/P1,P2,P3,P4", "E0316", "P1 P2 P3 P4", ""),
    ("PL1=PLANE/0,0,1,0\nP1=POINT/0,0\nX=SPHERE/CENTER,P1,TANTO,PL1", "E0319", "PL1 P1", "greater than 0"),
    ("X=TABCYL/NOZ,SPLINE,0,0,1,0", "E0327", "", "at least 3"),
    ("P1=POINT/0,0\nX=TABCYL/NOZ,SPLINE,P1,P1,1,0,2,0", "E0317", "P1", "apart"),
    ("X=TABCYL/NOZ,SPLINE,0,0,1,0,0,0", "E0328", "", "degrees"),
    ("A1=PATERN/LINEAR,(POINT/0,0),(POINT/1,0),3\nX=POINT/A1,4", "E0326", "A1", "3 points"),
    ("PL1=PLANE/1,0,0,0\nP1=POINT/0,0,0\nP2=POINT/0,0,.01\nV1=VECTOR/0,1,0\nP3=POINT/5,0,0\nX=RLDSRF/PL1,P1,P2,V1,P3", "E0336", "P1 P2", ""),
]


class Degenerate(ArelemCase):
    def check(self, text, code, labels, said):
        program = self.write("t.apt", text + "\nFINI\n")
        self.run_arelem("check", program, "--diagnostics=json")
        messages = [json.loads(line) for line in self.err.splitlines() if line.startswith("{")]
        self.assertEqual([m["code"] for m in messages], [code], self.err)
        message = messages[0]
        self.assertRegex(message["legacy"], r"^\d+$", message)
        self.assertEqual(message["range"]["start"]["line"], text.count("\n") + 1)
        for name in labels.split():
            places = [r for r in message["related"] if f"`{name}`" in r["message"]]
            self.assertTrue(places, f"{name} is no label of {message}")
            line = places[0]["range"]["start"]["line"]
            self.assertIn(name + "=", text.splitlines()[line - 1])
        told = " ".join([message["message"], *message["notes"]])
        for piece in said.split("|"):
            self.assertIn(piece, told)

    def test_each_is_told_with_its_operands(self):
        for text, code, labels, said in CASES:
            with self.subTest(program=text, code=code):
                self.check(text, code, labels, said)


if __name__ == "__main__":
    unittest.main()
