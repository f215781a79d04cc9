#!/usr/bin/env python3
"""Macros of the standard library: what they cut, measured on their CL data; the page of the manual has their heads."""
import json
import math
import random
import unittest

from arelem_run import ArelemCase

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

    def floor(self, bottom):
        """Moves in the plane of the bottom as short chords (arcs too); stops before the way up."""
        out, at, arc = [], None, None
        for r in self.records:
            if r["kind"] == "SURFACE":
                arc = r["canon"]
            elif r["kind"] == "GOTO":
                for p in r["points"]:
                    chords = [tuple(p)]
                    if arc and at:
                        first = math.atan2(at[1] - arc[1], at[0] - arc[0])
                        turn = (math.atan2(p[1] - arc[1], p[0] - arc[0]) - first - 1e-9) % (2 * math.pi)
                        n = max(8, math.ceil(turn * 40))
                        chords = [(arc[0] + arc[6] * math.cos(first + turn * i / n), arc[1] + arc[6] * math.sin(first + turn * i / n),
                                   at[2] + (p[2] - at[2]) * i / n) for i in range(1, n + 1)]
                    for q in chords:
                        if at:
                            out.append((at, q))
                        at = q
                    arc = None
        below = [(a, b) for a, b in out if a[2] < bottom + 5 - 1e-9 or b[2] < bottom + 5 - 1e-9]
        return below, [(a, b) for a, b in below if abs(a[2] - bottom) < 1e-9 and abs(b[2] - bottom) < 1e-9]

    def assertCovers(self, what, places, moves, radius):
        """Every place is cut by a move at the bottom; chords of arcs may miss by their height."""
        for p in places:
            self.assertLess(min(away(p, a, b) for a, b in moves), radius + 5e-3, (what, p))

    def test_pockets_of_many_sizes_leave_no_stock_and_do_not_gouge(self):
        sizes = random.Random(9)
        for x, y, cutter, width in [(70, 33, 8, ""), (60, 31, 10, ""), (10, 40, 10, ""), (40, 40, 10, ",WOC=8.5"), (50, 26.4, 12, ",WOC=10.2")] + [
                (round(sizes.uniform(14, 60), 1), round(sizes.uniform(14, 60), 1), sizes.choice((8, 10, 12)), "") for _ in range(12)]:
            what = f"XA=0,YA=0,XB={x},YB={y},ZT=0,ZB=-5,CUTR={cutter},FED=400{width}"
            self.call("RPOCK", what)
            below, floor = self.floor(-5)
            radius = cutter / 2
            for a, b in below:
                for p in (a, b):
                    self.assertTrue(radius - 1e-9 <= p[0] <= x - radius + 1e-9 and radius - 1e-9 <= p[1] <= y - radius + 1e-9, (what, p))
            places = [(x * i / 48, y * k / 48) for i in range(49) for k in range(49)]
            self.assertCovers(what, [p for p in places if min(p[0], x - p[0]) >= radius or min(p[1], y - p[1]) >= radius], floor, radius)

    def test_round_pockets_of_many_sizes(self):
        sizes = random.Random(45)
        for size, cutter, width in [(45, 8, ""), (10.5, 10, ""), (40, 10, ",WOC=10")] + [
                (round(sizes.uniform(13, 70), 1), sizes.choice((8, 10, 12)), "") for _ in range(12)]:
            what = f"CP=P0,DIA={size},ZB=-5,CUTR={cutter},FED=400{width}"
            self.call("CPOCK", what)
            below, floor = self.floor(-5)
            for a, b in below:
                self.assertLessEqual(math.hypot(a[0] - 10, a[1] - 20), (size - cutter) / 2 + 1e-9, what)
            self.assertCovers(what, [(10 + size * i / 80, 20) for i in range(-40, 41)], floor, cutter / 2)

    def test_slots_and_faces_of_many_sizes(self):
        sizes = random.Random(7)
        for width in [10, 20] + [round(sizes.uniform(10, 20), 2) for _ in range(6)]:
            what = f"PA=P1,PB=P2,WID={width},ZB=-5,CUTR=10,FED=400"
            self.call("SLOTP", what)
            below, floor = self.floor(-5)
            for a, b in below:
                self.assertLess(away(b, (0, 0), (40, 30)), (width - 10) / 2 + 1e-9, what)
            places = [(40 * i / 20 - .6 * width * k / 20, 30 * i / 20 + .8 * width * k / 20) for i in range(-6, 27) for k in range(-10, 11)]
            self.assertCovers(what, [p for p in places if away(p, (0, 0), (40, 30)) <= width / 2], floor, 5)
        for y, width in [(80, ""), (50, ",WOC=50"), (120, ",WOC=50")] + [(round(sizes.uniform(20, 300), 1), "") for _ in range(12)]:
            what = f"XA=0,YA=0,XB=100,YB={y},ZT=-5,CUTR=50,FED=600{width}"
            self.call("FACMIL", what)
            _, floor = self.floor(-5)
            self.assertCovers(what, [(100 * i / 10, y * k / 60) for i in range(11) for k in range(61)], floor, 25)

    def test_what_cannot_be_cut_is_an_error(self):
        pocket = "ZT=0,ZB=-3,CUTR=10,FED=100"
        for name, arguments, reason in (
                ("RPOCK", f"XA=60,YA=40,XB=0,YB=0,{pocket}", "XB - XA is less than CUTR (-60, 10)"),
                ("RPOCK", f"XA=0,YA=0,XB=9,YB=40,{pocket}", "XB - XA is less than CUTR (9, 10)"),
                ("RPOCK", f"XA=0,YA=0,XB=40,YB=9,{pocket}", "YB - YA is less than CUTR (9, 10)"),
                ("RPOCK", f"XA=0,YA=0,XB=10,YB=10,{pocket}", "as small as the cutter"),
                ("RPOCK", f"XA=0,YA=0,XB=40,YB=40,{pocket},WOC=9.9", "WOC must be at most .85 of CUTR (9.9, 10)"),
                ("RPOCK", "XA=0,YA=0,XB=40,YB=40,ZT=0,ZB=3,CUTR=10,FED=100", "ZB must be below ZT (3, 0)"),
                ("CPOCK", "CP=P0,DIA=9,ZB=-3,CUTR=10,FED=100", "DIA must be more than CUTR (9, 10)"),
                ("CPOCK", "CP=P0,DIA=40,ZB=-3,CUTR=10,FED=100,WOC=11", "WOC must be at most CUTR (11, 10)"),
                ("SLOTP", "PA=P1,PB=P2,WID=9,ZB=-3,CUTR=10,FED=100", "WID must be at least CUTR (9, 10)"),
                ("SLOTP", "PA=P1,PB=P2,WID=25,ZB=-3,CUTR=10,FED=100", "WID must be at most twice CUTR (25, 10)"),
                ("SLOTP", "PA=P1,PB=P1,WID=12,ZB=-3,CUTR=10,FED=100", "PA and PB are one place"),
                ("FACMIL", "XA=0,YA=0,XB=100,YB=90,ZT=0,CUTR=50,FED=100,WOC=60", "WOC must be at most CUTR (60, 50)"),
                ("FACMIL", "XA=100,YA=0,XB=0,YB=90,ZT=0,CUTR=50,FED=100", "XB must be more than XA (0, 100)"),
                ("THRMIL", "CP=P0,DIA=24,PIT=-3,DEP=20,CUTR=16,FED=100", "PIT must be above 0 (-3)"),
                ("THRMIL", "CP=P0,DIA=16,PIT=3,DEP=20,CUTR=16,FED=100", "DIA must be more than CUTR (16, 16)"),
                ("THRMIL", "CP=P0,DIA=24,PIT=3,DEP=20,CUTR=16,FED=100,HAND=2", "HAND must be 1 or -1 (2)"),
                ("BOLTC", "CP=P0,DIA=60,NUM=2.5,DEP=18,FED=120", "NUM must be a whole number from 1 (2.5)"),
                ("HGRID", "CP=P0,NX=3,DX=0,NY=2,DY=15,DEP=10,FED=120", "DX must not be 0")):
            self.refuses(name, arguments, "", reason)

    def test_contours_that_are_none(self):
        contour = "ZT=0,ZB=-6,CUTR=12,FED=300"
        for name, size in (("CHMCON", "CHM=2"), ("FILCON", "FIL=2")):
            for corners, reason in ((((0, 0), (9, 9)), "NUM must be a whole number from 3 (2)"),
                                    (((0, 0), (9, 9), (20, 20)), "the corners lie on one line"),
                                    (((0, 0), (0, 50), (0, 50), (80, 0)), "two neighbor corners are one place"),
                                    (((0, 0), (0, 50), (80, 50), (0, 0)), "are one place"),
                                    (((0, 0), (0, 60), (0, 30), (80, 0)), "the contour turns back at this corner")):
                self.refuses(name, f"PTS=Q,NUM={len(corners)},{size},{contour}", self.corners(*corners), reason)

    def test_no_parameter_leads_astray(self):
        """Each number of a good CALL replaced: the macro works, or it refuses with a reason; no other error, no endless loop."""
        outline = self.corners((0, 0), (0, 50), (80, 50), (80, 0))
        pocket = "ZB=-6,CUTR=10,FED=400,DOC=3,WOC=5,PLG=100,CLR=2"
        calls = {"BOLTC": "CP=P0,DIA=60,NUM=6,DEP=18,FED=120,CLR=2", "HGRID": "CP=P0,NX=3,DX=20,NY=2,DY=15,DEP=10,FED=120,CLR=2",
                 "FACMIL": "XA=0,YA=0,XB=120,YB=80,ZT=0,CUTR=50,FED=600,WOC=30,CLR=5", "RPOCK": f"XA=0,YA=0,XB=60,YB=40,ZT=0,{pocket}",
                 "CPOCK": f"CP=P0,DIA=50,{pocket}", "SLOTP": "PA=P1,PB=P2,WID=12,ZB=-6,CUTR=10,FED=300,DOC=2,PLG=99,CLR=2",
                 "CHMCON": "PTS=Q,NUM=4,CHM=5,ZT=0,ZB=-6,CUTR=12,FED=300,LED=6,DOC=6,CLR=2",
                 "FILCON": "PTS=Q,NUM=4,FIL=8,ZT=0,ZB=-6,CUTR=12,FED=300,LED=6,DOC=6,CLR=2",
                 "THRMIL": "CP=P0,DIA=24,PIT=3,DEP=20,CUTR=16,FED=200,CLR=2", "STRTUP": "TL=1,SFMIN=100,CUTR=.5,SPT=P0"}
        for name, good in calls.items():
            for i, item in enumerate(good.split(",")):
                word, value = item.split("=")
                if not value.lstrip("-.").isdigit() and not value.replace(".", "", 1).lstrip("-").isdigit():
                    continue
                for bad in ("0", "-3", ".5", "3.7", "500"):
                    items = good.split(",")
                    items[i] = f"{word}={bad}"
                    self.write("a.apt", f"UNITS/MM\n{POINTS}{outline}LIBRY/{name}\nFROM/0,0,50\nCALL/{name},{','.join(items)}\nFINI\n")
                    code = self.run_arelem("compile", "a.apt", "--to", "json", "--max-steps", "200000")
                    array = word == "NUM" and "E0409" in self.err  # more corners than the array has
                    self.assertTrue((code == 0 and "error" not in self.err) or "E0496" in self.err or array, (name, items, self.err))
                    self.assertNotIn("E0401", self.err)
                    self.assertNotIn("E0571", self.err)

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
        self.refuses("CHMCON", "PTS=Q,NUM=6,CHM=12,ZT=0,ZB=-6,CUTR=8,FED=300", self.corners(*outline), "CHM does not fit on a side")
        self.refuses("CHMCON", "PTS=Q,NUM=6,CHM=2,ZT=0,ZB=-6,CUTR=12,FED=300", self.corners(*outline), "does not fit into this inner corner")

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
        self.refuses("FILCON", "PTS=Q,NUM=6,FIL=16,ZT=0,ZB=-6,CUTR=12,FED=300", outline, "the radius does not fit")

    def refuses(self, name, arguments, more, reason):
        self.write("a.apt", f"UNITS/MM\n{POINTS}{more}LIBRY/{name}\nFROM/0,0,50\nCALL/{name},{arguments}\nFINI\n")
        self.assertNotEqual(0, self.run_arelem("compile", "a.apt", "--to", "json"))
        self.assertIn("a.apt:", self.err)
        self.assertIn("error[E0496]", self.err)
        self.assertIn(reason, self.err)

    def test_contour_in_passes(self):
        outline = ("CUTTER/10\nL1=LINE/0,0,0,50\nL2=LINE/0,50,80,50\nL3=LINE/80,50,80,0\nL4=LINE/80,0,0,0\nCONPS=PLANE/0,0,1,0\n"
                   "OUTLN=MACRO/\nRAPID\nGOTO/-30,-30,5\nGO/TO,L1,TO,CONPS,PAST,L4\nINDIRV/0,1,0\nTLLFT,GOFWD/L1,PAST,L2\n"
                   "GORGT/L2,PAST,L3\nGORGT/L3,PAST,L4\nGORGT/L4,PAST,L1\nRAPID\nGODLTA/0,0,20\nTERMAC\n")
        points = self.call("CONPAS", "PATH=OUTLN,ZT=0,ZB=-9,DOC=4.5,FED=300,NRO=2,STK=2,FIN=.5", outline)
        seen = sorted({(p[2], round(p[0], 6)) for p in points if p[2] < 0 and p[0] < 0})
        self.assertEqual(seen, [(-9, -7.5), (-9, -5.5), (-9, -5), (-4.5, -7.5), (-4.5, -5.5)])

def away(p, a, b):
    dx, dy = b[0] - a[0], b[1] - a[1]
    t = max(0.0, min(1.0, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / ((dx * dx + dy * dy) or 1.0)))
    return math.hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy)


if __name__ == "__main__":
    unittest.main()
