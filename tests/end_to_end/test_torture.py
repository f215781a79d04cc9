"""Tangent, nearly tangent and concave cases of continuous motion: what a pencil gives, and the certificate."""
import json
import math
import unittest

from arelem_run import ArelemCase

HEAD = "PARTNO TORTURE\n"
SIN30, COS30 = 0.5, math.sqrt(0.75)


class Torture(ArelemCase):
    def run_program(self, text):
        """Codes of the errors, and the points of every motion record."""
        self.write("t.apt", HEAD + text + "FINI\n")
        self.run_arelem("compile", "t.apt", "--to", "json", "-o", "-", "--diagnostics", "json")
        faults = [json.loads(l) for l in self.err.splitlines() if l.startswith("{")]
        records = [json.loads(l) for l in self.out.splitlines()]
        statements = {}
        for record in records:
            if record["type"] == 5000:
                statements.setdefault(record["isn"], []).extend(record["points"])
        motions = list(statements.values())
        return [f for f in faults if f["severity"] == "error"], motions

    def paths(self, text):
        """The points of the motions of a program that must compute and be proven."""
        errors, motions = self.run_program(text)
        self.assertEqual(errors, [])
        self.assertExit(0, "verify", "t.apt")
        return motions

    def end(self, text):
        return self.paths(text)[-1][-1][:3]

    def refusal(self, text):
        errors, _ = self.run_program(text)
        self.assertEqual(len(errors), 1, errors)
        return errors[0]

    def assertPlace(self, place, expected, allowed=1e-9):
        for a, b in zip(place, expected):
            self.assertAlmostEqual(a, b, delta=allowed, msg=f"{place} instead of {expected}")


