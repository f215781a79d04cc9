"""`arelem time` and SMOOTH through the whole command; times by pencil."""
import json
import math
import unittest

from arelem_run import PROJECT, ArelemCase


class Time(ArelemCase):
    def seconds(self, text, *options):
        self.write("p.apt", text)
        self.assertExit(0, "time", "p.apt", "--json", *options)
        return json.loads(self.out)

    def test_one_move(self):
        # 100 mm at 6000 mm/min = 100 mm/s: a change from rest takes 2 sqrt(100/20000) s over 50 mm/s times that.
        table = self.seconds("CUTTER/1\nFROM/0,0,0\nFEDRAT/6000\nGOTO/100,0,0\nFINI\n")
        change = 2 * math.sqrt(100 / 20000)
        self.assertAlmostEqual(table["cutting"], 2 * change + (100 - 2 * 50 * change) / 100, places=9)
        self.assertEqual(table["moves"], 1)
        self.assertEqual(table["rapid"], 0)

    def test_every_example(self):
        """The parts and the statements add up, and nothing is faster than the machine."""
        for file in sorted((PROJECT / "examples").glob("*.apt")):
            with self.subTest(file.name):
                self.assertExit(0, "time", file, "--json", "--statements", "-I", PROJECT / "examples")
                table = json.loads(self.out)
                parts = table["cutting"] + table["rapid"] + table["dwell"] + table["toolChanges"]
                self.assertAlmostEqual(table["total"], parts, places=6)
                self.assertAlmostEqual(sum(s["seconds"] for s in table["statements"]), table["total"], places=5)
                self.assertGreaterEqual(table["cutting"], table["cuttingLength"] / 400)
                self.assertGreaterEqual(table["rapid"], table["rapidLength"] / 400)
                self.assertGreater(table["cutting"], 0)

    def test_numbers_that_are_none(self):
        """With nan every comparison is false: a tolerance of it would let anything pass."""
        self.write("p.apt", "CUTTER/1\nFROM/0,0,0\nFEDRAT/6000\nGOTO/100,0,0\nFINI\n")
        self.assertExit(0, "compile", "p.apt", "-o", "p.cls")
        for number in ("nan", "inf", "-1", "x"):
            for words in (("time", "p.apt", "--deviation"), ("time", "p.apt", "--velocity"), ("time", "p.apt", "--tool-change"),
                          ("compile", "p.apt", "--fit"), ("diff", "p.cls", "p.cls", "--tolerance"),
                          ("diff", "p.cls", "p.cls", "--degrees"), ("verify", "p.apt", "--slack"),
                          ("verify", "p.cls", "--with", "p.apt", "--tolerance"), ("verify", "p.cls", "--with", "p.apt", "--fit")):
                with self.subTest(words=words, number=number):
                    self.assertExit(2, *words, number)

    def test_rapid_dwell_and_tools(self):
        table = self.seconds("CUTTER/1\nLOADTL/1\nFROM/0,0,0\nRAPID\nGOTO/500,0,0\nDELAY/2\nLOADTL/2\nFINI\n",
                             "--tool-change", "7")
        self.assertAlmostEqual(table["toolChanges"], 14)
        self.assertAlmostEqual(table["dwell"], 2)
        change = 2 * math.sqrt(400 / 20000)
        self.assertAlmostEqual(table["rapid"], 2 * change + (500 - 2 * 200 * change) / 400, places=9)
        self.assertAlmostEqual(table["total"], table["rapid"] + 16)

    def test_machine_limits_of_the_program(self):
        slow = self.seconds("CUTTER/1\nFROM/0,0,0\nMACHLM/50,100,1000\nFEDRAT/6000\nGOTO/100,0,0\nFINI\n",
                            "--dialect", "cl")
        fast = self.seconds("CUTTER/1\nFROM/0,0,0\nFEDRAT/6000\nGOTO/100,0,0\nFINI\n")
        self.assertGreater(slow["total"], fast["total"] + 1)

    def test_corners_cost_time(self):
        corner = "CUTTER/1\nFROM/0,0,0\nFEDRAT/6000\nGOTO/100,0,0\nGOTO/100,100,0\nFINI\n"
        line = "CUTTER/1\nFROM/0,0,0\nFEDRAT/6000\nGOTO/100,0,0\nGOTO/200,0,0\nFINI\n"
        self.assertGreater(self.seconds(corner)["total"], self.seconds(line)["total"])
        self.assertGreater(self.seconds(corner, "--deviation", "0")["total"], self.seconds(corner)["total"])

    def test_arcs_of_cl_files_tapes_and_json(self):
        # A quarter of a circle of radius 10, 10 mm up, and 10 mm straight on.
        length = math.hypot(5 * math.pi, 10) + 10
        self.write("p.cls", "UNITS / MM\nCUTTER / 6.0\nFROM / 10.0, 0.0, 0.0\nFEDRAT / 100.0, MMPM\n"
                   "CIRCLE / 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 10.0\nGOTO / 0.0, 10.0, 10.0\nGOTO / -10.0, 10.0, 10.0\nFINI\n")
        self.assertExit(0, "compile", "p.cls", "-o", "p.cltape", "-o", "p.jsonl")
        totals = []
        for file in ("p.cls", "p.cltape", "p.jsonl"):
            self.assertExit(0, "time", file, "--json")
            table = json.loads(self.out)
            self.assertAlmostEqual(table["cuttingLength"], length, places=6)
            self.assertEqual(table["moves"], 2)
            totals.append(table["total"])
        self.assertEqual(len(set(totals)), 1)

    def test_fine_chords_cost_what_the_curve_costs(self):
        # A circle of radius 1: v = sqrt(4000 * 1) = 63.2 mm/s, however many chords it has.
        times = []
        for count in (100, 400):
            points = "".join(f"GOTO/{math.cos(2 * math.pi * i / count):.9f},{math.sin(2 * math.pi * i / count):.9f},0\n"
                             for i in range(1, 10 * count + 1))
            times.append(self.seconds("CUTTER/1\nFROM/1,0,0\nFEDRAT/24000\n" + points + "FINI\n")["total"])
        for time in times:
            self.assertGreater(time, 20 * math.pi / math.sqrt(4000))
            self.assertLess(time, 20 * math.pi / math.sqrt(4000) + 0.15)  # and from rest to rest

    def test_missing_feed(self):
        self.write("p.apt", "CUTTER/1\nFROM/0,0,0\nGOTO/100,0,0\nFINI\n")
        self.assertExit(4, "time", "p.apt")
        self.assertIn("E0396", self.err)
        self.assertEqual(self.out, "")

    def test_statements_without_a_time(self):
        """What a feed or a wait means must be known: E0598 tells what is not."""
        for statement, why in (("FEDRAT/100,FOO", "FEDRAT has `FOO`"), ("FEDRAT/MMPM", "FEDRAT has no number"),
                               ("FEDRAT/100,200,MMPM", "FEDRAT has several numbers"), ("FEDRAT/100,MMPM,IPR", "several units"),
                               ("DELAY/3,FOO", "DELAY has `FOO`"), ("DELAY/3,REV", "the spindle has no speed"),
                               ("SPINDL/300,SFM\nDELAY/3,REV", "the spindle has no speed"), ("DELAY/ON", "DELAY has `ON`"),
                               ("FEDRAT/.1,MMPR", "FEDRAT has a feed for each turn, and the spindle has no speed")):
            with self.subTest(statement):
                self.write("p.apt", f"CUTTER/1\nFROM/0,0,0\nFEDRAT/50\n{statement}\nGOTO/1,0,0\nFINI\n")
                self.assertExit(4, "time", "p.apt")
                self.assertIn("error[E0598]", self.err)
                self.assertIn(why, self.err)
                self.assertEqual(self.out, "")

    def test_turns_of_the_spindle(self):
        # 600 turns a minute: 3 turns take 0.3 s, whichever way it turns.
        for speed in ("600,CLW", "-600"):
            table = self.seconds(f"CUTTER/1\nSPINDL/{speed}\nFROM/0,0,0\nFEDRAT/50\nDELAY/3,REV\nGOTO/1,0,0\nFINI\n")
            self.assertAlmostEqual(table["dwell"], 0.3)

    def test_wrong_limits(self):
        for words in ("-1,100,100", "1,2", "0,1,1"):
            self.write("p.apt", f"CUTTER/1\nFROM/0,0,0\nMACHLM/{words}\nFEDRAT/10\nGOTO/1,0,0\nFINI\n")
            self.assertNotEqual(self.run_arelem("time", "p.apt", "--dialect", "cl"), 0)
            self.assertIn("E0395", self.err)
        self.assertExit(2, "time", "p.apt", "--jerk", "-5")

    def test_path_of_one_point(self):
        self.assertEqual(self.seconds("CUTTER/1\nFROM/1,2,3\nFINI\n")["total"], 0)


