#!/usr/bin/env python3
"""Bad input of spray painting: each variant is told with its numbers and what would help; nothing is written."""
import re
import unittest

from arelem_run import ArelemCase

GUN = "G1=GUN/CONE,14,STNDOF,200,SPEED,600,EFFIC,.5,FLOW,.2\n"  # footprint radius 200 tan 14 = 49.8656
OUTLINE = "(0,0),(300,0),(300,200),(0,200)"
PLATE = f"R1=REGION/{OUTLINE}\n"
SPRAY = "SPRAY/R1,GUN,G1,FILM,.05\n"
PLANE = "S1=PLANE/0,0,1,0\n"
ON_PLANE = "SPRAY/S1,GUN,G1,FILM,.05,ULINES,LIMITS,0,300,0,200"


def region(text):
    return f"R1=REGION/{text}\n{GUN}{SPRAY}"


def gun(text):
    return f"{PLATE}G1=GUN/{text}\n{SPRAY}"


def spray(text):
    return f"{PLATE}{GUN}SPRAY/R1,GUN,G1,{text}\n"


def surface(text, rest):
    return f"S1={text}\n{GUN}SPRAY/S1,GUN,G1,FILM,.02,{rest}\n"


# What is wrong, the program, the code, and what the message says.
BAD = {
    # open outlines
    "two corners": (region("(0,0),(300,0)"), "E0360", ["2 different corners", "at least 3"]),
    "corners in one place": (region("(0,0),(0,0),(300,0)"), "E0360", ["2 different corners"]),
    "lines that do not meet": (region("(LINE/0,0,300,0),(LINE/300,0,300,200),(LINE/0,200,0,300)"), "E0365", ["elements 2 and 3", "300 apart"]),
    "a circle out of reach": (region("(LINE/0,0,300,0),(CIRCLE/600,0,50),(LINE/300,200,0,200)"), "E0365", ["elements 3 and 1", "200 apart"]),
    "a line that meets a circle twice": (region("(LINE/0,0,300,0),(CIRCLE/150,0,50)"), "E0366", ["(100, 0)", "(200, 0)", "XLARGE"]),
    # crossing outlines
    "a bow tie": (region("(0,0),(300,200),(300,0),(0,200)"), "E0362", ["edge 1 of boundary 1 and edge 3", "(150, 100, 0)"]),
    "an edge that runs back": (region("(0,0),(300,0),(150,0),(150,200)"), "E0362", ["edge 1", "edge 2"]),
    "a hole across the edge": (region(OUTLINE + ",HOLE,(100,100),(400,100),(400,150)"), "E0362", ["(300, 100, 0)", "boundary 2"]),
    "holes that cross": (region(OUTLINE + ",HOLE,(100,50),(200,50),(200,150),(100,150),HOLE,(150,100),(250,100),(250,180)"),
                         "E0362", ["(200, 100, 0)", "boundary 2", "boundary 3"]),
    "a hole that touches": (region(OUTLINE + ",HOLE,(0,100),(50,80),(50,120)"), "E0362", ["(0, 100, 0)"]),
    # not in one plane
    "a corner lifted": (region("(0,0,0),(300,0,0),(300,200,5),(0,200,0)"), "E0361", ["(300, 200, 5)", "5 off the plane", "is the limit"]),
    "a hole lifted": (region("(0,0,0),(300,0,0),(300,200,0),(0,200,0),HOLE,(50,50,1),(100,50,1),(100,100,1)"), "E0361", ["1 off the plane"]),
    "corners in a row": (region("(0,0),(300,0),(600,0)"), "E0364", ["no area"]),
    # holes outside
    "a hole beside": (region(OUTLINE + ",HOLE,(400,50),(500,50),(500,100)"), "E0363", ["hole (boundary 2) lies in no outline"]),
    "a hole around": (region(OUTLINE + ",HOLE,(-100,-100),(500,-100),(500,500),(-100,500)"), "E0363", ["outline (boundary 1)"]),
    "a hole in a hole": (region(OUTLINE + ",HOLE,(CIRCLE/150,100,80),HOLE,(CIRCLE/150,100,40)"), "E0363", ["hole (boundary 3) lies in another hole"]),
    "a hole as large as the outline": (region(f"{OUTLINE},HOLE,{OUTLINE}"), "E0343", ["boundaries 1 and 2"]),
    # film
    "no film": (spray("FILM,0"), "E0373", ["FILM of SPRAY is 0", "above 0 mm"]),
    "a negative film": (spray("FILM,-.05"), "E0373", ["-0.05"]),
    "no FILM at all": (spray("OVRLAP,.2"), "E0372", ["FILM, h"]),
    "no film on a surface": (surface("PLANE/0,0,1,0", "ULINES,LIMITS,0,100,0,100").replace("FILM,.02", "FILM,0"), "E0373", ["FILM of SPRAY is 0"]),
    # overlap
    "an overlap of 1": (spray("FILM,.05,OVRLAP,1"), "E0373", ["overlap of SPRAY is 1;", "at least 0 and below 1"]),
    "an overlap above 1": (spray("FILM,.05,OVRLAP,1.5"), "E0373", ["is 1.5;"]),
    "a negative overlap": (spray("FILM,.05,OVRLAP,-.1"), "E0373", ["is -0.1;"]),
    "an overlap of nearly 1": (spray("FILM,.05,OVRLAP,.9999999"), "E0375", ["1e+07 passes", "a smaller OVRLAP"]),
    # flow and speed
    "too much flow": (spray("FILM,.05,SPEED,600"), "E0376", ["0.296104 l/min", "above the gun's 0.2", "help: SPEED, 405.26"]),
    "faster than the gun": (spray("FILM,.05,SPEED,700"), "E0373", ["SPEED of SPRAY is 700", "at most 600 mm/s"]),
    "too much flow on a surface": (f"{PLANE}{GUN}{ON_PLANE},SPEED,600".replace(".05", ".2") + "\n", "E0376", ["above the gun's 0.2", "help: SPEED, "]),
    "a gun without flow and speed": (gun("CONE,14,STNDOF,200"), "E0374", ["SPEED or FLOW"]),
    # the gun's table
    "pressure above the table": (gun("CALIB,'binks',PRESS,500,VALVE,0,STNDOF,150,SPEED,600"), "E0354", ["pressure 500 kPa", "110 to 152 kPa"]),
    "pressure below the table": (gun("CALIB,'binks',PRESS,109.9,VALVE,0,STNDOF,150,SPEED,600"), "E0354", ["pressure 109.9 kPa"]),
    "valve above the table": (gun("CALIB,'binks',PRESS,110,VALVE,54.1,STNDOF,150,SPEED,600"), "E0354", ["valve position 54.1 degrees", "-6 to 54 degrees"]),
    "valve below the table": (gun("CALIB,'binks',PRESS,110,VALVE,-7,STNDOF,150,SPEED,600"), "E0354", ["valve position -7 degrees"]),
    # radius
    "a thin cylinder": (surface("CYLNDR/0,0,0,0,1,0,30", "ULINES,LIMITS,0,180,0,400"), "E0379", ["radius of 30 mm", "49.8656 mm", "MINRAD, OFF"]),
    "a small sphere": (surface("SPHERE/0,0,0,49", "ULINES"), "E0379", ["radius of 49 mm"]),
    "a thin torus": (surface("TORUS/0,0,0,0,0,1,500,40", "ULINES"), "E0379", ["radius of 40 mm"]),
    "a hollow narrower than the stand-off": (surface("CYLNDR/0,0,0,0,1,0,150", "VLINES,LIMITS,0,180,0,400,REVERS"), "E0389",
                                             ["stands off 200 mm", "radius of 150 mm"]),
    # guns
    "one axis of an ellipse": (gun("ELLIPS,40,SPEED,600"), "E0304", ["GUN lacks a parameter", "`b` would fit", "ELLIPS, a, b"]),
    "three numbers of an ellipse": (gun("ELLIPS,40,30,50,SPEED,600"), "E0305", ["parameter 4 of GUN", "one too many"]),
    "a table without its last film": (gun("TABLE,0,1,5,SPEED,600"), "E0305", ["parameter 4 of GUN", "{place, film}"]),
    "a table of one place": (gun("TABLE,0,1,SPEED,600"), "E0352", ["1 points", "at least 2"]),
    "places that fall": (gun("TABLE,5,1,0,1,SPEED,600"), "E0352", ["the place 0 after 5"]),
    "a table of nothing": (gun("TABLE,0,0,5,0,SPEED,600"), "E0352", ["no film at all"]),
    "a negative measurement": (gun("TABLE,0,-1,5,2,SPEED,600"), "E0352", ["-1 at 0"]),
}


