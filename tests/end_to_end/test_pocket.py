#!/usr/bin/env python3
"""POCKET: passes against the old system's points, and the coverage that it promises, measured on a grid."""
import itertools
import json
import math
import os
import pathlib
import unittest

from arelem_run import PROJECT, ArelemCase

SHARED = pathlib.Path(os.environ.get("ARELEM_SHARED", PROJECT.parent / "shared"))


def distance(p, a, b):
    (px, py), (ax, ay), (bx, by) = p, a, b
    dx, dy = bx - ax, by - ay
    t = max(0.0, min(1.0, ((px - ax) * dx + (py - ay) * dy) / ((dx * dx + dy * dy) or 1.0)))
    return math.hypot(px - ax - t * dx, py - ay - t * dy)


class Pocket(ArelemCase):
    def passes(self, parameters, points, cutter=0.5):
        text = ",".join(str(c) for p in points for c in (*p, 0))
        self.write("a.apt", f"CUTTER/{cutter}\nFROM/0,0,1\nPOCKET/{parameters},{text}\nFINI\n")
        self.assertExit(0, "compile", "a.apt", "--to", "json")
        records = [json.loads(line) for line in self.out.splitlines()]
        self.feeds = [r["args"][0] for r in records if r.get("word") == "FEDRAT"]
        return [p for r in records if r["kind"] in ("GOTO", "CONT") for p in r["points"]]

    def test_the_old_systems_points(self):
        """The example of the manual: 1.7 radii are too far apart for its right angles, 1.451 are used."""
        corners = [(2.75, -1), (3.5, 0), (2.75, 1), (0.25, 1), (0.25, -1)]
        points = self.passes(".2125,1.7,1.7,35,30,20,0,1", corners)
        self.assertEqual(self.feeds, [35, 30, 20])
        expected = [(2.352929856748394, -0.2058597134967879), (2.507324641870985, 0.0), (2.352929856748394, 0.2058597134967879),
                    (1.0441402865032121, 0.2058597134967879), (1.0441402865032121, -0.2058597134967879), (2.352929856748394, -0.2058597134967879),
                    (2.443619904498929, -0.3872398089978586), (2.734049761247323, 0.0), (2.443619904498929, 0.3872398089978586),
                    (0.8627601910021414, 0.3872398089978586), (0.8627601910021414, -0.3872398089978586), (2.443619904498929, -0.3872398089978586),
                    (2.625, -0.75), (3.1875, 0.0), (2.625, 0.75), (0.5, 0.75), (0.5, -0.75), (2.625, -0.75)]
        self.assertEqual(len(points), len(expected))
        for found, wanted in zip(points, expected):
            self.assertLess(math.hypot(found[0] - wanted[0], found[1] - wanted[1]), 1e-9)

    def test_everything_inside_is_cut_and_nothing_outside(self):
        shapes = {"rectangle": [(0, 0), (6, 0), (6, 3), (0, 3)], "square": [(0, 0), (4, 0), (4, 4), (0, 4)],
                  "triangle": [(0, 0), (6, 0), (1, 4)], "clockwise": [(0, 0), (0, 3), (5, 4), (7, 1)],
                  "hexagon": [(2 + 2 * math.cos(a * math.pi / 3), 2 * math.sin(a * math.pi / 3)) for a in range(6)]}
        radius, reach = 0.25, 0.25
        for (name, corners), c in itertools.product(shapes.items(), (0.8, 1.5, 1.9)):
            with self.subTest(name, c=c):
                path = self.passes(f"{reach},{c},{c},1,2,3,0,0", corners)
                moves = list(zip([p[:2] for p in path], [p[:2] for p in path[1:]]))
                sides = list(zip(corners, corners[1:] + corners[:1]))
                for p in path:  # centers stay inside the outer pass
                    self.assertLess(min(distance(p[:2], a, b) for a, b in sides) if not inside(p, corners) else 0, 1e-9)
                xs, ys = [x for x, _ in corners], [y for _, y in corners]
                steps = 40
                for i, k in itertools.product(range(steps + 1), repeat=2):
                    p = (min(xs) + (max(xs) - min(xs)) * i / steps, min(ys) + (max(ys) - min(ys)) * k / steps)
                    if inside(p, corners):
                        self.assertLess(min(distance(p, a, b) for a, b in moves), radius + 1e-9, p)

    def test_projected_points(self):
        self.write("a.apt", "CUTTER/.5\nFROM/0,0,9\nPSIS/(PLANE/0,0,1,-2)\n"
                            "POCKET/.2,1.5,1.5,10,20,15,0,3,0,0,0,4,0,5,4,3,7,0,3,1\nFINI\n")
        self.assertExit(0, "compile", "a.apt", "--to", "json")
        points = [p for r in map(json.loads, self.out.splitlines()) if r["kind"] in ("GOTO", "CONT") for p in r["points"]]
        self.assertEqual({p[2] for p in points}, {-2})
        self.assertEqual(points[-1], [0.25, 0.25, -2])

    def test_copies_of_pockets(self):
        path = SHARED / "corpus/aptos-apt360/arrayPock.apt"
        if not path.exists():
            self.skipTest("the corpus is not there")
        self.assertExit(0, "compile", path, "--to", "json")


def inside(p, corners):
    area = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(corners, corners[1:] + corners[:1]))
    return all(math.copysign(1, area) * ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])) >= -1e-9
               for a, b in zip(corners, corners[1:] + corners[:1]))


if __name__ == "__main__":
    unittest.main()
