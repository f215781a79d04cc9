#!/usr/bin/env python3
"""PUNCH and READ/1: what one program punches another one reads, to the last bit."""
import json
import unittest

from arelem_run import ArelemCase

PROGRAM = """RESERV/P,2
P(1)=POINT/.1,.2,.3
P(2)=POINT/1.E-20,7.15,1.23456789012345
V=1.0E30
W=-3.3
M1=MATRIX/XYROT,33,TRANSL,1,2,3
L1=LINE/P(1),ATANGL,33
C1=CIRCLE/CENTER,P(1),RADIUS,V
E1=ELLIPS/CENTER,P(1),3,2,33
T1=TABCYL/NOZ,SPLINE,0,0,1,1,2,0,3,2
A1=PATERN/LINEAR,P(1),(POINT/1,2,3),4
S1=SPHERE/P(1),.7
"""


class Deck(ArelemCase):
    def geometry(self, name):
        self.assertExit(0, "geometry", name, "--json")
        return {(e["name"], e["subscript"]): (e["type"], e["values"]) for e in json.loads(self.out)
                if not e["name"].startswith("*")}

    def test_a_deck_reads_back_to_the_same_numbers(self):
        self.write("a.apt", PROGRAM + "PUNCH/1,ALL\nFINI\n")
        self.assertExit(0, "a.apt", "-o", "a.deck")
        deck = (self.folder / "a.deck").read_text()
        self.assertTrue(deck.endswith("ENDPCH\n"))
        self.write("b.apt", "RESERV/P,2\nREAD/1\n" + deck + "FINI\n")
        self.assertEqual(self.geometry("b.apt"), self.geometry("a.apt"))

    def test_modes_choose_scalars_or_entities(self):
        for mode, wanted in (("2", {"V"}), ("3", {"P1"}), ("1", {"V", "P1"})):
            self.write("a.apt", f"V=1\nP1=POINT/1,2,3\nPUNCH/{mode},ALL\nFINI\n")
            self.assertExit(0, "a.apt", "--to", "deck")
            self.assertEqual({line.split(",")[0] for line in self.out.splitlines()} - {"ENDPCH"}, wanted)

    def test_a_deck_without_its_end_is_an_error(self):
        self.write("a.apt", "READ/1\nA,0,SCALAR,1,4\n")
        self.assertExit(1, "check", "a.apt")
        self.assertIn("ENDPCH", self.err)


if __name__ == "__main__":
    unittest.main()
