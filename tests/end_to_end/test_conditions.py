"""Words of motion along curved drive and part surfaces: places that a pencil gives, paths that the certificate proves.

A stop lies inside the band of each surface, so the radii of the pencil are met within the tolerance TOL.
"""
import json
import math
import unittest

from arelem_run import ArelemCase

TOL = 0.0002
HEAD = ["3DCALC", "NUMPTS/9999", "CUTTER/2,1", f"OUTTOL/{TOL}"]
CYLINDER = "DS=CYLNDR/0,0,0,0,0,1,5"
FLOOR = "PS=PLANE/0,0,1,0"
START = ["FROM/0,-9,0", "GO/TO,DS,TO,PS,ON,(PLANE/1,0,0,0)", "INDIRV/1,0,0"]


class Conditions(ArelemCase):
    def path(self, *lines):
        """The locations of the program, proven."""
        self.write("c.apt", "\n".join(["PARTNO WORDS", *HEAD, *lines, "FINI", ""]))
        self.assertExit(0, "compile", "c.apt", "--to", "json", "-o", "-")
        points = [p for record in map(json.loads, self.out.splitlines()) for p in record.get("points", [])]
        self.assertExit(0, "verify", "c.apt")
        return points

    def assertNear(self, place, *wanted, within=2 * TOL):
        self.assertLess(math.dist(place, wanted), within, f"{place}, not {wanted}")

    def test_rings_of_option_on_a_sphere_a_cylinder_a_cone_and_a_torus(self):
        """A ring of radius .4 at the height 1 for the part surface: over the sphere of radius 10 its inner side is the higher one.
        One of radius 1.5 at 2 for the drive surface, another for the part surface, the whole cutter for the check surface."""
        path = self.path("CUTTER/2,.5", "CUTTER/OPTION,1,.4,1", "PS=SPHERE/0,0,-10,10", "DS=PLANE/0,1,0,0", "FROM/-4,0,5",
                         "GO/ON,DS,TO,PS,ON,(PLANE/1,0,0,-4)", "INDIRV/1,0,0", "TLON,GOFWD/DS,ON,(PLANE/1,0,0,4)")
        self.assertNear(path[-1], 4, 0, math.sqrt(100 - 3.6 ** 2) - 11)
        path = self.path("CUTTER/2,.5", "CUTTER/OPTION,1,.4,0", "CUTTER/OPTION,2,1.5,2", "DS=SPHERE/0,0,0,6", FLOOR, *START,
                         "TLRGT,GOFWD/DS,TO,(PLANE/1,0,0,5)")
        around = math.sqrt(36 - 4) + 1.5
        self.assertNear(path[1], 0, -around, 0)
        self.assertNear(path[-1], 4, -math.sqrt(around ** 2 - 16), 0)
        path = self.path("CUTTER/2,.5", "CUTTER/OPTION,2,.4,1", "DS=CYLNDR/0,0,0,1,0,0,3", FLOOR, "FROM/-4,9,0",
                         "GO/TO,DS,TO,PS,ON,(PLANE/1,0,0,-4)", "INDIRV/1,0,0", "TLRGT,GOFWD/DS,ON,(PLANE/1,0,0,4)")
        self.assertNear(path[-1], 4, math.sqrt(8) + 0.4, 0)
        path = self.path("CUTTER/2,.5", "CUTTER/OPTION,2,.4,1", "DS=CONE/(POINT/0,0,10),(VECTOR/0,0,-1),30", FLOOR, "FROM/9,0,0",
                         "GO/TO,DS,TO,PS,ON,(PLANE/0,1,0,0)", "INDIRV/0,1,0", "TLRGT,GOFWD/DS,ON,(PLANE/1,0,0,0)")
        self.assertNear(path[-1], 0, 9 * math.tan(math.radians(30)) + 0.4, 0)
        path = self.path("CUTTER/2,.5", "CUTTER/OPTION,2,.4,1", "DS=TORUS/0,0,0,0,0,1,8,2", FLOOR, "FROM/0,-15,0", START[1], START[2],
                         "TLRGT,GOFWD/DS,ON,(PLANE/0,1,0,0)")
        self.assertNear(path[-1], 8 + math.sqrt(4 - 1) + 0.4, 0, 0)

    def test_thick_counts_for_each_surface_but_not_where_the_tool_is_on_it(self):
        lines = ["THICK/.1,.2,.3", CYLINDER, "PS=SPHERE/0,0,-20,20", "FROM/0,-9,3"]
        path = self.path(*lines, START[1], START[2], "TLRGT,GOFWD/DS,TO,(PLANE/1,0,0,4)")
        height = math.sqrt(21.1 ** 2 - 6.2 ** 2) - 21
        self.assertNear(path[1], 0, -6.2, height)
        self.assertNear(path[-1], 2.7, -math.sqrt(6.2 ** 2 - 2.7 ** 2), height)
        path = self.path(*lines, "GO/ON,DS,TO,PS,ON,(PLANE/1,0,0,0)", START[2], "TLON,GOFWD/DS,TO,(PLANE/1,0,0,4)")
        self.assertNear(path[-1], 2.7, -math.sqrt(25 - 2.7 ** 2), math.sqrt(21.1 ** 2 - 25) - 21)

    def test_no_cut_vector_is_longer_than_maxdp(self):
        for drive, longest in (("SPHERE/0,0,0,5", 0.05), ("CONE/(POINT/0,0,20),(VECTOR/0,0,-1),20", 0.05), ("TORUS/0,0,0,0,0,1,8,2", 0.03)):
            path = self.path(f"MAXDP/{longest}", f"DS={drive}", FLOOR, "FROM/0,-15,0", *START[1:], "TLRGT,GOFWD/DS,ON,(PLANE/1,0,0,2)")
            lengths = [math.dist(a, b) for a, b in zip(path[1:], path[2:])]
            self.assertLessEqual(max(lengths), longest * (1 + 1e-4), drive)
            self.assertGreater(sorted(lengths)[len(lengths) // 2], longest * 0.999, drive)

    def test_positions_are_counted_round_a_cylinder(self):
        """The tool runs at the radius 6: it is TO y = 2 at y = 1, ON it at 2, PAST it at 3, on either side."""
        for condition, nth, y, side in (("TO", 1, 1, 1), ("PAST", 1, 3, 1), ("TO", 2, 3, -1), ("PAST", 2, 1, -1), ("ON", 1, 2, 1),
                                        ("ON", 2, 2, -1), ("ON", 3, 2, 1)):
            with self.subTest(f"{condition} {nth}"):
                path = self.path(CYLINDER, FLOOR, *START, f"TLRGT,GOFWD/DS,{condition},{nth},INTOF,(PLANE/0,1,0,2)")
                self.assertNear(path[-1], side * math.sqrt(36 - y * y), y, 0)

    def test_the_label_of_the_surface_that_is_met_first(self):
        """Round a torus at the height of its center circle to a sphere on the one side or a cylinder on the other."""
        torus = ["DS=TORUS/0,0,0,0,0,1,8,2", FLOOR, "CA=SPHERE/12,0,0,1", "CB=CYLNDR/-13,0,0,0,0,1,2", "FROM/0,-15,0", START[1]]
        for turn, height in (("INDIRV/1,0,0\nTLRGT,GOFWD", 5), ("INDIRV/-1,0,0\nTLLFT,GOFWD", 6)):
            path = self.path(*torus, f"{turn}/DS,TO,CA,L1,TO,CB,L2", "L1)GODLTA/0,0,5", "TRANTO/E", "L2)GODLTA/0,0,6", "E)GODLTA/0,0,1")
            stop, lifted = path[-3], path[-2]
            self.assertNear(lifted, stop[0], stop[1], stop[2] + height, within=1e-9)
            # The center of the ball is 1 above the torus circle and 3 from it, 2 from the center of the sphere, 3 from the axis
            # of the cylinder.
            self.assertAlmostEqual(math.hypot(stop[0], stop[1]), 8 + math.sqrt(8), delta=2 * TOL)
            away = math.hypot(stop[0] - 12, stop[1]) if height == 5 else math.hypot(stop[0] + 13, stop[1])
            self.assertAlmostEqual(away, math.sqrt(3) if height == 5 else 3, delta=3 * TOL)

    def test_autops_nops_and_dntcut_at_a_sphere_and_a_cone(self):
        """The ball of radius 1 whose center is 2 above that of the sphere of radius 8: sqrt(81 - 4) from its axis."""
        sphere = ["DS=SPHERE/0,0,0,8", "PS=PLANE/0,0,1,1", "FROM/0,-15,3"]
        path = self.path(*sphere, "DNTCUT", *START[1:], "TLRGT,GOFWD/DS,ON,(PLANE/0,1,0,0)", "CUT", "GOFWD/DS,ON,(PLANE/1,0,0,0)")
        self.assertNear(path[1], math.sqrt(77), 0, 1)
        self.assertNear(path[-1], 0, math.sqrt(77), 1)
        # NOPS: along the normal through the middle of the tool, 2.5 above its end; then AUTOPS keeps that height.
        path = self.path("DS=SPHERE/0,0,0,8", "FROM/0,-15,-1", "NOPS", "INDIRV/0,1,0", "GO/TO,DS", "AUTOPS", "INDIRV/1,0,0",
                         "TLRGT,GOFWD/DS,ON,(PLANE/0,1,0,0)")
        self.assertNear(path[1], 0, -9, -1)
        self.assertNear(path[-1], 9, 0, -1)
        path = self.path("DS=CONE/(POINT/0,0,20),(VECTOR/0,0,-1),20", "FROM/0,-15,3", "AUTOPS", "GO/TO,DS", "INDIRV/1,0,0",
                         "TLRGT,GOFWD/DS,ON,(PLANE/0,1,0,0)")
        around = 16 * math.tan(math.radians(20)) + 1 / math.cos(math.radians(20))
        self.assertNear(path[1], 0, -around, 3, within=4 * TOL)
        self.assertNear(path[-1], around, 0, 3, within=4 * TOL)

    def test_along_the_axis_beside_a_cylinder_to_a_plane_and_past_a_sphere(self):
        """The tool of height 5 goes up until its top is at z = 9, then down until its top is below the part of the sphere that
        stands in its way: 6 from the axis, 2 of it within the tool's reach of the center at x = 9."""
        path = self.path("PS=CYLNDR/0,0,0,0,0,1,5", "DS=PLANE/0,1,0,0", "FROM/15,0,3", "GO/ON,DS,TO,PS,ON,(PLANE/0,0,1,3)",
                         "TLON,GOUP/DS,TO,(PLANE/0,0,1,9)", "GODOWN/DS,PAST,(SPHERE/9,0,0,4)")
        self.assertNear(path[2], 6, 0, 4)
        self.assertNear(path[-1], 6, 0, -math.sqrt(16 - 4) - 5, within=4 * TOL)

    def test_tool_end_on_a_sphere_and_a_torus(self):
        """TLONPS beside a wall: the tool end at y = -1 on the sphere, and on the top of the torus tube."""
        for part, start, x, height in (("SPHERE/0,0,-10,10", -4, 4, lambda x: math.sqrt(100 - x * x - 1) - 10),
                                       ("TORUS/0,0,0,0,0,1,8,2", -6.5, -9, lambda x: math.sqrt(4 - (math.hypot(x, 1) - 8) ** 2))):
            ahead = x > start
            path = self.path(f"PS={part}", "DS=PLANE/0,1,0,0", f"FROM/{start},-3,5", f"GO/TO,DS,ON,PS,ON,(PLANE/1,0,0,{start})",
                             f"INDIRV/{1 if ahead else -1},0,0", f"{'TLRGT' if ahead else 'TLLFT'},TLONPS,GOFWD/DS,ON,(PLANE/1,0,0,{x})")
            self.assertNear(path[1], start, -1, height(start), within=4 * TOL)
            self.assertNear(path[-1], x, -1, height(x), within=4 * TOL)


if __name__ == "__main__":
    unittest.main()
