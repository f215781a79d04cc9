#!/usr/bin/env python3
"""POCKET: passes against the old system's points, and the coverage that it promises, measured on a grid."""
import itertools
import json
import math
import os
import pathlib
import random
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

    def test_random_pockets_are_proven(self):
        """Walls along a leaning axis, projected points, short sides that vanish and leave sharper corners."""
        draw = random.Random(7)
        counts = {"proven": 0, "E0587": 0}
        for number in range(150):
            program = random_program(draw)
            if program is None:
                continue
            self.write("r.apt", program)
            code = self.run_arelem("verify", "r.apt")
            with self.subTest(number, program=program):
                if code == 0:
                    counts["proven"] += 1
                else:
                    self.assertEqual(self.err.count("error["), 1, self.err)
                    self.assertIn("error[E0587]", self.err)
                    counts["E0587"] += 1
        self.assertGreater(counts["proven"], 40, counts)

    def test_a_cutter_too_large_for_leaning_walls_is_refused(self):
        self.write("a.apt", "CUTTER/4.44\nMULTAX\nTLAXIS/.309,.323,1\nFROM/0,0,20\nPOCKET/0,1.2,.4,5,10,4,0,1,$\n"
                            "-2.32,-12.493,0,-1.05,15.3,0,2.72,10.91,0\nFINI\n")
        self.assertExit(4, "compile", "a.apt", "--to", "json")
        self.assertIn("error[E0587]", self.err)

    def test_damaged_pockets_are_refuted(self):
        self.write("a.apt", "CUTTER/1\nFROM/5,3,2\nPOCKET/.5,1.5,.5,5,10,4,0,1,0,0,0,10,0,0,10,6,0,0,6,0\nGOTO/5,3,2\nFINI\n")
        self.assertExit(0, "compile", "a.apt", "-o", "a.cls", "-o", "a.jsonl", "-o", "a.cltape")
        for name in ("a.cls", "a.jsonl", "a.cltape"):
            self.assertExit(0, "verify", "a.apt", name)
        text = (self.folder / "a.cls").read_text().splitlines()
        places = [i for i, line in enumerate(text) if line.startswith("GOTO")]
        middle = places[len(places) // 2 - 3]
        outer = places[-4]  # the corner at 9.5, 5.5
        self.assertEqual(text[outer], "GOTO / 9.5, 5.5, 0.0")
        changes = {"E0930": (middle, text[middle].rsplit(",", 1)[0] + ", 0.001"),
                   "E0931": (outer, "GOTO / 9.501, 5.5, 0.0"),
                   "E0932": (outer, "GOTO / 9.4, 5.4, 0.0"),
                   "E0933": (middle, None)}
        for code, (line, new) in changes.items():
            with self.subTest(code):
                changed = text[:line] + ([new] if new else []) + text[line + 1:]
                if code == "E0933":  # a whole inner pass is missing
                    changed = text[:middle] + text[middle + 5:]
                self.write("b.cls", "\n".join(changed) + "\n")
                self.assertExit(5, "verify", "a.apt", "b.cls")
                self.assertIn(f"a.apt:3:1: error[{code}]", self.err)

    def test_copies_of_pockets(self):
        path = SHARED / "corpus/aptos-apt360/arrayPock.apt"
        if not path.exists():
            self.skipTest("the corpus is not there")
        self.assertExit(0, "compile", path, "--to", "json")


def random_program(draw):
    angles = sorted(draw.uniform(0, 2 * math.pi) for _ in range(draw.randint(3, 9)))
    gaps = [(b - a) % (2 * math.pi) for a, b in zip(angles, angles[1:] + angles[:1])]
    if max(gaps) > 3 or min(gaps) < 0.1:
        return None
    a, b = draw.uniform(3, 40), draw.uniform(3, 40)
    points = [(a * math.cos(t), b * math.sin(t)) for t in angles]
    if draw.random() < 0.5:
        points.reverse()
    kind, tilted = draw.randint(0, 3), draw.random() < 0.4
    slope = [draw.uniform(-0.3, 0.3) if tilted and kind < 2 else 0 for _ in range(2)]
    diameter = draw.uniform(0.5, 6)
    reach = draw.choice([0, 0, draw.uniform(0.15, 0.5) * diameter])
    program = f"CUTTER/{diameter:.5f}\nFROM/0,0,20\n"
    if tilted:
        program += f"MULTAX\nTLAXIS/{draw.uniform(-0.4, 0.4):.4f},{draw.uniform(-0.4, 0.4):.4f},1\n"
    if kind >= 2:
        program += f"PSIS/(PLANE/{draw.uniform(-0.3, 0.3):.3f},{draw.uniform(-0.3, 0.3):.3f},1,2)\n"
    places = ",$\n".join(f"{x:.9f},{y:.9f},{slope[0] * x + slope[1] * y:.9f}" for x, y in points)
    return program + (f"POCKET/{reach:.5f},{draw.uniform(0.2, 2):.5f},{draw.uniform(0.2, 2):.5f},5,10,4,0,{kind},$\n{places}\n"
                      "GOTO/0,0,30\nFINI\n")


def inside(p, corners):
    area = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(corners, corners[1:] + corners[:1]))
    return all(math.copysign(1, area) * ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])) >= -1e-9
               for a, b in zip(corners, corners[1:] + corners[:1]))


if __name__ == "__main__":
    unittest.main()
