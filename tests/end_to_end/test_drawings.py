#!/usr/bin/env python3
"""REGION/DXF reads drawings that another program (ezdxf) writes, in all versions, with curves of all kinds."""
import json
import math
import pathlib
import re
import subprocess
import sys
import unittest

from arelem_run import ArelemCase

RANDOM = str(pathlib.Path(__file__).with_name("random_drawings.py"))


def drawings():
    """ezdxf of the system's own python; another python may be first in the path."""
    for python in (sys.executable, "/usr/bin/python3"):
        if subprocess.run([python, "-c", "import ezdxf"], capture_output=True).returncode == 0:
            return python
    return None


WRITER = r'''
import math, sys
import ezdxf
version, kind, name = sys.argv[1:4]
doc = ezdxf.new(version)
doc.header["$INSUNITS"] = 4
msp = doc.modelspace()
at = {"layer": "paint"}
if kind == "polyline":
    points = [(0, 0), (400, 0), (400, 300), (0, 300)]
    (msp.add_polyline2d(points, close=True, dxfattribs=at) if version == "R12"
     else msp.add_lwpolyline(points, close=True, dxfattribs=at))
    msp.add_circle((200, 150), 50, dxfattribs=at)
    msp.add_text("not paint", dxfattribs={"layer": "notes"})
elif kind == "slot":
    msp.add_line((0, 0), (100, 0), dxfattribs=at)
    msp.add_arc((100, 20), 20, -90, 90, dxfattribs=at)
    msp.add_line((0, 40), (100, 40), dxfattribs=at)
    msp.add_arc((0, 20), 20, 90, 270, dxfattribs=at)
elif kind == "bulge":
    msp.add_lwpolyline([(0, 0, 0, 0, 1), (10, 0, 0, 0, 1)], close=True, dxfattribs=at)
elif kind == "ellipse":
    msp.add_ellipse((5, 6), (30, 0), 0.5, 0, 2 * math.pi, dxfattribs=at)
elif kind == "spline":
    # a whole circle of radius 10 by four rational quarters
    corners = [(10, 0), (10, 10), (0, 10), (-10, 10), (-10, 0), (-10, -10), (0, -10), (10, -10), (10, 0)]
    weights = [1 if i % 2 == 0 else math.sqrt(.5) for i in range(9)]
    msp.add_rational_spline(corners, weights, 2, knots=[0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4], dxfattribs=at)
doc.saveas(name)
'''


OTHERS = r'''
import sys
import ezdxf
doc = ezdxf.new("R2010")
m = doc.modelspace()
at = {"layer": "all"}
m.add_lwpolyline([(0, 0), (90, 0), (90, 80)], close=True, dxfattribs=at)
for entity in (m.add_text("x"), m.add_text("y"), m.add_mtext("z"), m.add_point((1, 1)), m.add_solid([(0, 0), (1, 0), (1, 1)]),
               m.add_3dface([(0, 0, 0), (1, 0, 0), (1, 1, 0)]), m.add_hatch()):
    entity.dxf.layer = "all"
doc.blocks.new("B").add_line((0, 0), (1, 1))
m.add_blockref("B", (5, 5), dxfattribs=at)
m.add_linear_dim(base=(0, 10), p1=(0, 0), p2=(10, 0), dxfattribs=at).render()
for entity in (m.add_xline((0, 0), (1, 0)), m.add_ray((0, 0), (1, 0)), m.add_mline([(0, 0), (5, 5)])):
    entity.dxf.layer = "lines"
doc.saveas(sys.argv[1])
'''
BLOCKS = r'''
import sys
import ezdxf
doc = ezdxf.new("R2010")
doc.header["$INSUNITS"] = 4
m = doc.modelspace()
m.add_lwpolyline([(0, 0), (400, 0), (400, 300), (0, 300)], close=True)
doc.layers.add("dark").off()
doc.layers.add("cold").freeze()
m.add_circle((200, 150), 20, dxfattribs={"layer": "dark"})
m.add_circle((200, 150), 21, dxfattribs={"layer": "cold"})
doc.layout("Layout1").add_circle((200, 150), 23)
doc.blocks.new("hole").add_circle((7, 0), 5)
doc.blocks.new("holes").add_blockref("hole", (-14, 0), dxfattribs={"xscale": 2, "yscale": 2})
m.add_blockref("holes", (60, 80), dxfattribs={"xscale": 2, "rotation": 90, "column_count": 2, "row_count": 3,
                                             "column_spacing": 120, "row_spacing": -130})
doc.saveas(sys.argv[1])
'''
HEIGHTS = r'''
import sys
import ezdxf
doc = ezdxf.new("R2010")
doc.header["$INSUNITS"] = 4
z = [0, 0, 30, 0] if sys.argv[1] == "slanted" else 4 * [float(sys.argv[1])]
corners = [(x, y, h) for (x, y), h in zip([(0, 0), (100, 0), (100, 80), (0, 80)], z)]
for a, b in zip(corners, corners[1:] + corners[:1]):
    doc.modelspace().add_line(a, b)
doc.saveas(sys.argv[2])
'''


