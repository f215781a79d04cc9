"""A closed mesh that stands on the part surface: the bottom of the tool meets its wall and then its level bottom face."""
import math
import unittest

from arelem_run import ArelemCase
from test_mesh import points, stl

PROGRAM = """PARTNO STAND
TOLER/.001
M=MESH/STL,'block.stl'
PS=PLANE/0,0,1,{z}
DS={drive}
CUTTER/{cutter}
FROM/{start},{up}
GO/ON,DS,TO,PS,ON,{first}
INDIRV/{way},0
TLON,GOFWD/DS,{condition},M
FINI
"""
WALL = """PARTNO WALL
CUTTER/6
M=MESH/STL,'block.stl'
FROM/{first},9,0
GO/TO,M,TO,(PLANE/0,0,1,0),ON,(PLANE/1,0,0,{first})
INDIRV/1,0,0
TLLFT,GOFWD/M,ON,(PLANE/1,0,0,{stop})
GOFWD/M,ON,(PLANE/1,0,0,30)
FINI
"""
QUADS = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))


def block(low, high, turn):
    """A box turned about z."""
    c, s = math.cos(turn), math.sin(turn)
    corners = [(c * x - s * y, s * x + c * y, z) for z in (low[2], high[2]) for y in (low[1], high[1]) for x in (low[0], high[0])]
    for a, b, d, e in QUADS:
        yield corners[a], corners[b], corners[d]
        yield corners[a], corners[d], corners[e]


class ClosedMesh(ArelemCase):
    def stop(self, cutter, condition, z=0.0, turn=0.0, y=0.0):
        """How far along its way the tool goes towards a block from 10 to 30."""
        (self.folder / "block.stl").write_bytes(stl(block((10, -20, z), (30, 20, z + 30), turn)))
        c, s = math.cos(turn), math.sin(turn)
        self.write("part.apt", PROGRAM.format(
            cutter=cutter, condition=condition, z=z, up=z + 40, start=f"{-25 * c - y * s:.12f},{-25 * s + y * c:.12f}",
            drive=f"PLANE/{-s:.15f},{c:.15f},0,{y}", first=f"(PLANE/{c:.15f},{s:.15f},0,-25)", way=f"{c:.15f},{s:.15f}"))
        self.assertExit(0, "verify", "part.apt")
        self.assertExit(0, "part.apt", "-o", "-", "--to", "cl")
        last = points(self.out)[-1]
        self.assertAlmostEqual(last[2], z, 5)
        return c * last[0] + s * last[1]

    def test_the_stop_is_at_the_wall(self):
        wanted = {("TO", "10"): 5, ("TO", "10,5"): 5, ("TO", "0"): 10, ("ON", "10"): 10, ("ON", "0"): 10,
                  ("PAST", "10"): 15, ("PAST", "10,2"): 15, ("PAST", "10,5"): 15, ("PAST", "0"): 10}
        for (condition, cutter), place in wanted.items():
            for y in (0.0, 7.3):
                with self.subTest(condition=condition, cutter=cutter, y=y):
                    self.assertAlmostEqual(self.stop(cutter, condition, y=y), place, delta=.001001)

    def test_it_is_there_whatever_the_file_rounds(self):
        # The numbers of the file are off by up to 4e-6, its bottom then leans by some 1e-7 or lies beside the part plane.
        for z in (0.1, 12.7, -33.3, 127.3):
            for turn in (0.0, 0.3, 2.2):
                for condition, cutter, place in (("ON", "10,5", 10), ("PAST", "10,2", 15), ("TO", "10", 5)):
                    with self.subTest(z=z, turn=turn, condition=condition):
                        self.assertAlmostEqual(self.stop(cutter, condition, z, turn), place, delta=.0011)

    def test_the_last_cut_vector_leads_along_the_path(self):
        # Stops a whole number of MAXDP away: the place across the band from there is no cut vector,
        # GOFWD would go on across the path (E0507).
        (self.folder / "block.stl").write_bytes(stl(block((-50, -20, -5), (50, 2, 20), 0.0)))
        for first, stop in ((-5, 5), (-5, 15), (-8, 2)):
            with self.subTest(first=first, stop=stop):
                self.write("wall.apt", WALL.format(first=first, stop=stop))
                self.assertExit(0, "verify", "wall.apt")
                self.assertExit(0, "wall.apt", "-o", "-", "--to", "cl")
                way = [p for p in points(self.out) if p[1] < 6][1:]
                for a, b in zip(way, way[1:]):
                    self.assertGreater(b[0] - a[0], abs(b[1] - a[1]))
                    self.assertLess(b[0] - a[0], 10 + 1e-8)


if __name__ == "__main__":
    unittest.main()
