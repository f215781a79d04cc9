#!/usr/bin/env python3
"""LEAD of a gun: the run-up before the work is in the times, ways and costs of SPRAY, which `arelem time` counts too."""
import json
import unittest

from arelem_run import ArelemCase

GUN = "UNITS/MM\nG1=GUN/CONE,14,STNDOF,150,SPEED,600,FLOW,.3,EFFIC,.5{}\n"
PLATE = "R1=REGION/(0,0),(100,0),(100,60),(0,60)\nSPRAY/R1,GUN,G1,FILM,.3{}\nFINI\n"
# A machine that changes its speed at once: nothing but ways by speeds.
AT_ONCE = ("--velocity", "600", "--acceleration", "1e9", "--jerk", "1e15")


class Lead(ArelemCase):
    def sprayed(self, text):
        self.write("p.apt", text)
        self.assertExit(0, "spray", "-q", "p.apt", "--json")
        return json.loads(self.out)[0]

    def timed(self, text):
        self.write("p.apt", text)
        self.assertExit(0, "time", "p.apt", "--json", *AT_ONCE)
        return json.loads(self.out)

    def assertSums(self, text, share=1e-3, bent=False):
        """The report's times, and on flat work its ways, are those of the CL: round a bend the nozzle goes farther than its spray."""
        one, table = self.sprayed(text), self.timed(text)
        self.assertAlmostEqual(one["Ti"] + one["To"], table["total"], delta=share * table["total"])
        if bent:
            return one
        length = table["cuttingLength"] + table["rapidLength"]
        self.assertAlmostEqual(one["Xi"] + one["Xo"], length, delta=share * length)
        return one

    def test_a_region(self):
        """Two passes, half a second earlier each: one second more, and the way back is longer by the run-up."""
        plain = self.assertSums(GUN.format("") + PLATE.format(""))
        early = self.assertSums(GUN.format(",LEAD,.5,.2") + PLATE.format(""))
        self.assertEqual(plain["passes"], 2)
        self.assertEqual(plain["Ti"], early["Ti"])
        v = plain["v"]
        step = plain["interval"]
        back = (step ** 2 + (0.5 * v) ** 2) ** 0.5
        self.assertAlmostEqual(plain["To"], step / 600, places=9)
        self.assertAlmostEqual(early["To"], 1.0 + back / 600, places=9)
        self.assertAlmostEqual(early["Xo"], 2 * 0.5 * v + back, places=6)

    def test_gaps(self):
        """Over a hole the gun slows down before it is switched on again."""
        hole = ("R1=REGION/(0,0),(900,0),(900,600),(0,600),HOLE,(CIRCLE/450,300,200)\n"
                "SPRAY/R1,GUN,G1,FILM,.04,OVRLAP,0,ATANGL,30{}\nFINI\n")
        self.assertSums(GUN.format(",LEAD,.05,.02") + hole.format(""))
        self.assertSums(GUN.format("") + hole.format(""))

    def test_costs(self):
        """Gun time at 3600 $/h is 1 $ a second; the search weighs the run-ups."""
        priced = PLATE.format(",MINCST,3600,0,0,0{}")
        one = self.sprayed(GUN.format(",LEAD,.5,.2") + priced.format(""))
        self.assertAlmostEqual(one["cost"]["travelTime"], one["To"], places=9)
        self.assertGreater(one["To"], 1.0)
        found = self.sprayed(GUN.format(",LEAD,.5,.2") + priced.format(",ANGLE,0,90,30"))
        for trial in found["trials"]:
            self.assertGreaterEqual(trial["To"], 0.5 * trial["passes"])

    def test_surfaces(self):
        """Ten straight lines on a cylinder, a tenth of a second before each."""
        lines = "C1=CYLNDR/0,0,0,0,1,0,200\nSPRAY/C1,GUN,G1,FILM,.05,VLINES,LIMITS,0,90,0,300\nFINI\n"
        plain = self.assertSums(GUN.format("") + lines)
        early = self.assertSums(GUN.format(",LEAD,.1,.05") + lines)
        self.assertEqual(plain["Ti"], early["Ti"])
        self.assertGreater(early["To"], plain["To"] + 0.1 * early["passes"])
        self.assertSums(GUN.format(",LEAD,.1,.05") + lines.replace("VLINES", "ULINES"), bent=True)

    def test_rapid_is_of_one_location(self):
        """RAPID before the first location of a file is not that of the second."""
        table = self.timed("FEDRAT/6000\nRAPID\nGOTO/0,0,0\nGOTO/100,0,0\nFINI\n")
        self.assertEqual(table["rapidLength"], 0)
        self.assertAlmostEqual(table["cuttingLength"], 100)


if __name__ == "__main__":
    unittest.main()
