"""MESH: paths along triangles of a file, and files that are none."""
import json
import math
import re
import struct
import unittest

from arelem_run import ArelemCase

RADIUS = 40.0
PROGRAM = """PARTNO MESH
INTOL/0.01
OUTTOL/0.01
CUTTER/{cutter}
M1={surface}
LX1=PLANE/1,0,0,-12
LX2=PLANE/1,0,0,12
FROM/-20,0,60
GO/ON,(PLANE/0,1,0,{y}),TO,M1,ON,LX1
INDIRV/1,0,0
TLON,GOFWD/(PLANE/0,1,0,{y}),ON,LX2
FINI
"""


def facets(height, size, count):
    """Triangles over a square grid, seen from above counterclockwise."""
    def point(i, j):
        x, y = -size + 2 * size * i / count, -size + 2 * size * j / count
        return x, y, height(x, y)
    for i in range(count):
        for j in range(count):
            a, b, c, d = point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)
            yield a, b, c
            yield a, c, d


def stl(triangles):
    triangles = list(triangles)
    parts = [b"made by a test".ljust(80), struct.pack("<I", len(triangles))]
    for t in triangles:
        parts.append(struct.pack("<12fH", 0, 0, 0, *[c for p in t for c in p], 0))
    return b"".join(parts)


def off(triangles):
    points, faces = {}, []
    for t in triangles:
        faces.append([points.setdefault(p, len(points)) for p in t])
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += [" ".join(repr(c) for c in p) for p in points]
    lines += ["3 " + " ".join(map(str, f)) for f in faces]
    return "\n".join(lines) + "\n"


def dome(x, y):
    return math.sqrt(RADIUS * RADIUS - x * x - y * y) - RADIUS


def points(text):
    found = re.findall(r"^\s*GOTO */ *([-\d.E+]+) *, *([-\d.E+]+) *, *([-\d.E+]+)", text, re.M)
    return [tuple(map(float, p)) for p in found]