class BadInput(ArelemCase):
    def refused(self, program, code, parts, words=()):
        self.write("a.apt", f"UNITS/MM\n{program}FINI\n")
        for name in ("a.cls", "a.lng", "a.v2", "a.ngc"):
            self.write(name, "old")
        before = self.files()
        result = self.run_arelem("a.apt", "-o", "a.cls", "-o", "a.lng", *words)
        self.assertIn(result, (4, 6, 7), self.err)
        self.assertIn(f"error[{code}]", self.err)
        for part in parts:
            self.assertIn(part, self.err)
        self.assertEqual(self.files(), before)
        for name in ("a.cls", "a.lng"):
            self.assertEqual((self.folder / name).read_text(), "old")

    def test_each_is_told_and_nothing_is_written(self):
        for name, (program, code, parts) in BAD.items():
            with self.subTest(name):
                self.refused(program, code, parts)

    def test_the_speed_that_is_offered_works(self):
        for film in (.05, .0517, .09, .123456, .31):
            for statement in (f"R1=REGION/{OUTLINE}\n{GUN}SPRAY/R1,GUN,G1,FILM,{film}", PLANE + GUN + ON_PLANE.replace(".05", str(film))):
                with self.subTest(film=film, surface="ULINES" in statement):
                    self.write("a.apt", f"UNITS/MM\n{statement},SPEED,600\nFINI\n")
                    if self.run_arelem("a.apt") == 0:
                        self.assertLess(film, .1)
                        continue
                    offered = re.search(r"help: SPEED, ([\d.]+) ", self.err).group(1)
                    self.write("a.apt", f"UNITS/MM\n{statement},SPEED,{offered}\nFINI\n")
                    self.assertExit(0, "a.apt")
                    self.assertIn(f"FEDRAT / {offered}, MMPS", self.out)

    def test_poses_out_of_reach(self):
        good = f"{PLATE}{GUN}{SPRAY}"
        for machine, code, parts in (("[envelope]\nx = [0, 200]\n", "E0667", ["x", "200"]), ("[envelope]\nz = [0, 150]\n", "E0667", ["z", "150"]),
                                     ("[envelope]\ncenter = [0, 0, 0]\nreach = [0, 300]\n", "E0667", ["300"])):
            with self.subTest(machine):
                self.write("m.toml", machine)
                self.refused(good, code, parts, ("--machine", "m.toml"))
        self.write("m.toml", "[envelope]\nlean = 30\n")
        self.refused(surface("CYLNDR/0,0,0,0,1,0,150", "VLINES,LIMITS,0,180,0,400"), "E0667", ["is 180;", "0 to 30"], ("--machine", "m.toml"))

    def test_drawings_that_lie(self):
        def drawing(*entities):
            return "0\nSECTION\n2\nENTITIES\n" + "".join(entities) + "0\nENDSEC\n0\nEOF\n"

        line = "0\nLINE\n10\n{}\n20\n{}\n11\n{}\n21\n{}\n".format
        circle = "0\nCIRCLE\n10\n{}\n20\n{}\n40\n{}\n".format
        for name, text, code, parts in (
                ("vertices", drawing("0\nLWPOLYLINE\n90\n4\n70\n1\n10\n0\n20\n0\n10\n9\n20\n0\n10\n9\n20\n9\n"), "E0367", ["says 4 vertices", "3"]),
                ("a huge count", drawing("0\nLWPOLYLINE\n90\n2000000000\n70\n1\n10\n0\n20\n0\n10\n9\n20\n0\n10\n9\n20\n9\n"), "E0367", ["2000000000"]),
                ("knots", drawing("0\nSPLINE\n71\n3\n72\n8\n73\n4\n40\n0\n40\n1\n"), "E0367", ["says 8 knots"]),
                ("control points", drawing("0\nSPLINE\n71\n1\n72\n4\n73\n2\n40\n0\n40\n0\n40\n1\n40\n1\n10\n0\n20\n0\n"), "E0367", ["line"]),
                ("open by 3 mm", drawing(line(0, 0, 90, 0), line(90, 0, 90, 80), line(90, 80, 0, 3)), "E0369", ["(0, 0)", "(0, 3)", "3 apart"]),
                ("three ends", drawing(line(0, 0, 90, 0), line(90, 0, 90, 80), line(90, 80, 0, 0), line(0, 0, 9, 9)), "E0371", ["3 ends", "(0, 0)"]),
                ("crossing circles", drawing(circle(0, 0, 50), circle(60, 0, 50)), "E0362", ["edge", "meet at ("]),
                ("texts and blocks", drawing(circle(0, 0, 50), "0\nTEXT\n1\nA\n", "0\nTEXT\n1\nB\n", "0\nINSERT\n2\nB\n"), "E0368", ["1 INSERT of block `B`, which the drawing does not have (line", "2 TEXT (the first in line"]),
                ("nothing", drawing(), "E0370", ["no curves"]),
                ("cut off", drawing(circle(0, 0, 50))[:-20], "E0367", ["line"]),
                ("not a drawing", "hello\nworld\n", "E0367", ["line 1"])):
            with self.subTest(name):
                self.write("d.dxf", text)
                self.refused(region("DXF,'d.dxf'"), code, parts)

    def test_a_drawing_of_too_many_corners(self):
        circles = "".join(f"0\nCIRCLE\n10\n{10 * i}\n20\n0\n40\n4\n" for i in range(3000))
        self.write("d.dxf", f"0\nSECTION\n2\nENTITIES\n{circles}0\nENDSEC\n0\nEOF\n")
        self.refused(region("DXF,'d.dxf',CHORD,.0001"), "E0393", ["1000000", "a larger CHORD"])
        self.write("a.apt", "UNITS/MM\nR1=REGION/DXF,'d.dxf',CHORD,.5\nFINI\n")
        self.assertExit(0, "a.apt", "-o", "a.json")
        self.assertExit(7, "a.apt", "-o", "a.json", "--max-corners", "20000")
        # CHORD is kept, or the region is refused: no arc has fewer chords than it needs.
        self.refused(region("(CIRCLE/0,0,10000),CHORD,.0000000001"), "E0393", ["1000000"])


if __name__ == "__main__":
    unittest.main()
