"""`arelem view`: pictures, and the page in headless Chromium."""
import json
import os
import pathlib
import re
import shutil
import struct
import subprocess
import unittest
import xml.dom.minidom
import zlib

from arelem_run import ARELEM, PROJECT, ArelemCase

MODULES = pathlib.Path(ARELEM).parent / "viewer" / "node_modules"
CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
EXAMPLES = PROJECT / "examples"
HOSTILE = ("PARTNO <script>window.hacked=1</script></title><img src=x onerror='window.hacked=1'> \x01 \u202e\n"
           "P1=POINT/1,2\nFROM/P1\nGOTO/</script><b>,2\nGOTO/5,6,7\nFINI\n")
BROKEN = "UNITS/MM\nP1=POINT/1,1\nC1=CIRCLE/QQ,1,1\nCUTTER/2\nFROM/P1\nGOTO/20,1\nGOTO/C1\nGOTO/20,20\nFINI\n"


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
        self.assertIn("C1", (self.folder / "b.apt").read_text())

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


@unittest.skipUnless(CHROMIUM and MODULES.is_dir(), "no chromium here")
class Page(ArelemCase):
    def look(self, *tasks):
        listed = []
        for task in tasks:
            source = task.pop("source")
            path = source if isinstance(source, pathlib.Path) else self.write(f"p{len(listed)}.apt", source)
            page = self.folder / f"page{len(listed)}.html"
            self.run_arelem("view", path, "-o", page, timeout=300)
            self.assertTrue(page.exists(), self.err)
            listed.append({**task, "page": str(page)})
        self.write("tasks.json", json.dumps(listed))
        done = subprocess.run(["node", PROJECT / "viewer/test/look.mjs", CHROMIUM, MODULES, self.folder / "tasks.json"],
                              capture_output=True, text=True, timeout=900)
        self.assertEqual(done.returncode, 0, done.stderr)
        told = json.loads(done.stdout)
        for one in told:
            self.assertEqual(one["problems"], [])
            self.assertEqual(one["requests"], [])
            self.assertEqual(one["scripts"], 0)
        return told

    def near(self, told, red, green, blue):
        """Pixels of about this color."""
        want = (red >> 4, green >> 4, blue >> 4)
        return sum(n for key, n in told["colors"].items() if all(abs(int(c, 16) - w) <= 2 for c, w in zip(key, want)))

    def test_pages(self):
        profile = (EXAMPLES / "profile.apt").read_text().splitlines()
        fwd = profile.index("GOFWD/TOP,PAST,LEFT1") + 1
        many = "".join(f"GOTO/{i % 500},{(i // 500) % 2 * .1 + i // 500},{i % 7 * 1e-4}\n" for i in range(100_000))
        state = "({title: document.title, rows: document.querySelectorAll('.row').length, hacked: window.hacked, " \
                "messages: [...document.querySelectorAll('.message')].map(m => m.textContent)})"
        run_of_top = f"window.arelem.scene.first[[...window.arelem.scene.line].indexOf({fwd})]"
        good, hostile, broken, empty, large, film = self.look(
            {"source": EXAMPLES / "profile.apt", "rows": [fwd],
             "run": [run_of_top, "window.arelem.color('deviation')", "window.arelem.color('kind')",
                     "window.arelem.setTime(window.arelem.scene.total)", "window.arelem.scene.meshes.length",
                     "[...window.arelem.scene.inner].filter(v => !Number.isNaN(v)).length", "window.arelem.choose(-1)"]},
            {"source": HOSTILE, "run": [state]}, {"source": BROKEN, "run": [state]}, {"source": "", "run": [state]},
            {"source": "CUTTER/1\nFROM/0,0,0\nFEDRAT/1000\n" + many + "FINI\n",
             "run": ["window.arelem.levels()", "document.querySelectorAll('.row').length"]},
            {"source": EXAMPLES / "sen_plane.apt", "run": ["window.arelem.scene.films.length", "window.arelem.stage.look('plan')"]})
        end_of_top = good["run"][0]
        self.assertGreater(end_of_top, 0)
        self.assertGreater(self.near(good, 0x1f, 0x5f, 0xbf), 150, "no feed blue")
        self.assertGreater(self.near(good, 0xd1, 0x24, 0x2f), 40, "no rapid red")
        self.assertGreater(self.near(good, 0x0a, 0x8f, 0x6c), 40, "no arc green")
        self.assertGreater(good["run"][4], 4)   # surfaces
        self.assertGreater(good["run"][5], 5)   # proven motions
        self.assertGreaterEqual(good["rows"][0]["chosen"], 0)
        self.assertIsNone(hostile["run"][0].get("hacked"))
        self.assertEqual(hostile["images"], 0)
        self.assertTrue(broken["run"][0]["messages"][0].startswith("E0201, line 3"), broken["run"][0])
        self.assertEqual(empty["run"][0]["rows"] <= 1, True)
        levels, rows = large["run"]
        self.assertEqual(levels[0], 100_001)
        self.assertLess(levels[-1], 30_000)     # levels of detail leave most of it out
        self.assertLess(rows, 200)              # and only lines in sight are in the page
        self.assertEqual(film["run"][0], 1)
        green = sum(n for key, n in film["colors"].items() if key[1] in "def" and key[0] < "c" and key[2] < "c")
        self.assertGreater(green, 2000, "no film of the right thickness")

    def test_click_on_a_move_marks_its_line(self):
        profile = (EXAMPLES / "profile.apt").read_text().splitlines()
        self.assertExit(0, EXAMPLES / "profile.apt", "--to", "json")
        # The location at the end of GOFWD/TOP is found by its statement in the CL records, not by the page.
        locations, isn = [], profile.index("GOFWD/TOP,PAST,LEFT1") + 1
        for line in self.out.splitlines():
            record = json.loads(line)
            for _ in record.get("points", []):
                locations.append(record["isn"])
        self.assertIn(isn, locations)
        told, = self.look({"source": EXAMPLES / "profile.apt", "clicks": [locations.index(isn)]})
        self.assertEqual(told["clicks"][0]["marked"]["line"], isn)
        self.assertIn("GOFWD/TOP,PAST,LEFT1", told["clicks"][0]["marked"]["text"])
        self.assertIn(f"line {isn} ", told["clicks"][0]["readout"])


if __name__ == "__main__":
    unittest.main()
