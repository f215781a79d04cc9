"""`arelem view`: pictures as SVG and PNG."""
import re
import struct
import unittest
import xml.dom.minidom
import zlib

from arelem_run import PROJECT, ArelemCase
from hostile_programs import BROKEN, HOSTILE

EXAMPLES = PROJECT / "examples"


def pixels(path):
    """Width, height and the RGB(A) rows of a PNG of eight bits."""
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", path
    at, raw = 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", body[:10])
        elif kind == b"IDAT":
            raw += body
        at += 12 + size
    assert depth == 8
    step = {2: 3, 6: 4}[color]
    raw, rows, before = zlib.decompress(raw), [], bytearray(width * step)
    for y in range(height):
        line = bytearray(raw[y * (width * step + 1) + 1:(y + 1) * (width * step + 1)])
        how = raw[y * (width * step + 1)]
        for i in range(len(line)):
            left = line[i - step] if i >= step else 0
            up, corner = before[i], before[i - step] if i >= step else 0
            guess = left + up - corner
            nearest = min((abs(guess - v), k, v) for k, v in enumerate((left, up, corner)))[2]
            line[i] = (line[i] + (0, left, up, (left + up) // 2, nearest)[how]) & 255
        rows.append(line)
        before = line
    return width, height, step, rows


class Pictures(ArelemCase):
    def svg(self, name, *options):
        self.assertExit(0, "view", EXAMPLES / name, "-o", "p.svg", *options)
        text = (self.folder / "p.svg").read_text()
        xml.dom.minidom.parseString(text)
        return text

    def test_views(self):
        # A flat path has one view; all three when they are asked for.
        self.assertEqual(re.findall(r">(XY|XZ|YZ)<", self.svg("six_lines.apt")), ["XY"])
        self.assertEqual(re.findall(r">(XY|XZ|YZ)<", self.svg("six_lines.apt", "--view", "all")), ["XY", "XZ", "YZ"])
        self.assertEqual(re.findall(r">(XY|XZ|YZ)<", self.svg("sphere.apt", "--view", "front")), ["XZ"])

    def test_kinds_of_moves(self):
        text = self.svg("profile.apt")
        for part in ('class="rapid"', 'class="feed"', 'class="arc"', 'class="tool"', 'class="scale"', "BOTTOM", "rapid, "):
            self.assertIn(part, text)
        self.assertIn("gun on, ", self.svg("sen_plane.apt"))

    def test_names_do_not_cover_the_path_or_each_other(self):
        text = self.svg("profile.apt")
        plan = text[:text.index(">XZ<")]
        names = {n: (float(x), float(y)) for x, y, n in re.findall(r'<text x="([0-9.]+)" y="([0-9.]+)" class="name">([A-Z0-9]+)<', plan)}
        self.assertEqual(set(names), {"SETPT", "BOTTOM", "TOP", "LEFT1", "RIGHT1", "BULGE", "CORNER"})
        boxes = {n: (x, y - 11, x + 6.6 * len(n), y + 2) for n, (x, y) in names.items()}
        for one, a in boxes.items():
            for other, b in boxes.items():
                if one < other:
                    self.assertFalse(a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3], (one, other))

    def test_arrays_are_named_here_and_there(self):
        self.write("n.apt", "RESERV/P,80\nLOOPST\nI=1\nA)P(I)=POINT/I,I*I/40,0\nI=I+1\nIF(I-80.5)A,A,B\nB)LOOPND\n"
                            "FROM/0,0,0\nGOTO/80,160,0\nFINI\n")
        self.assertExit(0, "view", "n.apt", "-o", "n.svg", "--view", "plan")
        text = (self.folder / "n.svg").read_text()
        at = [(float(x), float(y)) for x, y in re.findall(r'<text x="([0-9.]+)" y="([0-9.]+)" class="name">P\(', text)]
        self.assertTrue(4 <= len(at) <= 20, at)
        self.assertTrue(all(abs(a[0] - b[0]) + abs(a[1] - b[1]) > 40 for a in at for b in at if a < b), at)

    def test_three_views_have_the_path_at_an_angle_beside_them(self):
        self.assertIn("isometric, not to scale", self.svg("sphere.apt"))
        self.assertNotIn("isometric", self.svg("six_lines.apt"))

    def test_a_path_that_is_only_a_start_says_so(self):
        self.write("s.apt", "CUTTER/10\nFROM/1,2,3\nGO/TO,NOPE\nFINI\n")
        self.assertExit(1, "view", "s.apt", "-o", "s.svg")
        text = (self.folder / "s.svg").read_text()
        self.assertIn("no motion could be computed", text)
        self.assertNotIn(">geometry<", text)
        self.assertLess(max(float(r) for r in re.findall(r' r="([0-9.]+)" class="tool"', text)), 100)

    def test_lines_at_fault_at_one_place_share_a_mark(self):
        self.write("f.apt", "FROM/0,0,0\nGOTO/50,0,0\nGOTO/NO1\nGOTO/NO2\nGOTO/0,50,0\nFINI\n")
        self.assertExit(1, "view", "f.apt", "-o", "f.svg")
        self.assertIn(">line 3, 4<", (self.folder / "f.svg").read_text())

    def test_far_from_the_origin_the_extents_tell_the_path(self):
        self.write("f.apt", "FROM/1000000000,0,0\nGOTO/1000000000.01,.01,0\nGOTO/999999999.99,.02,0\nFINI\n")
        self.assertExit(0, "view", "f.apt", "-o", "f.svg")
        self.assertIn("X 999999999.99 to 1000000000.01,", (self.folder / "f.svg").read_text())

    def test_the_part_without_tracut(self):
        self.assertIn("moved by TRACUT", self.svg("school_xing.apt"))
        text = self.svg("school_xing.apt", "--part")
        self.assertNotIn("TRACUT", text)
        self.assertIn("Y 0 to 7320", text)  # XING stands 4880 mm behind the first line, 2440 mm tall

    def test_standard_output(self):
        for how, begin in (([], b"<svg "), (["--to", "svg"], b"<svg "), (["--to", "png"], b"\x89PNG"),
                           (["--to", "html"], b"<!DOCTYPE html>")):
            with open(self.folder / "out", "wb") as out:
                self.assertExit(0, "view", EXAMPLES / "six_lines.apt", "-o", "-", *how, stdout=out)
            self.assertTrue((self.folder / "out").read_bytes().startswith(begin), how)

    def test_revolved_surfaces_are_drawn(self):
        text = self.svg("sen_revolved.apt")
        self.assertNotIn("not drawn", text)
        self.assertIn(">VASE<", text)

    def test_arcs_are_arcs(self):
        arc = self.write("a.cls", "UNITS/MM\nFROM/0,0,0\nGOTO/10,0,0\nCIRCLE/10,10,0,0,0,1,10\nGOTO/20,10,0\n"
                                  "CIRCLE/10,10,0,0,0,1,10\nGOTO/20,10,0\nFINI\n")
        for name in ("view", "compile"):
            self.assertExit(0, name, arc, "-o", "a.svg")
            text = (self.folder / "a.svg").read_text()
            ways = re.findall(r'<path d="M([0-9.]+),([0-9.]+)((?: A[0-9.]+,[0-9.]+ 0 0 0 [0-9.]+,[0-9.]+)+)" class="arc', text)
            self.assertEqual(len(ways), 1, text)
            # A quarter and a whole turn, counterclockwise; the scale comes from the straight move of 10 mm before.
            scale = (float(ways[0][0]) - float(re.search(r'points="([0-9.]+),', text).group(1))) / 10
            radii = re.findall(r"A([0-9.]+),([0-9.]+) ", ways[0][2])
            self.assertTrue(all(abs(float(v) - 10 * scale) < 0.01 for r in radii for v in r), radii)
            self.assertIn("along a circle, 78.5", text)

    def test_every_example_is_a_picture(self):
        for path in sorted(EXAMPLES.glob("*.apt")):
            self.assertExit(0, "view", path, "-o", "e.svg", "-o", "e.png", "--width", "300")
            xml.dom.minidom.parse(str(self.folder / "e.svg"))
            colors = {bytes(row[i:i + 3]) for row in pixels(self.folder / "e.png")[3] for i in range(0, 900, 3)}
            self.assertGreater(len(colors), 20, path.name)

    def test_png(self):
        self.assertExit(0, "view", EXAMPLES / "six_lines.apt", "-o", "p.png", "--width", "400")
        width, height, step, rows = pixels(self.folder / "p.png")
        self.assertEqual(width, 400)
        colors = {bytes(row[i:i + 3]) for row in rows for i in range(0, len(row), step)}
        self.assertGreater(len(colors), 20)
        self.assertTrue(any(b[2] > b[0] + 60 for b in colors), "no blue of the feed")

    def test_broken_empty_and_hostile_programs(self):
        self.write("b.apt", BROKEN)
        self.write("e.apt", "")
        self.write("h.apt", HOSTILE)
        for name, code in (("b", 1), ("e", 1), ("h", 1)):
            self.run_arelem("view", f"{name}.apt", "-o", f"{name}.svg", "-o", f"{name}.png", "-o", f"{name}.html")
            xml.dom.minidom.parse(str(self.folder / f"{name}.svg"))
            self.assertGreater((self.folder / f"{name}.png").stat().st_size, 500)
            self.assertIn("<html", (self.folder / f"{name}.html").read_text(errors="replace"))
        broken = (self.folder / "b.svg").read_text()
        self.assertIn("not all of it: errors in lines 3, 7", broken)
        self.assertRegex(broken, r'class="feed')                        # the moves before and behind
        # GOTO/C1 of line 7 is missing: a cross of two lines where the tool stood, and the way from there is in doubt.
        self.assertEqual(broken.count('class="fault"'), 2)
        self.assertEqual(broken.count('class="doubt"'), 2)              # one of them in the legend
        self.assertIn(">line 7<", broken)
        hostile = (self.folder / "h.svg").read_text()
        self.assertNotIn("<script", hostile)
        self.assertNotIn("\x01", hostile)

    def test_wrong_use(self):
        self.write("p.apt", "FINI\n")
        self.assertExit(2, "view", "p.apt", "-o", "p.gif")
        self.assertIn(".svg, .png or .html", self.err)
        self.assertExit(2, "view", "p.apt")
        self.assertExit(3, "view", "absent.apt", "-o", "p.svg")
        self.assertExit(6, "view", "p.apt", "-o", "no/folder.html")

    def test_the_page_is_deterministic_and_one_file(self):
        for name in ("a.html", "b.html"):
            self.assertExit(0, "view", EXAMPLES / "profile.apt", "-o", name)
        self.assertEqual((self.folder / "a.html").read_bytes(), (self.folder / "b.html").read_bytes())


if __name__ == "__main__":
    unittest.main()