class Mesh(ArelemCase):
    def path(self, cutter, surface, y=1.5):
        self.write("part.apt", PROGRAM.format(cutter=cutter, surface=surface, y=y))
        self.assertExit(0, "part.apt", "-o", "-", "--to", "cl")
        return points(self.out)

    def proven(self):
        self.assertExit(0, "verify", "part.apt", "--json")
        self.assertIn("all tolerances are proven", self.err)

    def test_a_flat_mesh_is_a_plane(self):
        self.write("flat.stl", stl(facets(lambda x, y: 0.0, 20, 7)))
        for cutter in ("6,3", "6,1", "6"):
            with self.subTest(cutter=cutter):
                found = self.path(cutter, "MESH/STL,'flat.stl'")
                self.assertAlmostEqual(found[0][0], -12, 6)
                self.assertAlmostEqual(found[-1][0], 12, 6)
                for p in found:
                    self.assertAlmostEqual(p[1], 1.5, 6)
                    self.assertLess(abs(p[2]), 0.010001)
                self.proven()

    def test_a_fine_mesh_of_a_sphere_gives_the_path_of_the_sphere(self):
        self.write("dome.off", off(facets(dome, 20, 120)))
        for cutter in ("6,3", "6,1", "6"):
            with self.subTest(cutter=cutter):
                mesh = self.path(cutter, "MESH/OFF,'dome.off'")
                self.proven()
                # Facets of 1/3 lie at most (1/3)^2 / (4 * 40) below the sphere; the band is 0.02.
                sphere = self.path(cutter, f"SPHERE/0,0,{-RADIUS},{RADIUS}")
                for a, b in ((mesh[0], sphere[0]), (mesh[-1], sphere[-1])):
                    self.assertLess(math.dist(a, b), 0.021)
                if cutter == "6,3":
                    for p in mesh:
                        away = math.dist((p[0], p[1], p[2] + 3), (0, 0, -RADIUS)) - RADIUS - 3
                        self.assertLess(abs(away), 0.0108)

    def test_a_mesh_stops_a_motion(self):
        # A wall of two triangles at x = 5; the cutter of radius 3 stops at x = 2.
        wall = [((5, -9, -5), (5, 9, 30), (5, 9, -5)), ((5, -9, -5), (5, -9, 30), (5, 9, 30))]
        self.write("wall.stl", stl(wall))
        self.write("part.apt", PROGRAM.format(cutter="6", surface="PLANE/0,0,1,0", y=0).replace(
            "ON,LX2", "TO,WALL").replace("FROM", "WALL=MESH/STL,'wall.stl'\nFROM"))
        self.assertExit(0, "part.apt", "-o", "-", "--to", "cl")
        last = points(self.out)[-1]
        for found, wanted in zip(last, (2.0, 0.0, 0.0)):
            self.assertLess(abs(found - wanted), 0.010001)

    def test_a_tangency_at_an_edge(self):
        """A wall whose edge at (0, 3) stands out most touches the plane y = 3 with a ball at x = 0 and nowhere else, over which a cut
        vector goes from facet to facet. So does a dome, whose corner at (0, 0, 0) is its highest, the plane z = 0."""
        def wall(height, count):
            return stl(tuple((x, 3 + h, z) for x, z, h in t) for t in facets(height, 20, count))
        for count in (30, 10, 2):
            (self.folder / "wall.stl").write_bytes(wall(lambda x, z: x * x / 60, count))
            self.write("w.apt", "CUTTER/4,2\nTOLER/.002\nW=MESH/STL,'wall.stl'\nPS=PLANE/0,0,1,0\nFROM/0,-30,30\n"
                                "GO/TO,W,TO,PS,ON,(PLANE/1,0,0,-10)\nINDIRV/1,0,0\nTLRGT,GOFWD/W,TANTO,(PLANE/0,1,0,3)\nFINI\n")
            (self.folder / "dome.stl").write_bytes(stl(facets(dome, 12, count)))
            self.write("d.apt", "CUTTER/4,2\nTOLER/.002\nM=MESH/STL,'dome.stl'\nDS=PLANE/0,1,0,0\nFROM/-9,0,30\n"
                                "GO/ON,DS,TO,M,ON,(PLANE/1,0,0,-9)\nINDIRV/1,0,0\nTLON,GOFWD/DS,PSTAN,(PLANE/0,0,1,0)\nFINI\n")
            for name in ("w.apt", "d.apt"):
                with self.subTest(count=count, name=name):
                    self.assertExit(0, "verify", name)
                    self.assertExit(0, name, "--to", "cl", "-o", "-")
                    end = points(self.out)[-1]
                    self.assertLess(abs(end[0]), 1e-9)

    def test_the_ring_of_a_cutter_meets_a_leaning_wall_as_it_meets_a_plane(self):
        # y + z / 5 = 0: the ring of radius .7 at 1.5 comes to y = -1, the upper end of the cutter would be through it.
        square = [(-9, 1.6, -8), (9, 1.6, -8), (9, -1.6, 8), (-9, -1.6, 8)]
        for order, side in (((0, 1, 2), (0, 2, 3)), "front"), (((0, 2, 1), (0, 3, 2)), "back"):
            self.write("wall.stl", stl([tuple(square[k] for k in corners) for corners in order]))
            for wall in ("PLANE/0,1,.2,0", "MESH/STL,'wall.stl'"):
                with self.subTest(wall=wall, side=side):
                    self.write("part.apt", f"CUTTER/2,.5\nW={wall}\nFROM/0,-3,3\nGO/TO,W,TO,(PLANE/0,0,1,0)\n"
                               "CUTTER/OPTION,2,.7,1.5\nGO/TO,W,TO,(PLANE/0,0,1,0)\n"
                               "TLRGT,GORGT/W,TO,(PLANE/1,0,0,5)\nFINI\n")
                    self.proven()
                    self.assertExit(0, "part.apt", "-o", "-", "--to", "cl")
                    heights = [p[1] for p in points(self.out)]
                    self.assertAlmostEqual(heights[-1], -1.0, delta=0.001)

    def test_a_turning_cutter_along_a_wall_is_proven(self):
        # Sides that widen touch the wall with the rim at their top, far from the tool end about which the axis turns.
        def wall(x, z):
            return 0.3 * math.sin(0.8 * x)
        self.write("wall.stl", stl([[(p[0], p[2], p[1]) for p in (a, c, b)] for a, b, c in facets(wall, 8, 8)]))
        for cutter in ("1,.2,.359942,.2,0,20,4", "1,0,.5,0,0,10,4"):
            with self.subTest(cutter=cutter):
                self.write("part.apt", f"""PARTNO WALL
MULTAX
INTOL/0
OUTTOL/.0005
CUTTER/{cutter}
M1=MESH/STL,'wall.stl'
PS1=CYLNDR/0,0,-10,.5,1,0,10.2
FROM/-8,5,5
TLAXIS/NORMPS
GO/TO,M1,TO,PS1,ON,(PLANE/1,0,0,-3)
INDIRV/1,0,0
TLLFT,GOFWD/M1,ON,(PLANE/1,0,0,3)
FINI
""")
                self.proven()

    def test_a_motion_ends_where_it_comes_round_a_border(self):
        # A plate up to x = 10 and a ball of radius 1 along y = 0: beside the border it meets x = 10.5; it meets x = 0 for
        # the second time below the plate only.
        self.write("plate.stl", stl(facets(lambda x, y: 0.0, 10, 2)))
        program = PROGRAM.format(cutter="2,1,0,1,0,0,5", surface="MESH/STL,'plate.stl'", y=0)
        program = program.replace("PLANE/1,0,0,-12", "PLANE/1,0,0,-5")
        self.write("part.apt", program.replace("PLANE/1,0,0,12", "PLANE/1,0,0,10.5"))
        self.assertExit(0, "part.apt", "-o", "-", "--to", "cl")
        self.assertAlmostEqual(points(self.out)[-1][2], math.sqrt(1 - 0.25) - 1, 1)
        self.write("part.apt", program.replace("PLANE/1,0,0,12", "PLANE/1,0,0,0").replace("ON,LX2", "ON,2,INTOF,LX2"))
        self.assertExit(4, "part.apt", "-o", "-", "--to", "cl")
        self.assertIn("E0512", self.err)
        self.assertIn("the tool goes over the border of the mesh `M1`", self.err)
        self.assertIn("only 1 of 2 positions ON check surface `LX2` are met", self.err)
        # A check surface beside the way: how near the motion came to it and where.
        self.write("part.apt", program.replace("ON,LX2", "TO,(SPHERE/4,3,0,1)").replace("ON,2,INTOF", ""))
        self.assertExit(4, "part.apt", "-o", "-", "--to", "cl")
        self.assertIn("E0512", self.err)
        self.assertRegex(self.err, r"is never met TO: nearest approach 1\.16\d* at \((3\.99|4|4\.00)\d*, 0, ")

    def test_an_axis_that_leaps_from_one_triangle_to_the_next(self):
        # Strips of 2 in x of z = .01 x x: at x = 10 the normal turns by .04 / (1 + .2 * .2) = .0385, 2.2 degrees. While the
        # cutter of radius 2 turns so, its bottom of radius 1 is .0385 / 2 off, which .02 allows and .01 does not.
        self.write("bowl.stl", stl(facets(lambda x, y: 0.01 * x * x, 20, 20)))
        program = PROGRAM.format(cutter="4,1", surface="MESH/STL,'bowl.stl'", y=1).replace("INTOL/0.01", "MULTAX").replace(
            "GO/", "TLAXIS/NORMPS\nGO/").replace("PLANE/1,0,0,12", "PLANE/1,0,0,10.01")
        self.write("part.apt", program.replace("OUTTOL/0.01", "OUTTOL/0.022"))
        self.assertExit(0, "part.apt", "-o", "-", "--to", "cl")
        self.assertAlmostEqual(points(self.out)[-1][0], 10.01, 6)
        self.proven()
        self.write("part.apt", program)
        self.assertExit(4, "part.apt", "-o", "-", "--to", "cl")
        self.assertIn("the tool axis leaps by 2.2 degrees there", self.err)

    def test_a_triangle_that_is_there_twice_is_named(self):
        triangles = list(facets(lambda x, y: 0.0, 10, 2))
        self.write("twice.stl", stl(triangles + triangles[3:4]))
        self.write("part.apt", "M1=MESH/STL,'twice.stl'\nPRINT/3,M1\nFINI\n")
        self.assertNotEqual(self.run_arelem("check", "part.apt"), 0)
        self.assertIn("the triangle (-10, 0, 0), (0, 10, 0), (-10, 10, 0) is in it twice", self.err)

    def test_a_path_that_was_moved_is_refuted(self):
        self.write("dome.off", off(facets(dome, 20, 40)))
        self.path("6,3", "MESH/OFF,'dome.off'")
        made = self.out
        self.write("low.cls", re.sub(r"(GOTO */[^,]*,[^,]*,) *([-\d.E+]+)",
                                     lambda m: f"{m[1]}{float(m[2]) - 0.05:.9f}", made))
        self.assertExit(5, "verify", "part.apt", "low.cls")
        self.assertIn("E0904", self.err)

    def test_what_is_no_mesh_is_refused(self):
        cases = {
            "none.stl": (None, "E0731"),
            "cut.stl": (stl(facets(dome, 20, 3))[:-7], "E0344"),
            "text.stl": (b"PARTNO NO MESH\nFINI\n", "E0344"),
            "leaves.off": (b"OFF\n5 3 0\n0 0 0\n0 0 1\n1 0 0\n0 1 0\n-1 0 0\n3 0 1 2\n3 1 0 3\n3 0 1 4\n", "E0345"),
            "turned.off": (b"OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 1 2 3\n", "E0346"),
        }
        for name, (content, code) in cases.items():
            with self.subTest(name=name):
                if content is not None:
                    self.write(name, content)
                kind = name.rsplit(".", 1)[1].upper()
                self.write("part.apt", f"M1=MESH/{kind},'{name}'\nPRINT/3,M1\nFINI\n")
                self.assertNotEqual(self.run_arelem("check", "part.apt", "--diagnostics", "json"), 0)
                codes = [json.loads(line)["code"] for line in self.err.splitlines() if line.startswith("{")]
                self.assertIn(code, codes, self.err)


if __name__ == "__main__":
    unittest.main()