class Tangent(Torture):
    LINE = "{mode}INTOL/0\nOUTTOL/.001\nCUTTER/2\nL1=LINE/0,0,1,0\nC1=CIRCLE/10,{y!r},3\nFROM/0,-5,0\n" \
           "GO/TO,L1\nTLRGT,GORGT/L1,{condition},C1\n"

    def test_nests_of_copies_are_counted_before_they_are_written(self):
        # 10^15 locations: the innermost COPY is 100 000, the next would be 10^10
        self.write("a.apt", "INDEX/1\nINDEX/2\nINDEX/3\nGOTO/1,2,3\nCOPY/3,SAME,100000\nCOPY/2,SAME,100000\nCOPY/1,SAME,100000\nFINI\n")
        self.assertExit(7, "compile", "a.apt", "-o", "a.cls")
        self.assertIn("a.apt:6:1: error[E0803]", self.err)
        self.assertEqual(self.files(), ["a.apt"])

    def test_nearly_touched_circle_is_reported_with_its_closest_approach(self):
        # The cutter of radius 1 runs below y = 0, the circle of radius 3 begins at y = 3 - 0.003 below its center.
        for mode in ("", "3DCALC\n"):
            error = self.refusal(self.LINE.format(mode=mode, y=3.003, condition="TO"))
            self.assertEqual(error["code"], "E0508")
            self.assertIn("0.003", error["message"])
            self.assertIn("10", error["message"])

    def test_a_circle_touched_within_the_tolerance_is_met(self):
        # 0.0006 away from the cutter: within OUTTOL.
        for mode in ("", "3DCALC\n"):
            self.assertPlace(self.end(self.LINE.format(mode=mode, y=3.0006, condition="TO")), (10, -1, 0), 0.002)

    def test_a_circle_cut_by_a_hair_has_two_positions(self):
        # Centers 4 - 0.01 apart across the path, 4 in all at the stops.
        half = math.sqrt(4 ** 2 - 3.99 ** 2)
        for mode in ("", "3DCALC\n"):
            for condition, x in (("TO", 10 - half), ("PAST", 10 + half)):
                place = self.end(self.LINE.format(mode=mode, y=2.99, condition=condition))
                # A gap of a tenth of the band is this much of the way at the angle at which they meet.
                self.assertPlace(place, (x, -1, 0), 1e-9 if not mode else 0.001 / (half / 4))

    def test_line_into_circle_and_circle_into_circle(self):
        text = "{mode}CUTTER/1\nOUTTOL/.001\nL1=LINE/0,0,1,0\nC1=CIRCLE/10,5,5\nC2=CIRCLE/10,15,5\nL2=LINE/0,15,1,15\n" \
               "FROM/0,-3,0\nGO/TO,L1\nTLRGT,GORGT/L1,TANTO,C1\nGOFWD/C1,TANTO,C2\n"
        motions = self.paths(text.format(mode=""))
        self.assertPlace(motions[-2][-1], (10, -0.5, 0))
        self.assertPlace(motions[-1][-1], (10, 10.5, 0))  # above (10, 10), where the circles touch
        motions = self.paths(text.format(mode="3DCALC\n"))
        x, y, z = motions[-1][-1][:3]
        self.assertPlace((x, z), (10, 0))
        self.assertTrue(10.5 <= y <= 10.501, y)  # within the band of C1

    def test_a_tangency_is_the_same_for_every_kind(self):
        # Surfaces that touch the plane y = 0 in (10, 0) or (10, 0, z): the tool of radius 1 below it ends at (10, -1).
        k = 3 * math.sqrt(0.5)
        standing = f"1,0,0,1,0,-1,0,0,10,0,-1,0,3,0,-9,20,{-k!r},0,0,0,0,0,0,0,{k!r},0,0,0,0,0,0,0,{-k!r},0,0,0,0,0,0,0," \
                   f"{-k!r},0,0,0,0,0,0,0,{k!r},0,0,0,0,0,0,0,{k!r},0,0,0,0,0,0,0,{math.sqrt(0.5)!r}" + ",0" * 14
        kinds = ("CIRCLE/10,3,3", "CYLNDR/10,3,0,0,0,1,3", "QADRIC/1,1,0,0,0,0,-20,-6,0,100",
                 "ELLIPS/CENTER,(POINT/10,2,0),5,2,0", "SPHERE/10,3,0,3", "TORUS/10,5,1,0,0,1,3,2", "POLCON/CANON," + standing)
        for kind in kinds:
            card = "$\n".join(part + "," for part in kind.split(",")).rstrip(",")
            text = f"3DCALC\nCUTTER/2\nOUTTOL/.0001\nL1=LINE/0,0,10,0\nCS={card}\nFROM/0,-1,0\nINDIRV/1,0,0\n" \
                   "TLRGT,GOFWD/L1,TANTO,CS\n"
            with self.subTest(kind[:6]):
                self.assertPlace(self.end(text), (10, -1, 0))

    def test_sphere_into_its_tangent_plane(self):
        # PSTAN: the ball of radius 0.5 rolls over the cylinder of radius 5 until it lies on the plane whose normal leans 30
        # degrees. Its center is then 5.5 from the cylinder's axis in that direction, and the .8 of OUTTOL by which it rests
        # above the cylinder, a tenth of the band inside its edge.
        text = "INTOL/.0001\nOUTTOL/.0001\nCUTTER/1,.5\nPS1=CYLNDR/0,0,-5,0,1,0,5\n" \
               f"PL1=PLANE/{SIN30!r},0,{COS30!r},{5 - 5 * COS30!r}\nDS1=PLANE/0,1,0,0\nX0=PLANE/1,0,0,0\n" \
               "FROM/0,0,2\nGO/ON,DS1,TO,PS1,ON,X0\nINDIRV/1,0,0\nTLON,GOFWD/DS1,PSTAN,PL1\n"
        self.assertPlace(self.end(text), (5.50008 * SIN30, 0, 5.50008 * COS30 - 5 - 0.5))

    def test_motion_along_the_crossing_of_nearly_parallel_planes(self):
        # One degree apart: x of the crossing follows from z = 0 and z = (x - 2) tan 1.
        slope = math.tan(math.radians(1))
        text = "INTOL/.001\nOUTTOL/.001\n3DCALC\nCUTTER/0\nPS1=PLANE/0,0,1,0\n" \
               f"DS1=PLANE/{-slope!r},0,1,{-2 * slope!r}\nY0=PLANE/0,1,0,0\nY9=PLANE/0,1,0,9\nFROM/0,0,1\n" \
               "GO/ON,DS1,ON,PS1,ON,Y0\nINDIRV/0,1,0\nTLON,TLONPS,GOFWD/DS1,ON,Y9\n"
        self.assertPlace(self.end(text), (2, 9, 0), 1e-9)


