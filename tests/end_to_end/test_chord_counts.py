"""Cut vectors along circular sections: not more than 1.02 times what the band permits.

The tool end runs round a center between two radii: cut vectors end on the larger and touch the smaller one. What the
band permits is counted from the place where the motion begins to where it ends, both known from its path.
"""
import bisect
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


class AgainstAGreedyProgram(ArelemCase):
    """Sections whose bend changes, beside the count of a program that tries: from four depths of the band at once it looks for the
    farthest place at each depth that a straight cut vector reaches, and counts how many it takes."""

    LEVELS = 4
    SAMPLES = 16

    def fewest(self, gap, start, end, low, high):
        """`gap` of a tool at (x, z); from `start` to `end`, both (x, z), within low and high."""
        def height(x, wanted, near):
            below, above = near - 3.0, near + 3.0
            for _ in range(40):
                middle = (below + above) / 2
                below, above = (middle, above) if gap(x, middle) < wanted else (below, middle)
            return (below + above) / 2

        def fits(a, b):
            return all(low - 1e-9 <= gap(a[0] + (b[0] - a[0]) * k / self.SAMPLES, a[1] + (b[1] - a[1]) * k / self.SAMPLES) <= high + 1e-9
                       for k in range(1, self.SAMPLES))

        depths = [low + (high - low) * k / (self.LEVELS - 1) for k in range(self.LEVELS)]
        front, count = [start], 1
        while not any(fits(place, end) for place in front):
            farthest = []
            for depth in depths:
                best = None
                for place in front:
                    near, far = best[0] if best else place[0], end[0]
                    for _ in range(12):
                        x = (near + far) / 2
                        there = (x, height(x, depth, place[1]))
                        if fits(place, there):
                            near, best = x, there
                        else:
                            far = x
                if best:
                    farthest.append(best)
            front, count = farthest, count + 1
            self.assertLess(count, 1000)
        return count

    def check(self, surface, y, first, last, gap):
        for inner, outer in ((0, 0.002), (0.002, 0), (0.001, 0.001)):
            with self.subTest(f"{surface} {inner} {outer}"):
                self.write("g.apt", "\n".join(["3DCALC", "MAXDP/100", "NUMPTS/10000", "CUTTER/1,.5", f"INTOL/{inner}", f"OUTTOL/{outer}",
                           surface, f"DS=PLANE/0,1,0,{y}", f"FROM/{first},{y},12", f"GO/ON,DS,TO,PS,ON,(PLANE/1,0,0,{first})",
                           "INDIRV/1,0,0", f"TLON,GOFWD/DS,ON,(PLANE/1,0,0,{last})", "FINI", ""]))
                self.assertExit(0, "verify", "g.apt")
                self.assertExit(0, "compile", "g.apt", "--to", "json", "-o", "-")
                places = [(p[0], p[2]) for r in map(json.loads, self.out.splitlines()) for p in r.get("points", [])][1:]
                least = self.fewest(gap, places[0], places[-1], -inner, outer)
                self.assertGreater(least, 8)
                self.assertLessEqual(len(places) - 1, max(SHARE * least, least + 1), f"{len(places) - 1} cut vectors, {least} found by trying")

    def test_beside_the_middle_of_a_cone(self):
        # Vertex at z = 10, half angle 45 degrees: a hyperbola in the plane y = 3.
        self.check("PS=CONE/(POINT/0,0,10),(VECTOR/0,0,-1),45", 3, -5, 6,
                   lambda x, z: (math.hypot(x, 3) - (9.5 - z)) * math.sqrt(0.5) - 0.5)

    def test_beside_the_middle_of_a_torus(self):
        self.check("PS=TORUS/0,0,0,0,0,1,9,3", 4, 4, 9.5, lambda x, z: math.hypot(math.hypot(x, 4) - 9, z + 0.5) - 3.5)

    def test_across_a_parabola(self):
        def gap(x, z):
            if z + 0.5 < x * x / 8:
                return z - 9  # below the curve: only the sign counts
            low, high = x - 1.5, x + 1.5  # the foot at (u, u^2 / 8): the distance falls towards it from either side
            for _ in range(26):
                left, right = low + 0.382 * (high - low), high - 0.382 * (high - low)
                nearer = math.hypot(x - left, z + 0.5 - left * left / 8) < math.hypot(x - right, z + 0.5 - right * right / 8)
                low, high = (low, right) if nearer else (left, high)
            u = (low + high) / 2
            return math.hypot(x - u, z + 0.5 - u * u / 8) - 0.5

        self.check("PS=QADRIC/1,0,0,0,0,0,0,0,-8,0", 0, -6, 5, gap)

    def test_over_a_tabulated_sine_beside_a_drawn_one(self):
        """The curve is taken from a point that follows it with a tolerance of a thousandth of the band."""
        points = ",".join(f"(POINT/{x},0,{math.sin(x / 2):.6f})" for x in range(-5, 6))
        curve = f"PS=TABCYL/NOY,SPLINE,{points}"
        self.write("t.apt", "\n".join(["3DCALC", "NUMPTS/100000", "CUTTER/0", "OUTTOL/.000002", curve, "DS=PLANE/0,1,0,0", "FROM/-4.5,0,9",
                   "GO/ON,DS,TO,PS,ON,(PLANE/1,0,0,-4.5)", "INDIRV/1,0,0", "TLON,GOFWD/DS,ON,(PLANE/1,0,0,4.5)", "FINI", ""]))
        self.assertExit(0, "compile", "t.apt", "--to", "json", "-o", "-")
        line = [(p[0], p[2]) for r in map(json.loads, self.out.splitlines()) for p in r.get("points", [])][1:]

        def gap(x, z):
            near = bisect.bisect_left(line, (x,))
            if z + 0.5 < line[min(near, len(line) - 1)][1]:
                return z - 9  # below the curve: only the sign counts
            # The foot lies where the way to the tool's center is square to the curve, which is nowhere steep.
            low, high = max(near - 120, 1), min(near + 120, len(line) - 2)
            while low < high:
                k = (low + high) // 2
                a, b = line[k], line[k + 1]
                low, high = (k + 1, high) if (x - b[0]) * (b[0] - a[0]) + (z + 0.5 - b[1]) * (b[1] - a[1]) > 0 else (low, k)
            best = 9.0
            for a, b in zip(line[low - 1:low + 2], line[low:low + 3]):
                span = (b[0] - a[0], b[1] - a[1])
                s = ((x - a[0]) * span[0] + (z + 0.5 - a[1]) * span[1]) / (span[0] ** 2 + span[1] ** 2)
                s = min(max(s, 0), 1)
                best = min(best, math.hypot(x - a[0] - s * span[0], z + 0.5 - a[1] - s * span[1]))
            return best - 0.5

        self.check(curve, 0, -3.5, 3.5, gap)


if __name__ == "__main__":
    unittest.main()
