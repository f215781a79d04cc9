#!/usr/bin/env python3
"""SPRAY among the rest of the language: REFSYS, TRACUT, COPY, macros, loops. A strip of 300 by 30 is one pass in its middle,
50 longer at each end: the footprint's radius, stand-off 50 under 45 degrees."""
import json
import unittest

from arelem_run import ArelemCase

HEAD = "UNITS/MM\nG1=GUN/CONE,45,STNDOF,50,SPEED,200\n"
STRIP = "R1=REGION/(0,0),(300,0),(300,30),(0,30)\n"
SPRAY = "SPRAY/R1,GUN,G1,FILM,.05,OVRLAP,.175\n"
TURN = "MX=MATRIX/XYROT,90,TRANSL,1000,0,0\n"  # (x, y) becomes (1000 - y, x)


class Language(ArelemCase):
    def passes(self, text):
        """Begin and end of each pass while the gun is on, x y z."""
        self.write("a.apt", text + "FINI\n")
        self.assertExit(0, "a.apt")
        found, here, on = [], None, False
        for line in (" ".join(l.split()) for l in self.out.splitlines()):
            if line.startswith("GOTO"):
                before, here = here, [float(v) for v in line.split("/")[1].split(",")[:3]]
                if on:
                    found.append((before, here))
            elif line.startswith("SPRAY"):
                on = "ON" in line
        self.assertFalse(on)
        return found

    def assertPasses(self, text, wanted):
        found = self.passes(text)
        self.assertEqual(len(found), len(wanted), self.out)
        for one, other in zip(found, wanted):
            for p, q in zip(one, other):
                for a, b in zip(p, q):
                    self.assertAlmostEqual(a, b, places=9)

    def test_tracut(self):
        self.assertPasses(HEAD + STRIP + TURN + "TRACUT/MX\n" + SPRAY + "TRACUT/NOMORE\n" + SPRAY,
                          [([985, -50, 50], [985, 350, 50]), ([-50, 15, 50], [350, 15, 50])])

    def test_copy(self):
        self.assertPasses(HEAD + STRIP + "INDEX/1\n" + SPRAY + "COPY/1,TRANSL,0,500,0,2\n",
                          [([-50, y, 50], [350, y, 50]) for y in (15, 515, 1015)])

    def test_refsys(self):
        # The region lies in its own system; passes run along x of the plane of the region, as ATANGL says.
        self.assertPasses(HEAD + TURN + "REFSYS/MX\n" + STRIP + "REFSYS/NOMORE\n" + SPRAY.replace("\n", ",ATANGL,90\n"),
                          [([985, -50, 50], [985, 350, 50])])

    def test_macros_and_loops(self):
        macro = ("M1=MACRO/W,H=30,TH=.05\nSPRAY/(REGION/(0,0),(W,0),(W,H),(0,H)),GUN,G1,FILM,TH,OVRLAP,.175\nTERMAC\n"
                 "CALL/M1,W=100\nLOOPST\nI=0\nA)I=I+1\nV=I*50\nCALL/M1,W=V,TH=.04\nIF(I-2)A,B,B\nB)I=9\nLOOPND\n")
        self.assertPasses(HEAD + macro, [([-50, 15, 50], [w + 50, 15, 50]) for w in (100, 50, 100)])
        self.assertExit(0, "spray", "a.apt", "--json")
        self.assertEqual([s["film"] for s in json.loads(self.out)], [.05, .04, .04])

    def test_all_of_it_as_a_robot_program(self):
        self.write("a.apt", HEAD + STRIP + TURN + "TRACUT/MX\nINDEX/1\n" + SPRAY + "COPY/1,TRANSL,0,500,0,2\nTRACUT/NOMORE\nFINI\n")
        for name in ("a.lng", "a.v2"):
            self.assertExit(0, "a.apt", "-o", name)
            self.assertExit(0, "verify", name, "--with", "a.apt")


if __name__ == "__main__":
    unittest.main()