class Concave(Torture):
    def test_a_sharp_hollow_makes_a_corner_of_the_path(self):
        # x^2 - y^2 = 0.01 and a cutter of radius 1: on the axis of the hyperbola it touches both arms with its center
        # at 2 x0, where x0^2 + y0^2 = 1 and x0^2 - y0^2 = 0.01. The path turns there by almost a right angle.
        text = "3DCALC\nINTOL/.001\nOUTTOL/.001\nMAXDP/5\nCUTTER/2\nDS1=QADRIC/1,-1,0,0,0,0,0,0,0,-0.01\n" \
               "PS1=PLANE/0,0,1,0\nY4=PLANE/0,1,0,4\nYN4=PLANE/0,1,0,-4\nFROM/9,4,1\nINDIRV/-1,0,0\n" \
               "GO/TO,DS1,TO,PS1,ON,Y4\nINDIRV/-1,-1,0\nTLLFT,GOFWD/DS1,ON,YN4\n"
        points = self.paths(text)[-1]
        self.assertAlmostEqual(min(p[0] for p in points), 2 * math.sqrt(1.01 / 2), delta=0.002)
        self.assertLess(len(points), 10)

    def test_a_hollow_hardly_wider_than_the_cutter(self):
        # The cutter of radius 1 in a hole of radius 1.05: its center runs on a circle of radius 0.05.
        text = "3DCALC\nINTOL/.0005\nOUTTOL/.0005\nCUTTER/2\nDS1=CYLNDR/0,0,0,0,0,1,1.05\nPS1=PLANE/0,0,1,0\n" \
               "X0=PLANE/1,0,0,0\nY0=PLANE/0,1,0,0\nFROM/.01,0,0\nINDIRV/1,0,0\nGO/TO,DS1,TO,PS1,ON,Y0\n" \
               "INDIRV/0,1,0\nTLLFT,GOFWD/DS1,ON,X0\n"
        for place in self.paths(text)[-1]:
            self.assertAlmostEqual(math.hypot(place[0], place[1]), 0.05, delta=0.0005 + 1e-6)
        self.assertPlace(self.paths(text)[-1][-1], (0, 0.05, 0), 0.0005)

    def test_a_hollow_narrower_than_the_cutter_is_refused(self):
        text = "3DCALC\nCUTTER/2\nDS1=CYLNDR/0,0,0,0,0,1,0.95\nPS1=PLANE/0,0,1,0\nY0=PLANE/0,1,0,0\nFROM/.01,0,0\n" \
               "INDIRV/1,0,0\nGO/TO,DS1,TO,PS1,ON,Y0\n"
        error = self.refusal(text)
        self.assertEqual(error["code"], "E0521")
        self.assertIn("0.95", error["message"])

    def test_ball_in_a_groove_of_two_cylinders(self):
        # A ball of radius 0.5 between cylinders of radius 2 at y = +-2.4: its center is 2.5 from both axes.
        text = "INTOL/.0001\nOUTTOL/.0001\nCUTTER/1,.5\nPS1=CYLNDR/0,-2.4,0,1,0,0,2\nDS1=CYLNDR/0,2.4,0,1,0,0,2\n" \
               "X0=PLANE/1,0,0,0\nX9=PLANE/1,0,0,9\nFROM/0,0,3\nGO/TO,DS1,TO,PS1,ON,X0\nINDIRV/1,0,0\n" \
               "TLRGT,GOFWD/DS1,ON,X9\n"
        motions = self.paths(text)
        self.assertPlace(motions[-1][-1], (9, 0, math.sqrt(2.5 ** 2 - 2.4 ** 2) - 0.5), 0.002)
        self.assertEqual(len(motions[-1]), 1)

    def test_both_rims_of_a_cutter_in_a_leaning_hollow(self):
        # The hole leans: at the start the upper rim of the cutter touches, at the end the lower one. Proven, so the
        # contact of the whole cutter was found everywhere.
        self.paths("MULTAX\n3DCALC\nINTOL/.001\nOUTTOL/.001\nCUTTER/1,.5\nPS1=PLANE/0,0,1,0\n"
                   "DS1=CYLNDR/0,0,0,.1,0,1,6\nY0=PLANE/0,1,0,0\nFROM/1,0,3\nINDIRV/1,0,0\nGO/TO,DS1,TO,PS1,ON,Y0\n"
                   "INDIRV/0,1,0\nTLLFT,GOFWD/DS1,2,INTOF,ON,Y0\n")