WAVE = "CUTTER/1\nFROM/0,0,0\nFEDRAT/24000\n{}\n" + "".join(
    f"GOTO/{x},{4 * (x // 10 % 2)},0\n" for x in range(10, 130, 10)) + "{}\nFINI\n"


class Smooth(ArelemCase):
    def test_summary_tells_seconds(self):
        """The seconds of the summary are those of `arelem time`: one sequence is the whole program."""
        times = []
        for name, text in (("w.apt", WAVE.format("", "")), ("s.apt", WAVE.format("SMOOTH/.2", "SMOOTH/NOMORE"))):
            self.write(name, text)
            self.assertExit(0, "time", name, "--json")
            times.append(json.loads(self.out)["total"])
        self.assertExit(0, "compile", "s.apt", "-v", "-o", "s.cls")
        self.assertIn(f", {times[0]:.3f} to {times[1]:.3f} s, within ", self.err)

    def test_no_path(self):
        self.write("p.apt", "CUTTER/1\nFROM/0,0,0\nSMOOTH/.05\nSMOOTH/NOMORE\nFEDRAT/100\nGOTO/1,0,0\nFINI\n")
        self.assertNotEqual(self.run_arelem("compile", "p.apt", "-o", "p.cls"), 0)
        self.assertIn("error[E0399]", self.err)
        self.assertIn("has 0 locations", self.err)

    def points(self, text):
        self.write("p.apt", text)
        self.assertExit(0, "compile", "p.apt", "--to", "json", "-o", "-", "--dialect", "cl")
        return [p for line in self.out.splitlines() for p in json.loads(line).get("points", [])]

    def test_tolerance_and_time(self):
        plain = WAVE.format("", "")
        smooth = WAVE.format("SMOOTH/.2", "SMOOTH/NOMORE")
        old, new = self.points(plain), self.points(smooth)
        self.assertGreater(len(new), len(old))

        def off(p, points):
            best = 1e9
            for a, b in zip(points, points[1:]):
                d = [y - x for x, y in zip(a, b)]
                square = sum(x * x for x in d)
                s = 0 if not square else max(0, min(1, sum((q - x) * y for q, x, y in zip(p, a, d)) / square))
                best = min(best, math.dist(p, [x + s * y for x, y in zip(a, d)]))
            return best

        self.assertLessEqual(max(off(p, old) for p in new), 0.2)
        self.assertLessEqual(max(off(p, new) for p in old), 0.2)
        self.assertEqual(new[0], old[0])
        self.assertLess(math.dist(new[-1], old[-1]), 1e-9)
        self.write("s.apt", smooth)
        self.assertExit(0, "time", "s.apt", "--json", "--dialect", "cl", "--deviation", "0.001")
        smoothed = json.loads(self.out)["total"]
        self.write("w.apt", plain)
        self.assertExit(0, "time", "w.apt", "--json", "--dialect", "cl", "--deviation", "0.001")
        self.assertLess(smoothed, json.loads(self.out)["total"])


if __name__ == "__main__":
    unittest.main()
