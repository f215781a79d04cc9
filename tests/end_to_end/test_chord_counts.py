"""Cut vectors along circular sections: not more than 1.02 times what the band permits.

The tool end runs round a center between two radii: cut vectors end on the larger and touch the smaller one. What the
band permits is counted from the place where the motion begins to where it ends, both known from its path.
"""
import json
import math
import unittest

from arelem_run import ArelemCase

SHARE = 1.02


def permitted(first, last, small, large, angle):
    """The least number of chords over `angle` from radius `first` to `last`, between two radii."""
    from_first, between, to_last = (math.acos(min(1, small / r)) for r in (first, large, last))
    if angle <= from_first + to_last:
        return 1
    # The first and the last one reach from an end, the others from the large radius to itself.
    rest = angle - (from_first + between) - (between + to_last)
    return 2 + max(0, math.ceil(rest / (2 * between) - 1e-9))


class ChordCounts(ArelemCase):
    def path(self, *lines, route="3DCALC"):
        self.write("c.apt", "\n".join(["PARTNO COUNT", route, "MAXDP/100", "NUMPTS/100000", *lines, "FINI", ""]))
        self.assertExit(0, "compile", "c.apt", "--to", "json", "-o", "-")
        statements = {}
        for record in map(json.loads, self.out.splitlines()):
            if record["type"] == 5000:
                statements.setdefault(record["isn"], []).extend(record["points"])
        *_, start, motion = statements.values()
        self.assertExit(0, "verify", "c.apt")
        return start[-1], motion

    def check(self, lines, radius_of, angle_of, small, large, route="3DCALC"):
        start, motion = self.path(*lines, route=route)
        places = [start, *motion]
        swept = sum(abs(math.remainder(angle_of(b) - angle_of(a), 2 * math.pi)) for a, b in zip(places, places[1:]))
        least = permitted(radius_of(start), radius_of(motion[-1]), small, large, swept)
        self.assertGreater(least, 15)
        self.assertLessEqual(len(motion), SHARE * least, f"{len(motion)} cut vectors, {least} permitted")
        self.assertGreaterEqual(len(motion), least, "fewer than the geometry permits: the test is wrong")

    BANDS = ((0, 0.001), (0.001, 0), (0.0005, 0.0005), (0.0001, 0.0002), (0.0019, 0.0001), (0, 0.00002))

    def check_round(self, band, start, side, radius):
        """Round a cylinder of radius 5 about the z-axis, from below it or from within."""
        inner, outer = band
        lines = (f"INTOL/{inner:.5f}", f"OUTTOL/{outer:.5f}", "CUTTER/1", "DS1=CYLNDR/0,0,0,0,0,1,5", "PS1=PLANE/0,0,1,0",
                 "X0=PLANE/1,0,0,0", "Y0=PLANE/0,1,0,0", *start, "GO/TO,DS1,TO,PS1,ON,X0", side + "/DS1,ON,3,INTOF,Y0")
        self.check(lines, lambda p: math.hypot(p[0], p[1]), lambda p: math.atan2(p[1], p[0]), *radius)

    def test_round_a_cylinder(self):
        for inner, outer in self.BANDS:
            self.check_round((inner, outer), ("FROM/0,-9,0", "INDIRV/0,1,0"), "TLLFT,GORGT", (5.5 - inner, 5.5 + outer))

    def test_in_a_hole(self):
        for inner, outer in self.BANDS:
            self.check_round((inner, outer), ("FROM/0,-3,0", "INDIRV/0,-1,0"), "TLRGT,GOLFT", (4.5 - outer, 4.5 + inner))

    def test_circles_of_the_plane_route(self):
        # The circle keeps the radius on which the tool stands and is divided evenly: one cut vector more than the least.
        for inner, outer in self.BANDS:
            for start, words, radius in ((("FROM/0,-9,0", "INDIRV/0,1,0"), "TLLFT,GORGT", (5.5 - inner, 5.5 + outer)),
                                         (("FROM/0,-3,0", "INDIRV/0,-1,0"), "TLRGT,GOLFT", (4.5 - outer, 4.5 + inner))):
                lines = (f"INTOL/{inner:.5f}", f"OUTTOL/{outer:.5f}", "CUTTER/1", "C1=CIRCLE/0,0,5", "PS1=PLANE/0,0,1,0",
                         *start, "GO/TO,C1,TO,PS1", words + "/C1,ON,3,INTOF,(LINE/0,0,1,0)")
                self.check(lines, lambda p: math.hypot(p[0], p[1]), lambda p: math.atan2(p[1], p[0]), *radius,
                           route="2DCALC")

    def test_round_a_cone(self):
        # The rim of a flat cutter on a cone of 30 degrees: a gap of t is t / cos 30 of the way outwards.
        cos = math.cos(math.radians(30))
        for inner, outer in self.BANDS:
            lines = (f"INTOL/{inner:.5f}", f"OUTTOL/{outer:.5f}", "CUTTER/1", "DS1=CONE/(POINT/0,0,9),(VECTOR/0,0,-1),30",
                     "PS1=PLANE/0,0,1,0", "X0=PLANE/1,0,0,0", "Y0=PLANE/0,1,0,0", "FROM/0,-9,0", "INDIRV/0,1,0",
                     "GO/TO,DS1,TO,PS1,ON,X0", "TLLFT,GORGT/DS1,ON,3,INTOF,Y0")
            path = 9 * math.tan(math.radians(30)) + 0.5
            self.check(lines, lambda p: math.hypot(p[0], p[1]), lambda p: math.atan2(p[1], p[0]), path - inner / cos,
                       path + outer / cos)

    def test_over_a_sphere(self):
        # A ball of radius 0.5 over a sphere of radius 8, in the plane y = 2: its center is 8.5 away.
        for inner, outer in self.BANDS:
            lines = (f"INTOL/{inner:.5f}", f"OUTTOL/{outer:.5f}", "CUTTER/1,.5", "PS1=SPHERE/0,0,0,8", "DS1=PLANE/0,1,0,2",
                     "X1=PLANE/1,0,0,-6", "X2=PLANE/1,0,0,6", "FROM/-6,2,9", "GO/ON,DS1,TO,PS1,ON,X1", "INDIRV/1,0,0",
                     "TLON,GOFWD/DS1,ON,X2")
            self.check(lines, lambda p: math.hypot(p[0], p[2] + 0.5), lambda p: math.atan2(p[2] + 0.5, p[0]),
                       math.sqrt((8.5 - inner) ** 2 - 4), math.sqrt((8.5 + outer) ** 2 - 4))

    def test_over_a_lying_cylinder(self):
        for inner, outer in self.BANDS:
            lines = (f"INTOL/{inner:.5f}", f"OUTTOL/{outer:.5f}", "CUTTER/1,.5", "PS1=CYLNDR/0,0,0,0,1,0,8", "DS1=PLANE/0,1,0,2",
                     "X1=PLANE/1,0,0,-6", "X2=PLANE/1,0,0,6", "FROM/-6,2,9", "GO/ON,DS1,TO,PS1,ON,X1", "INDIRV/1,0,0",
                     "TLON,GOFWD/DS1,ON,X2")
            self.check(lines, lambda p: math.hypot(p[0], p[2] + 0.5), lambda p: math.atan2(p[2] + 0.5, p[0]),
                       8.5 - inner, 8.5 + outer)

    def test_over_a_torus(self):
        # Along the top meridian of a tube of radius 3: in the plane y = 0 the section is its circle.
        for inner, outer in self.BANDS:
            lines = (f"INTOL/{inner:.5f}", f"OUTTOL/{outer:.5f}", "CUTTER/1,.5", "PS1=TORUS/0,0,0,0,0,1,9,3", "DS1=PLANE/0,1,0,0",
                     "X1=PLANE/1,0,0,7", "X2=PLANE/1,0,0,11", "FROM/7,0,9", "GO/ON,DS1,TO,PS1,ON,X1", "INDIRV/1,0,0",
                     "TLON,GOFWD/DS1,ON,X2")
            self.check(lines, lambda p: math.hypot(p[0] - 9, p[2] + 0.5), lambda p: math.atan2(p[2] + 0.5, p[0] - 9),
                       3.5 - inner, 3.5 + outer)


if __name__ == "__main__":
    unittest.main()
