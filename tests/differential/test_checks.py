"""The checks of this folder find what they are there for: each is given something wrong and something right."""
import unittest

import numpy as np

import bands
import cutter
import part_program
import section_3
import surfaces

CIRCLE = ("CIRCLE", [0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 10.0])


def demand(**changed):
    rule = {"drive": CIRCLE, "on": False, "part": None, "on_part": False, "inner": [0.0] * 4, "outer": [0.001] * 4,
            "thick": [0.0] * 4, "cutter": [4.0], "disks": {}, "word": "GOFWD", "check": None, "check_on": False,
            "touch": False}
    return {**rule, **changed}


def arc(radius, count, first=0.0, last=90.0):
    return [[radius * np.cos(a), radius * np.sin(a), 0.0] for a in np.radians(np.linspace(first, last, count))]


def worst(points, **changed):
    motions = [{"isn": 1, "points": points[:1]}, {"isn": 2, "points": points[1:]}]
    rows, skipped = bands.measure([None, demand(**changed)], motions)
    return max(bands.violation(r) for r in rows), skipped


class Bands(unittest.TestCase):
    def test_points_beyond_the_band(self):
        self.assertEqual(worst(arc(12.0005, 200))[0], 0.0)
        self.assertAlmostEqual(worst(arc(12.0015, 200))[0], 0.0005, 6)

    def test_chords_that_dip(self):
        # The sagitta of a chord of 3 degrees on radius 12.001 is 12.001 (1 - cos 1.5) = 0.0041: 0.0031 too deep.
        self.assertAlmostEqual(worst(arc(12.001, 31))[0], 12.001 * (1 - np.cos(np.radians(1.5))) - 0.001, 6)

    def test_a_thickness_is_left(self):
        self.assertEqual(worst(arc(12.3005, 400), thick=[0.0, 0.3, 0.0, 0.0])[0], 0.0)
        self.assertGreater(worst(arc(12.0005, 400), thick=[0.0, 0.3, 0.0, 0.0])[0], 0.29)

    def test_what_is_not_known_is_told(self):
        self.assertEqual(len(worst(arc(12.0, 9), drive=("RLDSRF", []))[1]), 1)


class Distances(unittest.TestCase):
    def test_cutters_over_a_sphere(self):
        ball = surfaces.Sphere([0.0, 0.0, 0.0, 10.0])
        up = np.array([[0.0, 0.0, 1.0]])
        # Ball of radius 1 on top: its end touches. Beside: its center is 11 away from the sphere's.
        for end, gap in (((0, 0, 10.0), 0.0), ((11 * 0.6, 0, 11 * 0.8 - 1), 0.0), ((0, 0, 10.5), 0.5)):
            self.assertAlmostEqual(cutter.Cutter([2.0, 1.0]).gaps(np.array([end], float), up, ball, 1.0)[0], gap, 7)
        # A flat bottom of radius 3 on top touches in the middle, a disk the same.
        self.assertAlmostEqual(cutter.Cutter([6.0]).gaps(np.array([[0, 0, 10.0]]), up, ball, 1.0)[0], 0.0, 7)
        self.assertAlmostEqual(cutter.Disk(3.0, 1.0).gaps(np.array([[0, 0, 9.5]]), up, ball, 1.0)[0], 0.5, 7)

    def test_a_tabulated_cylinder_of_one_straight_interval(self):
        line = surfaces.TabulatedCylinder([2, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 5, 0, 0, 3, 4])
        p = np.array([[0.0, 5.0, 2.0], [3.0, 0.0, 7.0]])  # the line from 0,0 to 3,4: x 4/5 - y 3/5 = 0
        np.testing.assert_allclose(np.abs(line.distance(p)), [3.0, 2.4], atol=1e-9)
        self.assertLess(line.distance(p)[0] * line.distance(p)[1], 0.0)


class Section3(unittest.TestCase):
    TEXT = "INDEX/1\nGOTO/1,0,0\nINDEX/1,NOMORE\nCOPY/1,XYROT,90,2\nFINI\n"

    def test_copies(self):
        motions = [{"isn": 2, "points": [[1.0, 0.0, 0.0]]}]
        wanted = section_3.expected(self.TEXT, [], motions, {1: 1, 2: 2, 3: 3, 4: 4})
        np.testing.assert_allclose(np.array(wanted)[:, 0], [[1, 0, 0], [0, 1, 0], [-1, 0, 0]], atol=1e-12)
        good = [{"isn": 2, "points": p} for p in wanted]
        self.assertIsNone(section_3.difference(wanted, good))
        self.assertIn("make 3", section_3.difference(wanted, good[:2]))
        good[1] = {"isn": 2, "points": [[0.0, 1.001, 0.0]]}
        self.assertIn("motion 2", section_3.difference(wanted, good))


class Following(unittest.TestCase):
    PROGRAM = ("CUTTER/2\nFROM/0,0,0\nGO/TO,L1\nLOOPST\nA)TLLFT,GOLFT/L1,TO,L2\nP1=PLANE/0,0,1,(I)\nPSIS/P1\n"
               "IF(I-3)A,B,B\nB)LOOPND\nFINI\n")

    def test_a_surface_defined_anew_in_a_loop(self):
        rows = [("L1", "LINE", [1, 0, 0, 0]), ("L2", "LINE", [0, 1, 0, 9])]
        rows += [("P1", "PLANE", [0, 0, 1, float(i)]) for i in range(3)]
        records = [{"isn": n, "type": 5000, "kind": k} for n, k in ((2, "FROM"), (3, "GOTO"), (5, "GOTO"), (5, "GOTO"))]
        # The second turn is told from the first by a record of its own.
        records.insert(3, {"isn": 7, "type": 2000, "kind": "POST"})
        records.append({"isn": 7, "type": 2000, "kind": "POST"})
        lines = {n: n for n in range(1, 11)}
        found = part_program.Follower(self.PROGRAM, rows[:4]).demands(records, lines)
        self.assertIsNone(found[1])
        self.assertIsNone(found[2]["part"])  # the XY plane in the first turn
        self.assertEqual(found[3]["part"], ("PLANE", [0, 0, 1, 0.0]))
        with self.assertRaises(part_program.Unfollowed):  # a definition that was not followed
            part_program.Follower(self.PROGRAM, rows).demands(records, lines)


if __name__ == "__main__":
    unittest.main()
