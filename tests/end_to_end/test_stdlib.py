#!/usr/bin/env python3
"""Macros of the standard library: what they cut, measured on their CL data; the page of the manual has their heads."""
import json
import math
import unittest

from arelem_run import PROJECT, ArelemCase

POINTS = "P0=POINT/10,20,0\nP1=POINT/0,0,0\nP2=POINT/40,30,0\n"


class Library(ArelemCase):
    def call(self, name, arguments, more=""):
        self.write("a.apt", f"UNITS/MM\n{POINTS}{more}LIBRY/{name}\nFROM/0,0,50\nCALL/{name},{arguments}\nFINI\n")
        self.assertExit(0, "compile", "a.apt", "--to", "json")
        self.assertEqual(self.err, "")
        self.records = [json.loads(line) for line in self.out.splitlines()]
        return [p for r in self.records if r["kind"] == "GOTO" for p in r["points"]]

    def arcs(self):
        rows = [r for r in self.records if r["kind"] in ("SURFACE", "GOTO")]
        return [(a["canon"], b["points"][0]) for a, b in zip(rows, rows[1:]) if a["kind"] == "SURFACE"]

    def test_bolt_circle(self):
        holes = self.call("BOLTC", "CP=P0,DIA=60,NUM=6,DEP=18,FED=120,ANG=15")
        self.assertEqual(len(holes), 6)
        for i, (x, y, z) in enumerate(holes):
            angle = math.radians(15 + 60 * i)
            self.assertAlmostEqual(math.hypot(x - 10 - 30 * math.cos(angle), y - 20 - 30 * math.sin(angle)), 0, 9)
            self.assertEqual(z, 0)
        cycles = [r["args"] for r in self.records if r.get("word") == "CYCLE"]
        self.assertEqual(cycles, [["DRILL", 18, "MMPM", 120, 2], ["OFF"]])

    def test_hole_grid(self):
        holes = self.call("HGRID", "CP=P0,NX=3,DX=20,NY=2,DY=15,DEP=10,FED=120,CYC=TAP")
        self.assertEqual([h[:2] for h in holes], [[10, 20], [30, 20], [50, 20], [50, 35], [30, 35], [10, 35]])

    def test_face(self):
        points = self.call("FACMIL", "XA=0,YA=0,XB=120,YB=80,ZT=1,CUTR=50,FED=600")
        strokes = sorted({p[1] for p in points if p[2] == 1})
        self.assertLessEqual(strokes[0] - 25, 0)
        self.assertGreaterEqual(strokes[-1] + 25, 80)
        self.assertLessEqual(max(b - a for a, b in zip(strokes, strokes[1:])), 35)
        for p in points:
            self.assertTrue(p[0] < -25 or p[0] > 145, "the cutter is clear of the face between strokes")

    def test_rectangular_pocket(self):
        for size, steps in (((60, 40), 2), ((40, 40), 3), ((30, 90), 2)):
            points = self.call("RPOCK", f"XA=0,YA=0,XB={size[0]},YB={size[1]},ZT=0,ZB=-12,CUTR=10,FED=400,DOC=4")
            below = [p for p in points if p[2] < 0]
            self.assertEqual(min(p[2] for p in below), -12)
            self.assertEqual(([min(p[0] for p in below), max(p[0] for p in below)], [min(p[1] for p in below), max(p[1] for p in below)]),
                             ([5, size[0] - 5], [5, size[1] - 5]))
            floor = [p for p in below if p[2] == -12]
            moves = list(zip(floor, floor[1:]))
            for i in range(51):
                for k in range(51):
                    p = (size[0] * i / 50, size[1] * k / 50)
                    corner = min(p[0], size[0] - p[0]) < 5 and min(p[1], size[1] - p[1]) < 5
                    if not corner:
                        self.assertLess(min(away(p, a, b) for a, b in moves), 5 + 1e-9, (size, p))

    def test_round_pocket(self):
        self.call("CPOCK", "CP=P0,DIA=50,ZB=-12,CUTR=10,FED=400")
        arcs = self.arcs()
        radii = sorted({round(c[6], 9) for c, _ in arcs})
        self.assertEqual(radii[-1], 20)
        self.assertLessEqual(max(b - a for a, b in zip([0, *radii], radii)), 6 + 1e-9)
        self.assertEqual(min(end[2] for _, end in arcs), -12)
        helices = [end for (c, end) in arcs if abs(c[2] - end[2]) > 1e-9]
        self.assertEqual([round(h[2], 9) for h in helices], [-4, -8, -12])

    def test_slot(self):
        points = self.call("SLOTP", "PA=P1,PB=P2,WID=12,ZB=-6,CUTR=10,FED=300")
        for x, y, z in points[3:]:
            if z < 0:
                self.assertLess(away((x, y), (0, 0), (40, 30)), 1 + 1e-9)
        self.assertEqual(len(self.arcs()), 2)
        self.assertEqual([c[6] for c, _ in self.arcs()], [1, 1])

    def test_thread(self):
        for hand in (1, -1):
            self.call("THRMIL", f"CP=P0,DIA=24,PIT=3,DEP=20,CUTR=16,FED=200,HAND={hand}")
            turns = [(c, end) for c, end in self.arcs() if c[6] == 4]
            self.assertEqual(len(turns), 8)
            for (c, end), z in zip(turns, range(-17, 5, 3)):
                self.assertEqual(c[5], hand)
                self.assertAlmostEqual(end[2], z)

    def corners(self, *points):
        return f"RESERV/Q,{len(points)}\n" + "".join(f"Q({i + 1})=POINT/{x},{y}\n" for i, (x, y) in enumerate(points))

    def assertKeepsOff(self, path, sides, radius):
        """Every point of the path is at least the radius away from every side."""
        for a, b in zip(path, path[1:]):
            for i in range(21):
                p = (a[0] + (b[0] - a[0]) * i / 20, a[1] + (b[1] - a[1]) * i / 20)
                self.assertGreater(min(away(p, *s) for s in sides), radius - 1e-9, (a, b))

    def test_chamfered_contour(self):
        # an L whose inner corner has a chamfer too
        outline = ((0, 0), (0, 50), (30, 50), (30, 30), (80, 30), (80, 0))
        ends = ((5, 0), (0, 5), (0, 45), (5, 50), (25, 50), (30, 45), (30, 35), (35, 30), (75, 30), (80, 25), (80, 5), (75, 0))
        sides = list(zip(ends, ends[1:] + ends[:1]))
        for order in (outline, outline[:1] + outline[:0:-1]):
            points = [p for p in self.call("CHMCON", "PTS=Q,NUM=6,CHM=5,ZT=0,ZB=-6,CUTR=8,FED=300", self.corners(*order)) if p[2] == -6]
            path = points[1:-1]  # without the quarter circles
            self.assertEqual(path[0], path[-1])
            self.assertEqual(len(path), 14)
            self.assertKeepsOff(path, sides, 4)
            for a, b in zip(path, path[1:]):
                middle = ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
                self.assertAlmostEqual(min(away(middle, *s) for s in sides), 4, 9)
            turn = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(path, path[1:]))
            self.assertLess(turn, 0, "clockwise whatever the order of the corners")
        self.refuses("CHMCON", "PTS=Q,NUM=6,CHM=12,ZT=0,ZB=-6,CUTR=8,FED=300", self.corners(*outline))
        self.refuses("CHMCON", "PTS=Q,NUM=6,CHM=2,ZT=0,ZB=-6,CUTR=12,FED=300", self.corners(*outline))

    def test_rounded_contour(self):
        self.call("FILCON", "PTS=Q,NUM=4,FIL=8,ZT=0,ZB=-6,CUTR=12,FED=300", self.corners((0, 0), (80, 0), (80, 50), (0, 50)))
        lead, *fillets, away_again = self.arcs()
        self.assertEqual([(c[0], c[1], c[5], c[6]) for c, _ in fillets],
                         [(8, 42, -1, 14), (72, 42, -1, 14), (72, 8, -1, 14), (8, 8, -1, 14)])
        self.assertEqual((lead[0][6], lead[1][:2], away_again[0][6]), (6, [-6, 25], 6))

    def test_contour_of_lines_and_arcs(self):
        # sharp, rounded by 3, an inner corner whose radius is less than the cutter's, a half round end
        radii = "RESERV/R,6\n" + "".join(f"R({i + 1})={r}\n" for i, r in enumerate((0, 3, 8, 2, 15, 15)))
        outline = self.corners((0, 0), (0, 50), (30, 50), (30, 30), (80, 30), (80, 0)) + radii
        self.call("FILCON", "PTS=Q,NUM=6,FIL=0,RAD=R,ZT=0,ZB=-6,DOC=6,CUTR=12,FED=300", outline)
        self.assertEqual([(c[0], c[1], c[5], c[6]) for c, _ in self.arcs()[1:-1]],
                         [(0, 0, -1, 6), (3, 47, -1, 9), (22, 42, -1, 14), (65, 15, -1, 21), (65, 15, -1, 21)])
        self.assertIn([36, 36, -6], [r["points"][0] for r in self.records if r["kind"] == "GOTO"])
        self.refuses("FILCON", "PTS=Q,NUM=6,FIL=16,ZT=0,ZB=-6,CUTR=12,FED=300", outline)

    def refuses(self, name, arguments, more):
        self.write("a.apt", f"UNITS/MM\n{POINTS}{more}LIBRY/{name}\nFROM/0,0,50\nCALL/{name},{arguments}\nFINI\n")
        self.assertNotEqual(0, self.run_arelem("compile", "a.apt", "--to", "json"))
        self.assertIn("E0406", self.err)

    def test_contour_in_passes(self):
        outline = ("CUTTER/10\nL1=LINE/0,0,0,50\nL2=LINE/0,50,80,50\nL3=LINE/80,50,80,0\nL4=LINE/80,0,0,0\nCONPS=PLANE/0,0,1,0\n"
                   "OUTLN=MACRO/\nRAPID\nGOTO/-30,-30,5\nGO/TO,L1,TO,CONPS,PAST,L4\nINDIRV/0,1,0\nTLLFT,GOFWD/L1,PAST,L2\n"
                   "GORGT/L2,PAST,L3\nGORGT/L3,PAST,L4\nGORGT/L4,PAST,L1\nRAPID\nGODLTA/0,0,20\nTERMAC\n")
        points = self.call("CONPAS", "PATH=OUTLN,ZT=0,ZB=-9,DOC=4.5,FED=300,NRO=2,STK=2,FIN=.5", outline)
        seen = sorted({(p[2], round(p[0], 6)) for p in points if p[2] < 0 and p[0] < 0})
        self.assertEqual(seen, [(-9, -7.5), (-9, -5.5), (-9, -5), (-4.5, -7.5), (-4.5, -5.5)])

    def test_the_manual_has_the_heads(self):
        page = (PROJECT / "docs/manual/library.md").read_text()
        for path in sorted((PROJECT / "stdlib").glob("*.apt")):
            for line in path.read_text().splitlines():
                if line.startswith("$$   "):
                    self.assertIn(line[5:].strip(), page, path.name)


def away(p, a, b):
    dx, dy = b[0] - a[0], b[1] - a[1]
    t = max(0.0, min(1.0, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / ((dx * dx + dy * dy) or 1.0)))
    return math.hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy)


if __name__ == "__main__":
    unittest.main()
