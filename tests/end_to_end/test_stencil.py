#!/usr/bin/env python3
"""STENCL by the commands `stencil` and `alphabet`: report, contour pictures, refusals that leave nothing behind."""
import csv
import json
import pathlib
import re
import unittest

from arelem_run import ArelemCase

PROJECT = pathlib.Path(__file__).resolve().parents[2]
HEAD = "UNITS/MM\n"


class Stencil(ArelemCase):
    def stencil(self, text, *words):
        self.write("part.apt", HEAD + text + "\nFINI\n")
        self.assertExit(0, "stencil", "part.apt", "--json", *words)
        return json.loads(self.out)

    def refused(self, text, code, exit_code=4):
        self.write("part.apt", HEAD + text + "\nFINI\n")
        self.assertExit(exit_code, "part.apt", "-o", "part.cls")
        self.assertIn(code, self.err)
        self.assertFalse((self.folder / "part.cls").exists())

    def test_report_of_straight_letters(self):
        # An I of 2500 mm: 100 mm wide, 600 mm/s.
        (one,) = self.stencil("STENCL/'I',HEIGHT,2500,FAN,63.5,SPEED,600")
        self.assertEqual(one["speed"], [600, 600])
        self.assertAlmostEqual(one["sprayedWay"], 2500)
        self.assertAlmostEqual(one["sprayingTime"], 2500 / 600)
        for film in one["symbols"][0]["film"]:
            self.assertAlmostEqual(film, 1)
        self.assertAlmostEqual(one["all"]["area"], 250000)

    def test_text_report_names_letters(self):
        self.write("part.apt", HEAD + "STENCL/'GO 24',HEIGHT,2440,FAN,63.5,SPEED,600,TILT,QUADR\nFINI\n")
        self.assertExit(0, "stencil", "part.apt")
        self.assertEqual(re.findall(r"^  (\S+) +\d+ +[\d.]+ +[\d.]+ +[\d.]+ to ", self.out, re.M), ["G", "O", "2", "4", "all"])

    def test_areas_of_small_letters_and_what_lies_twice(self):
        # An I of 25 mm: 1 by 25 mm; two bars of 4 by 1 units that cross in one unit.
        self.write("x.alphabet", "GRID 4 4\nSYMBOL +\nSTROKE 5 0,1 0,2 TO 4,1 4,2\nSTROKE 5 1,0 2,0 TO 1,4 2,4\n")
        for text, line in (("'I',HEIGHT,25,FAN,63.5,SPEED,60", r"  I +1 +0.25 +0 "), ("'I',HEIGHT,2500,FAN,63.5,SPEED,60", r"  I +1 +0.25 +0 "),
                           ("'+',HEIGHT,40,FAN,63.5,SPEED,60,ALPHAB,'x.alphabet'", r"  \+ +2 +8 +1 ")):
            self.write("part.apt", HEAD + f"STENCL/{text}\nFINI\n")
            self.assertExit(0, "stencil", "part.apt")
            self.assertRegex(self.out, line)

    def test_symbols_without_strokes(self):
        self.write("x.alphabet", "GRID 4 25\nSYMBOL A\nSTROKE 5 0,0 1,0 TO 0,25 1,25\nSYMBOL B\nPEN FROM 0,0 LINE 0,6\n")
        self.refused("STENCL/'AB',HEIGHT,2500,FAN,63.5,SPEED,600,ALPHAB,'x.alphabet'", "E0743", 3)
        self.assertIn("symbol 2 of the text, `B`", self.err)
        self.write("x.alphabet", "GRID 4 25\nSYMBOL A\nSYMBOL B\nPEN FROM 0,0 LINE 0,6\n")
        self.refused("STENCL/'A',HEIGHT,2500,FAN,63.5,SPEED,600,ALPHAB,'x.alphabet'", "E0740", 3)
        self.assertIn("needs a STROKE or a PEN", self.err)

    def test_pictures(self):
        self.stencil("STENCL/'P',HEIGHT,2500,FAN,63.5,SPEED,600,TILT,TRAPZ", "--film", "f.svg", "--film", "f.png", "--film",
                     "f.csv", "--shares", "s.svg")
        self.assertIn("film over the mean film", (self.folder / "f.svg").read_text())
        self.assertIn("share of the cell, %", (self.folder / "s.svg").read_text())
        self.assertEqual((self.folder / "f.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
        rows = list(csv.DictReader((self.folder / "f.csv").read_text().splitlines()))
        for row in rows:
            self.assertAlmostEqual(float(row["share_first"]) + float(row["share_second"]), 100, 3)
        # The bowl of Blank, section 2.5: 46.7 to 53.3 percent (case BLANK-ratio-trapezoid).
        shares = [float(row["share_first"]) for row in rows if row["stroke"] == "2"]
        self.assertGreater(min(shares), 46.5)
        self.assertLess(max(shares), 53.5)

    def test_gun_gives_speed_and_film(self):
        gun = "G=GUN/FAN,63.5,STNDOF,300,SPEED,900,FLOW,2,EFFIC,.9,OUTPUT,3\n"
        # 2 l/min, 90 % of it: 30000 mm3/s; a film of 0.5 mm over lines 100 mm wide at 600 mm/s.
        (one,) = self.stencil(gun + "STENCL/'I',HEIGHT,2500,GUN,G,FILM,.5")
        self.assertAlmostEqual(one["speedOfGridUnit"], 600)
        self.assertAlmostEqual(one["meanFilm"], 0.5)
        (fast,) = self.stencil(gun + "STENCL/'IS',HEIGHT,2500,GUN,G")
        self.assertLessEqual(fast["speed"][1], 900)
        self.assertGreater(fast["speed"][1], 890)
        self.assertExit(0, "part.apt", "-o", "part.cls")
        text = (self.folder / "part.cls").read_text()
        self.assertIn("SPRAY / ON, 3", text)
        self.assertEqual(text.count("FLOW / 2"), 1)

    def test_heights_in_any_unit(self):
        (mm,) = self.stencil("STENCL/'S',HEIGHT,2540,FAN,63.5,SPEED,600")
        self.write("part.apt", "UNITS/INCHES\nSTENCL/'S',HEIGHT,100,FAN,63.5,SPEED,600\nFINI\n")
        self.assertExit(0, "stencil", "part.apt", "--json")
        (inches,) = json.loads(self.out)
        self.assertAlmostEqual(mm["sprayedWay"], inches["sprayedWay"])

    def test_bad_input_is_named(self):
        self.refused("STENCL/'STOP!',HEIGHT,2500,FAN,63.5,SPEED,600", "E0560")
        self.assertIn("`!`", self.err)
        self.assertIn("A B C", self.err)
        self.refused("STENCL/'AÖB',HEIGHT,2500,FAN,63.5,SPEED,600", "E0560")
        self.assertIn("character 2 of the text, `Ö`", self.err)
        self.refused("STENCL/'STOP',HEIGHT,0,FAN,63.5,SPEED,600", "E0561")
        self.refused("STENCL/'STOP',HEIGHT,2500,FAN,180,SPEED,600", "E0561")
        for words, told in (("FAN,179.999,SPEED,600", "the angle of the fan is 179.999"), ("FAN,1,SPEED,600", "the angle of the fan is 1;"),
                            ("FAN,63.5,SPEED,600,SPACE,-500", "SPACE is -500"), ("FAN,63.5,SPEED,600,TILT,BEST,10,0", "the rate of TILT"),
                            ("FAN,63.5,SPEED,600,TILT,BEST,0", "the largest tilt of TILT is 0"),
                            ("FAN,63.5,SPEED,600,0", "the largest speed of SPEED is 0"),
                            ("FAN,63.5,500,-1,SPEED,600", "the second number of the height of FAN is -1")):
            self.refused(f"STENCL/'STOP',HEIGHT,2500,{words}", "E0561")
            self.assertIn(told, self.err)
        for words in ("FAN,63.5,-300,.8,SPEED,600", "FAN,63.5,-20,.2,SPEED,600,TILT,BEST"):
            self.refused(f"STENCL/'STOP',HEIGHT,2500,{words}", "E0561")
            self.assertIn("the height of the nozzle", self.err)
        for height in (".001", "1.E-9", "1.E12", "1.E300"):
            self.refused(f"STENCL/'STOP',HEIGHT,{height},FAN,63.5,SPEED,600", "E0561")
            self.assertIn("HEIGHT in mm", self.err)
        # A gun that would be off before it is on, at the speed that is looked for.
        self.refused("G=GUN/FAN,63.5,STNDOF,300,SPEED,900,LEAD,.1,5\nSTENCL/'SI',HEIGHT,2500,GUN,G", "E0742", 3)
        self.refused("STENCL/'STOP',HEIGHT,2500,FAN,63.5,SPEED,600,300", "E0562")
        # The factor is that of the fastest of all strokes, and does.
        for text, tilt, near in (("STOP", "OFF", .001), ("IS8", "OFF", .001), ("IS8", "BEST,25,60", .01), ("SB", "QUADR,20,40", .01)):
            statement = f"STENCL/'{text}',HEIGHT,2500,FAN,63.5,TILT,{tilt},SPEED"
            self.refused(f"{statement},600,300", "E0562")
            factor = float(re.search(r"a SPEED (0\.\d+) times as large would do", self.err)[1])
            self.stencil(f"{statement},{600 * factor},300")
            self.refused(f"{statement},{600 * (factor + near)},300", "E0562")
        self.refused("STENCL/'  ',HEIGHT,2500,FAN,63.5,SPEED,600", "E0563")
        self.refused("STENCL/'A',HEIGHT,2500,FAN,63.5", "E0565")
        self.refused("STENCL/'A',HEIGHT,2500,SPEED,600", "E0565")
        self.refused("STENCL/'A',HEIGHT,2500,FAN,63.5,FILM,.4", "E0565")
        self.refused("G=GUN/CONE,14,STNDOF,200\nSTENCL/'A',HEIGHT,2500,GUN,G,SPEED,600", "E0567")

    def test_wrong_use(self):
        self.write("part.apt", HEAD + "FINI\n")
        self.assertExit(2, "stencil", "part.apt", "--film", "x.jpg")
        self.assertExit(2, "stencil", "part.apt", "--shares", "x.png")
        self.assertExit(0, "stencil", "part.apt")
        self.assertIn("no STENCL", self.err)


class Alphabet(ArelemCase):
    def test_chart_has_every_symbol(self):
        self.assertExit(0, "alphabet", "-o", "chart.svg")
        chart = (self.folder / "chart.svg").read_text()
        for name in [*"ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-", "&lt;AHEAD&gt;", "&lt;LEFT&gt;", "&lt;RIGHT&gt;"]:
            self.assertIn(f">{name}</text>", chart)

    def test_charts_are_what_their_suffix_says(self):
        self.assertExit(0, "alphabet", "-o", "chart.png")
        self.assertEqual((self.folder / "chart.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
        self.assertExit(2, "alphabet", "-o", "chart.pdf")
        self.assertFalse((self.folder / "chart.pdf").exists())

    def test_shares_of_primitives(self):
        # Blank, section 2.5: in its straight cells 58 and 42 (58.45 for his own division) without tilt; 46.7 to 53.3 by the trapezoid;
        # better by the quadrilateral.
        self.assertExit(0, "alphabet", "--primitive", "1")
        rows = {name: [(float(a), float(b)) for a, b in re.findall(r"([\d.]+) (?:to|and) ([\d.]+)", line)]
                for line in self.out.splitlines() for name in ("shares, %", "first cell, %") if f" {name} " in line}
        self.assertIn(rows["first cell, %"][0], ((58.5, 41.5), (41.5, 58.5)))
        off, trapezoid, quadrilateral, best = rows["shares, %"]
        self.assertEqual(trapezoid, (46.7, 53.3))
        self.assertLess(off[0], trapezoid[0])
        self.assertGreater(quadrilateral[0], trapezoid[0])
        self.assertGreater(best[0], trapezoid[0])
        for primitive in (2, 3, 4, 5):
            self.assertExit(0, "alphabet", "--primitive", str(primitive))
            self.assertIn("shares, %", self.out)
        self.assertExit(2, "alphabet", "--primitive", "6")

    def test_damaged_file(self):
        self.write("x.alphabet", "GRID 4 25\nSYMBOL A\nSTROKE 9\n")
        self.assertExit(3, "alphabet", "x.alphabet", "-o", "chart.svg")
        self.assertIn("line 3, column 8", self.err)
        self.assertFalse((self.folder / "chart.svg").exists())


if __name__ == "__main__":
    unittest.main()