@unittest.skipUnless(drawings(), "python3-ezdxf is not installed")
class Drawings(ArelemCase):
    def spray(self, version, kind):
        made = subprocess.run([drawings(), "-c", WRITER, version, kind, str(self.folder / "a.dxf")], capture_output=True, text=True)
        self.assertEqual(made.returncode, 0, made.stderr)
        self.write("part.apt", "UNITS/MM\nG1=GUN/CONE,10,STNDOF,50,SPEED,100\n"
                               "R1=REGION/DXF,'a.dxf',LAYER,'paint',CHORD,.001\nSPRAY/R1,GUN,G1,FILM,.05\nFINI\n")
        self.assertExit(0, "spray", "part.apt", "--json")
        return json.loads(self.out)[0]

    def test_versions(self):
        for version in ("R12", "R2000", "R2010", "R2018"):
            with self.subTest(version):
                spray = self.spray(version, "polyline")
                self.assertAlmostEqual(spray["area"], 120000 - math.pi * 2500, delta=1)
                self.assertEqual((spray["boundaries"], spray["holes"]), (2, 1))

    def test_curves(self):
        for kind, area in (("slot", 4000 + math.pi * 400), ("bulge", math.pi * 25), ("ellipse", math.pi * 450)):
            with self.subTest(kind):
                self.assertAlmostEqual(self.spray("R2010", kind)["area"], area, delta=area * 1e-3)

    def test_what_bounds_nothing_is_listed(self):
        made = subprocess.run([drawings(), "-c", OTHERS, str(self.folder / "a.dxf")], capture_output=True, text=True)
        self.assertEqual(made.returncode, 0, made.stderr)
        self.write("part.cls", "old")
        for layer, listed in (("all", "1 3DFACE, 1 DIMENSION, 1 HATCH, 1 MTEXT, 1 POINT, 1 SOLID, 2 TEXT"),
                              ("lines", "1 MLINE, 1 RAY, 1 XLINE")):
            with self.subTest(layer):
                self.write("part.apt", f"UNITS/MM\nG1=GUN/CONE,10,STNDOF,50,SPEED,100\nR1=REGION/DXF,'a.dxf',LAYER,'{layer}'\n"
                                       "SPRAY/R1,GUN,G1,FILM,.05\nFINI\n")
                self.assertExit(4, "part.apt", "-o", "part.cls")
                self.assertIn("E0368", self.err)
                self.assertIn("entities that cannot bound a region: " + listed, re.sub(r" \([^)]*line \d+\)", "", self.err))
                self.assertEqual((self.folder / "part.cls").read_text(), "old")

    def test_blocks_and_what_is_hidden(self):
        """A plate with holes from a block in rows and columns; what is hidden is left out and told."""
        made = subprocess.run([drawings(), "-c", BLOCKS, str(self.folder / "a.dxf")], capture_output=True, text=True)
        self.assertEqual(made.returncode, 0, made.stderr)
        self.write("part.apt", "UNITS/MM\nG1=GUN/CONE,10,STNDOF,50,SPEED,100\n"
                               "R1=REGION/DXF,'a.dxf',CHORD,.001\nSPRAY/R1,GUN,G1,FILM,.05\nFINI\n")
        self.assertExit(0, "spray", "part.apt", "--json")
        one, = json.loads(self.out)
        # 400 x 300 less 3 x 2 ellipses of half axes 20 and 10, which the block in the block has as circles of radius 5.
        self.assertEqual(one["holes"], 6)
        self.assertAlmostEqual(one["area"], 400 * 300 - 6 * math.pi * 200, delta=2)
        self.assertEqual(self.err.count("W0357"), 1)
        for listed in ("1 CIRCLE in paper space", "1 CIRCLE on layer `dark`, which is off", "1 CIRCLE on layer `cold`, which is frozen"):
            self.assertIn(listed, self.err)

    def test_heights(self):
        for z, code in ((7, 0), ("slanted", 4)):
            with self.subTest(z):
                made = subprocess.run([drawings(), "-c", HEIGHTS, str(z), str(self.folder / "a.dxf")], capture_output=True, text=True)
                self.assertEqual(made.returncode, 0, made.stderr)
                self.write("part.apt", "UNITS/MM\nG1=GUN/CONE,10,STNDOF,50,SPEED,100\nR1=REGION/DXF,'a.dxf'\n"
                                       "SPRAY/R1,GUN,G1,FILM,.05\nFINI\n")
                self.assertExit(code, "part.apt")
                if code == 0:
                    places = [line.split(",") for line in self.out.splitlines() if "GOTO" in line]
                    self.assertEqual({float(p[2]) for p in places}, {57.0})
                else:
                    self.assertIn("2 LINE that is not parallel to the xy plane", self.err)

    def test_random_loops(self):
        count = 12
        made = subprocess.run([drawings(), RANDOM, str(self.folder), str(count), "1"], capture_output=True, text=True)
        self.assertEqual(made.returncode, 0, made.stderr)
        rows = [line.split() for line in made.stdout.splitlines()]
        self.assertEqual(len(rows), count)
        for name, area, unit in rows:
            with self.subTest(name):
                self.write("part.apt", f"UNITS/MM\nG1=GUN/CONE,10,STNDOF,{500 * float(unit)},SPEED,100\n"
                                       f"R1=REGION/DXF,'{name}',LAYER,'paint',CHORD,{.0005 * float(unit)}\nSPRAY/R1,GUN,G1,FILM,.05\nFINI\n")
                self.assertExit(0, "spray", "part.apt", "--json")
                self.assertAlmostEqual(json.loads(self.out)[0]["area"] / float(area), 1, delta=2e-5)

    def test_spline(self):
        self.assertAlmostEqual(self.spray("R2010", "spline")["area"], math.pi * 100, delta=.1)


if __name__ == "__main__":
    unittest.main()
