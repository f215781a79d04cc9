#!/usr/bin/env python3
"""SPRAY by the whole command: the source's tables, the report, pictures of the film, nothing written after an error."""
import csv
import json
import re
import struct
import unittest

from arelem_run import PROJECT, ArelemCase

GUN = "UNITS/MM\nG1=GUN/ELLIPS,.7,1,SPEED,1000,FLOW,1,EFFIC,.65\n"
PLATE = "R1=REGION/(0,0),(1000,0),(1000,800),(0,800)\n"
TABLE_43 = [(71.4, .9126), (62.2, .9157), (55.1, .9219), (49.5, .9312), (44.9, .9411), (41.1, .9526), (37.9, .9651),
            (35.1, .9767), (32.8, .9919), (30.7, 1.005), (28.9, 1.02), (27.2, 1.032), (25.8, 1.048), (24.5, 1.063),
            (23.3, 1.078), (22.2, 1.092), (21.3, 1.11), (20.4, 1.125)]


class Spray(ArelemCase):
    def spray(self, text, *words):
        self.write("part.apt", text + "FINI\n")
        self.assertExit(0, "spray", "part.apt", "--json", *words)
        return json.loads(self.out)

    def test_table_4_2(self):
        one = self.spray(GUN + PLATE + "SPRAY/R1,GUN,G1,FILM,.051,OVRLAP,.175,INSET,COMPAT,MINCST,60,10,2,2,"
                                       "HEIGHT,20,75,2,ANGLE,0,90,90\n")[0]
        self.assertAlmostEqual(one["cost"]["total"], .9127, delta=6e-5)
        self.assertEqual((one["b"], one["angle"], one["passes"], one["v"]), (62, 0, 8, 1000))
        self.assertAlmostEqual(one["q"], .481, delta=1e-3)
        self.assertEqual(len(one["trials"]), 56)
        self.assertAlmostEqual(sum(v for k, v in one["cost"].items() if k != "total"), one["cost"]["total"], places=12)

    def test_table_4_3(self):
        for b, cost in TABLE_43:
            with self.subTest(b=b):
                one = self.spray(GUN + PLATE + "SPRAY/R1,GUN,G1,FILM,.051,OVRLAP,.175,INSET,COMPAT,MINCST,60,10,2,2,"
                                               f"HEIGHT,{b},{b},1\n")[0]
                self.assertAlmostEqual(one["cost"]["total"], cost, delta=6e-4)

    def test_right_preferred_sizes_are_better(self):
        # The inset that belongs to Table 4.3, 0.74 b, with sizes that really fit seven passes: (4.38) corrected.
        one = self.spray(GUN + PLATE + "SPRAY/R1,GUN,G1,FILM,.051,OVRLAP,.175,INSET,.74,MINCST,60,10,2,2,"
                                       "HEIGHT,20,75,2\n")[0]
        self.assertAlmostEqual(one["cost"]["total"], .897870, delta=1e-5)
        self.assertAlmostEqual(one["b"], 800 / (2 * (6 * .825 + .74)), places=6)
        self.assertEqual(one["passes"], 7)
        self.assertTrue(any(t["preferred"] and t["b"] == one["b"] for t in one["trials"]))

    def test_cl_has_poses_switches_and_feeds(self):
        self.write("part.apt", "UNITS/MM\nG1=GUN/CONE,45,STNDOF,50,SPEED,200,OUTPUT,3\n"
                               "R1=REGION/(0,0),(300,0),(300,30),(0,30)\nSPRAY/R1,GUN,G1,FILM,.05\nFINI\n")
        self.assertExit(0, "compile", "part.apt")
        lines = [" ".join(line.split()) for line in self.out.splitlines()]
        self.assertEqual([l for l in lines if l.startswith("SPRAY")], ["SPRAY / ON, 3", "SPRAY / OFF, 3"])
        self.assertIn("FEDRAT / 200, MMPS", [l.replace("200.0,", "200,") for l in lines])
        self.assertEqual(len([l for l in lines if l.startswith("GOTO")]), 2)
        self.write("again.cls", self.out)
        self.assertExit(0, "compile", "again.cls", "--dialect", "cl")

    def test_report_holds_it(self):
        self.write("part.apt", GUN.replace(".7,1", "43.4,62") + PLATE + "SPRAY/R1,GUN,G1,FILM,.051\nFINI\n")
        self.assertExit(0, "compile", "part.apt", "-o", "part.cls", "--report", "r.json")
        entry = json.loads((self.folder / "r.json").read_text())["sprays"][0]
        self.assertEqual((entry["line"], entry["work"]), (4, "R1"))
        self.assertAlmostEqual(entry["overlap"], .17527, delta=1e-5)
        self.assertGreater(entry["simulated"]["within10percent"], .3)

    def test_pictures_of_the_film(self):
        self.spray(GUN.replace(".7,1", "43.4,62") + PLATE + "SPRAY/R1,GUN,G1,FILM,.051\n",
                   "--film", "a.png", "--film", "a.svg", "--film", "a.csv", "--cell", "20")
        png = (self.folder / "a.png").read_bytes()
        self.assertEqual(png[:8], b"\x89PNG\r\n\x1a\n")
        width, height = struct.unpack(">II", png[16:24])
        self.assertEqual(width, 1400)
        self.assertGreater(height, 700)
        svg = (self.folder / "a.svg").read_text()
        self.assertIn("R1: film of 51 um", svg)
        shares = [float(s) for s in re.findall(r">([0-9.]+) %<", svg)]  # of the work, band by band
        self.assertAlmostEqual(sum(shares), 100, delta=.5)
        self.assertIn("where the gun is switched", svg)
        with open(self.folder / "a.csv") as file:
            rows = [r for r in csv.DictReader(file) if r["work"] == "1"]
        mean = sum(float(r["film_mm"]) for r in rows) / len(rows)
        self.assertAlmostEqual(mean, .051, delta=.003)

    def test_a_film_far_from_the_one_asked_for_is_told(self):
        # Meridians of a sphere lie cos(latitude) closer: beyond 60 degrees the film doubles, on 13 % of the area,
        # but where the gun may go faster.
        ball = "UNITS/MM\nG1=GUN/CONE,30,STNDOF,100,SPEED,200\nS1=SPHERE/0,0,0,200\nSPRAY/S1,GUN,G1,FILM,.02,VLINES,SPEED,130"
        self.write("part.apt", ball + "\nFINI\n")
        self.assertExit(0, "spray", "part.apt")
        self.assertEqual(self.err.count("W0352"), 1)
        self.assertExit(0, "compile", "part.apt", "-o", "part.cls")
        self.assertEqual(self.err.count("W0352"), 1)
        self.write("part.apt", ball.replace(",SPEED,130", "") + ",LIMITS,0,360,-20,20\nFINI\n")
        self.assertExit(0, "spray", "part.apt")
        self.assertNotIn("W0352", self.err)
        self.assertNotIn(" -", self.out.split("paint ")[1].splitlines()[0])

    def test_steps_cells_and_guns_that_cannot_be(self):
        ball = "UNITS/MM\nG1=GUN/CONE,30,STNDOF,100,SPEED,200\nS1=SPHERE/0,0,0,200\nSPRAY/S1,GUN,G1,FILM,.02,ULINES"
        self.write("part.apt", ball + ",STEP,0\nFINI\n")
        self.assertExit(4, "compile", "part.apt")
        self.assertIn("STEP of SPRAY is 0; it must be above 0", self.err)
        self.write("part.apt", ball + "\nFINI\n")
        self.assertExit(2, "spray", "part.apt", "--cell", "0")
        self.assertIn("`0` is not a number above 0", self.err)
        self.assertExit(0, "spray", "part.apt", "--cell", ".0001")
        self.assertIn("W0353", self.err)
        self.assertIn("cells of 0.0001 mm are too many for the film of S1: it has cells of", self.err)
        self.write("part.apt", "UNITS/MM\nG1=GUN/CALIB,'nogun',PRESS,300,VALVE,30\nFINI\n")
        self.assertExit(3, "compile", "part.apt")
        self.assertIn("stdlib/guns", self.err)
        self.assertIn("'binks'", self.err)

    def test_the_gun_stands_off_along_the_normal(self):
        # The row of the golden cases: a place of the work, its normal and a stand-off give the place of the gun. One pass
        # in the middle of a strip ends where the far edge of the footprint, half axis 20, has left the work.
        cases = json.loads((PROJECT / "tests/data/golden/cases_sen.json").read_text())
        rows = [c for c in cases if c.get("fn") == "fn_sen.gun_pos"]
        self.assertEqual(len(rows), 1)
        x, y, z = rows[0]["inputs"]["xw"]
        self.assertEqual(rows[0]["inputs"]["n"], [0, 0, 1])
        corners = ",".join(f"(POINT/{px},{py},{z})" for px, py in ((x - 300, y - 10), (x - 20, y - 10), (x - 20, y + 10), (x - 300, y + 10)))
        self.write("part.apt", f"UNITS/MM\nG1=GUN/ELLIPS,20,20,STNDOF,{rows[0]['inputs']['d']},SPEED,100\nR1=REGION/{corners}\n"
                               "SPRAY/R1,GUN,G1,FILM,.05\nFINI\n")
        self.assertExit(0, "compile", "part.apt")
        last = [line for line in self.out.splitlines() if "GOTO" in line][-1]
        place = [float(v) for v in last.split("/")[1].split(",")]
        for got, wanted in zip(place, rows[0]["expected"]["p"] + rows[0]["inputs"]["n"]):
            self.assertAlmostEqual(got, wanted, delta=rows[0]["tolerance"])

    def test_a_lopsided_gun_keeps_its_side(self):
        for table, numbers in (("-10,0,0,4,10,0", 6), ("-10,0,-5,4,10,0", 9)):
            with self.subTest(table):
                self.write("part.apt", f"UNITS/MM\nG1=GUN/TABLE,{table},STNDOF,100,SPEED,100\nR1=REGION/(0,0),(90,0),(90,40),(0,40)\n"
                                       "SPRAY/R1,GUN,G1,FILM,.05\nFINI\n")
                self.assertExit(0, "compile", "part.apt")
                places = [line.split("/")[1].split(",") for line in self.out.replace("$\n", "").splitlines() if "GOTO" in line]
                self.assertGreater(len(places), 3)
                self.assertEqual({len(p) for p in places}, {numbers})
                if numbers == 9:  # not turned over from pass to pass
                    self.assertEqual({tuple(float(v) for v in p[6:]) for p in places}, {(0, 1, 0)})

    def test_a_table_file_with_decimal_commas_is_told(self):
        self.write("part.apt", "UNITS/MM\nG1=GUN/TABLE,'m.csv',STNDOF,100,SPEED,100\nR1=REGION/(0,0),(90,0),(90,40),(0,40)\n"
                               "SPRAY/R1,GUN,G1,FILM,.05\nFINI\n")
        for text, line in (('"-10,5","0,0"\n"10,5","1,0"\n', 1), ("place;film\n-10,5;0\n", 2), ("-10,0\nfilm,1\n", 2)):
            with self.subTest(text):
                self.write("m.csv", text)
                self.assertExit(4, "compile", "part.apt")
                self.assertIn(f"no two numbers in line {line};", self.err)
        self.write("m.csv", "place,film\n# measured on a Monday\n-10,0\n0,1\n10,0\n")
        self.assertExit(0, "compile", "part.apt")

    def test_outputs_are_whole_numbers(self):
        for words, what in (("ON,1.7", "the output of SPRAY is 1.7; it must be a whole number, 1 to 9999"),
                            ("OFF,0", "the output of SPRAY is 0"), ("ON,OFF", "behind ON or OFF"),
                            ("ON,1,2", "behind ON or OFF")):
            with self.subTest(words):
                self.write("part.apt", f"FROM/0,0,0\nSPRAY/{words}\nGOTO/1,0,0\nFINI\n")
                self.assertExit(4, "compile", "part.apt", "-o", "part.cls")
                self.assertIn(what, self.err)
                self.assertEqual(self.files(), ["part.apt"])

    def test_a_path_that_sprays_too_little_has_no_negative_paint(self):
        # One pass of 20 along the far edge of a strip of 40: half of its paint falls beside the work, the rest lacks.
        one = self.spray("UNITS/MM\nG1=GUN/ELLIPS,10,10,SPEED,100\nR1=REGION/(0,0),(500,0),(500,40),(0,40)\n"
                         "SPRAY/R1,GUN,G1,FILM,.05,OVRLAP,0,INSET,10,MINCST,60,10,2,2\n")[0]
        for key, value in one["paint"].items():
            self.assertGreaterEqual(value, 0, key)
        self.assertAlmostEqual(one["paint"]["deposited"] + one["paint"]["missing"], 500 * 40 * .05e-6, places=12)
        self.assertAlmostEqual(one["paint"]["used"], sum(one["paint"][k] for k in ("deposited", "overspray", "sprayBy")), places=12)
        self.assertGreaterEqual(min(one["cost"].values()), 0)

    def test_searches_have_a_limit(self):
        search = GUN + PLATE + "SPRAY/R1,GUN,G1,FILM,.051,MINCST,60,10,2,2,HEIGHT,40,70,2,ANGLE,0,90,5\n"
        self.write("part.apt", search + "FINI\n")
        self.assertExit(0, "compile", "part.apt", "-o", "part.cls")
        for flag, most in (("--max-searched", 2000), ("--max-trials", 300)):
            self.assertExit(7, "compile", "part.apt", "-o", "other.cls", flag, str(most))
            self.assertIn("E0359", self.err)
            self.assertIn("16 sizes at 19 angles", self.err)
            self.assertIn(f"the limit is {most} ({flag} N)", self.err)
            self.assertNotIn("other.cls", self.files())

    def test_passes_lines_and_corners_have_limits(self):
        # A plate of 800 with footprints of 2 b = 20 apart by 20 (1 - beta): 80 passes at beta = 1/2, 40 lines of 20.
        plate = GUN.replace(".7,1", "10,10") + PLATE + "P1=PLANE/0,0,1,0\n"
        over = plate + "SPRAY/R1,GUN,G1,FILM,.05,OVRLAP,.5\n"
        lines = plate + "SPRAY/P1,GUN,G1,FILM,.05,ULINES,LIMITS,0,400,0,800,STEP,20\n"
        disk = plate + "R2=REGION/(CIRCLE/0,0,100),CHORD,.01\nSPRAY/R2,GUN,G1,FILM,.05\n"
        for text, code, flag, few, enough in ((over, "E0375", "--max-passes", 70, 90), (lines, "E0375", "--max-passes", 39, 41),
                                              (disk, "E0393", "--max-corners", 200, 300)):
            self.write("part.apt", text + "FINI\n")
            self.assertExit(7, "compile", "part.apt", "-o", "part.cls", flag, str(few))
            self.assertIn(code, self.err)
            self.assertIn(flag, self.err)
            self.assertNotIn("part.cls", self.files())
            self.assertExit(0, "compile", "part.apt", "-o", "part.cls", flag, str(enough))
            (self.folder / "part.cls").unlink()

    def test_lines_go_past_the_edges(self):
        # A plane of 200 by 100, lines 20 apart: 6 of 200; 30 past its edges 8 of 260.
        surface = ("UNITS/MM\nG1=GUN/CONE,45,STNDOF,30,SPEED,500\nP1=PLANE/0,0,1,0\n"
                   "SPRAY/P1,GUN,G1,FILM,.05,ULINES,LIMITS,0,200,0,100,STEP,20")
        one, = self.spray(surface + "\n")
        self.assertEqual((one["passes"], one["past"]), (6, 0))
        self.assertAlmostEqual(one["Xi"], 1200, places=6)
        self.assertLess(one["simulated"]["min"], .5 * one["film"])
        one, = self.spray(surface + ",PAST,30\n")
        self.assertEqual((one["passes"], one["past"]), (8, 30))
        self.assertAlmostEqual(one["Xi"], 8 * 260, places=6)
        self.assertGreater(one["simulated"]["min"], .75 * one["film"])
        # The same by planes.
        one, = self.spray(surface.replace("LIMITS,0,200,0,100", "LIMITS,XLARGE,(PLANE/1,0,0,0),XSMALL,(PLANE/1,0,0,200),"
                                          "YLARGE,(PLANE/0,1,0,0),YSMALL,(PLANE/0,1,0,100)") + ",PAST,30\n")
        self.assertGreater(one["simulated"]["min"], .75 * one["film"])
        self.assertAlmostEqual(one["area"], 20000, delta=200)

    def test_numbers_that_cannot_be(self):
        surface = "SPRAY/(SPHERE/0,0,0,300),GUN,G1,FILM,.05,ULINES,"
        for words in ("SPRAY/R1,GUN,G1,FILM,.05,MINCST,-60,10,2,2", "SPRAY/R1,GUN,G1,FILM,.05,MINCST,60,10,2,-2",
                      surface + "CHORD,0", surface + "CHORD,.00000000001", surface + "PAST,-1", surface + "PAST,1000",
                      surface + "STEP,-1", "SPRAY/R1,GUN,G1,FILM,0", "SPRAY/R1,GUN,G1,FILM,.05,OVRLAP,1"):
            self.write("part.apt", GUN.replace(".7,1", "7,10") + PLATE + words + "\nFINI\n")
            self.assertExit(4, "compile", "part.apt", "-o", "part.cls")
            self.assertIn("E0373", self.err, words)
            self.assertNotIn("part.cls", self.files())

    def test_passes_have_a_limit(self):
        small = "G2=GUN/ELLIPS,.01,.01,SPEED,500\n"
        cases = {"R1,GUN,G1,FILM,.05,OVRLAP,.9999999": "1e+07 passes over each place",
                 "R1,GUN,G2,FILM,.05": "passes are needed; the limit is 20000",
                 "(SPHERE/0,0,0,300),GUN,G2,FILM,.05,ULINES": "lines are needed; the limit is 20000"}
        for words, told in cases.items():
            self.write("part.apt", GUN + small + PLATE + f"SPRAY/{words}\nFINI\n")
            self.assertExit(7, "compile", "part.apt", "-o", "part.cls")
            self.assertIn("E0375", self.err)
            self.assertIn(told, self.err)

    def test_nothing_is_written_after_an_error(self):
        self.write("part.apt", GUN + "R1=REGION/(0,0),(9,9),(9,0),(0,9)\nSPRAY/R1,GUN,G1,FILM,.05\nFINI\n")
        self.assertExit(4, "compile", "part.apt", "-o", "part.cls")
        self.assertExit(4, "spray", "part.apt", "--film", "a.png")
        self.assertEqual(self.files(), ["part.apt"])

    def test_units_do_not_change_the_work(self):
        mm = self.spray("UNITS/MM\nG1=GUN/CONE,15,STNDOF,254,SPEED,500\nR1=REGION/(0,0),(1016,0),(1016,508),(0,508)\n"
                        "SPRAY/R1,GUN,G1,FILM,.05\n")[0]
        inch = self.spray("UNITS/INCHES\nG1=GUN/CONE,15,STNDOF,10,SPEED,500\nR1=REGION/(0,0),(40,0),(40,20),(0,20)\n"
                          "SPRAY/R1,GUN,G1,FILM,.05\n")[0]
        for key in ("area", "b", "Xi", "Ti", "q"):
            self.assertAlmostEqual(mm[key], inch[key], delta=1e-9 * mm[key])

    def test_samples_of_surfaces(self):
        gun = "UNITS/MM\nB=GUN/CALIB,'binks',PRESS,117,VALVE,6,STNDOF,160,EFFIC,.45\n"
        one = self.spray(gun + "P=PLANE/0,0,1,0\nSPRAY/P,GUN,B,FILM,.12,ULINES,LIMITS,200,600,200,600\n")[0]
        self.assertEqual(one["passes"], 18)
        self.assertAlmostEqual(one["interval"], 23.5294, delta=6e-5)
        gun = gun.replace("117,VALVE,6,STNDOF,160", "110,VALVE,0,STNDOF,150")
        one = self.spray(gun + "C=CYLNDR/0,0,0,0,1,0,100\nSPRAY/C,GUN,B,FILM,.12,VLINES,LIMITS,0,180,0,400\n")[0]
        self.assertEqual(one["passes"], 17)
        self.assertAlmostEqual(one["interval"], 19.634954, delta=1e-3)
        self.assertAlmostEqual(one["curvature"]["across"], 100, delta=.01)
        self.assertIsNone(one["curvature"]["along"])


if __name__ == "__main__":
    unittest.main()