class Tips(Torture):
    """A cone that points at the tool, and a tool that points into a hollow."""
    HEAD = "MULTAX\n3DCALC\nINTOL/.002\nOUTTOL/.002\nCUTTER/{cutter}\nPS1=CONE/(POINT/0,0,0),(VECTOR/0,0,-1),60\n" \
           "DS1=PLANE/0,1,0,{y}\nX1=PLANE/1,0,0,-4\nX2=PLANE/1,0,0,4\n" \
           "FROM/-4,{y},3\nGO/ON,DS1,TO,PS1,ON,X1\nINDIRV/1,0,0\nTLON,GOFWD/DS1,ON,X2\n"

    def test_a_cutter_over_the_tip_of_a_cone(self):
        # The cone falls by 1 / tan 60 a unit. A flat end of radius 0.5 at height 0 covers the tip while the tool is nearer
        # to it; else its rim touches, 0.5 nearer to the cone's axis than the tool is.
        for cutter, radius in (("1", .5), ("1,.2", .3)):
            for y in (0.0, 0.3):
                points = self.paths(self.HEAD.format(cutter=cutter, y=y))[-1]
                for x, _, z in (p[:3] for p in points):
                    away = max(0.0, math.hypot(x, y) - radius)
                    if cutter == "1":
                        self.assertAlmostEqual(z, -away / math.tan(math.radians(60)), delta=.002 / SIN30 + 1e-9)
                self.assertGreater(max(p[2] for p in points), -0.003)
                self.assertLess(len(points), 40)

    def test_every_cutter_over_the_tip(self):
        for cutter in ("1,.5", ".8,.1,.313071,.1,0,8,4", "1,0,0,0,30,0,4", "0"):
            for y in (0.0, 0.3):
                self.paths(self.HEAD.format(cutter=cutter, y=y))

    def test_a_drill_in_a_hollow_as_steep_as_its_point(self):
        # A hollow cylinder of radius 9: where it leans 30 degrees the point and the rim of the drill touch at once.
        text = "MULTAX\n3DCALC\nINTOL/.002\nOUTTOL/.002\nCUTTER/1,0,0,0,30,0,4\nPS1=CYLNDR/0,0,9,0,1,0,9\n" \
               "DS1=PLANE/0,1,0,.3\nX1=PLANE/1,0,0,-6\nX2=PLANE/1,0,0,6\nFROM/-4,2,3.2\n" \
               "GO/ON,DS1,TO,PS1,ON,X1\nINDIRV/1,0,0\nTLON,GOFWD/DS1,ON,X2\n"
        rise = 0.5 * math.tan(math.radians(30))
        for x, _, z in (p[:3] for p in self.paths(text)[-1]):
            gap = min(9 - math.hypot(x, 9 - z), 9 - math.hypot(abs(x) + .5, 9 - z - rise))
            self.assertTrue(-.002 - 1e-9 <= gap <= .002 + 1e-9, (x, z, gap))


class ManyTurns(Torture):
    def test_positions_on_a_closed_path_are_counted(self):
        text = "CUTTER/1\nOUTTOL/.001\n{mode}DS1=CYLNDR/0,0,0,0,0,1,3\nPS1=PLANE/0,0,1,0\nX0=PLANE/1,0,0,0\n" \
               "Y0=PLANE/0,1,0,0\nFROM/0,-9,0\nINDIRV/0,1,0\nGO/TO,DS1,TO,PS1,ON,X0\nTLLFT,GORGT/DS1,ON,{n},INTOF,Y0\n"
        for mode in ("", "3DCALC\n"):
            for n, x in ((1, 3.5), (2, -3.5), (3, 3.5)):
                self.assertPlace(self.end(text.format(mode=mode, n=n)), (x, 0, 0), 0.001)


if __name__ == "__main__":
    unittest.main()
