"""`arelem view`: the page in headless Chromium."""
import json
import pathlib
import re
import shutil
import subprocess
import unittest

from arelem_run import ARELEM, PROJECT, ArelemCase
from hostile_programs import BROKEN, HOSTILE

MODULES = pathlib.Path(ARELEM).parent / "viewer" / "node_modules"
CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
EXAMPLES = PROJECT / "examples"


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
            {"source": HOSTILE, "run": [state]},
            {"source": BROKEN, "run": [state, "[...document.querySelectorAll('.row.bad')].map(r => Number(r.dataset.line))",
                                       "window.arelem.scene.count", "document.querySelector('#labels .wrong').textContent"]}, {"source": "", "run": [state]},
            {"source": "CUTTER/1\nFROM/0,0,0\nFEDRAT/1000\n" + many + "FINI\n",
             "run": ["window.arelem.levels()", "document.querySelectorAll('.row').length", "window.arelem.stage.path.drawn"],
             # Close to the path all of its moves are drawn, those in sight.
             "steps": [{"get": "const c = window.arelem.stage; c.camera.zoom = 60; c.camera.updateProjectionMatrix(); c.moved()"},
                       {"until": "window.arelem.stage.path.key === '0/1' && !window.arelem.stage.moving"},
                       {"get": "window.arelem.stage.path.drawn"}]},
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
        self.assertEqual(broken["run"][1], [3, 7])
        self.assertGreaterEqual(broken["run"][2], 2)        # what can be computed is there
        self.assertIn("line 7", broken["run"][3])           # a mark where the motion is missing
        self.assertEqual(empty["run"][0]["rows"] <= 1, True)
        levels, rows, drawn = large["run"]
        self.assertEqual(levels[0], 100_001)
        self.assertLess(levels[-1], 30_000)     # levels of detail leave most of it out
        self.assertLess(drawn, 50_000)
        self.assertGreater(large["steps"][2], 100)
        self.assertLess(large["steps"][2], 60_000)
        self.assertLess(rows, 200)              # and only lines in sight are in the page
        self.assertEqual(film["run"][0], 1)
        green = sum(n for key, n in film["colors"].items() if key[1] in "def" and key[0] < "c" and key[2] < "c")
        self.assertGreater(green, 2000, "no film of the right thickness")

    def steps(self, source, *steps):
        told, = self.look({"source": source, "steps": list(steps)})
        return told["steps"]

    def test_keyboard(self):
        # FROM stands on line 16 of the program, the first motion; GO on line 18.
        line = "document.querySelector('.row.marked')?.dataset.line"
        look = "(c => [c.x, c.y, c.z].map(v => Math.round(100 * v)))(window.arelem.stage.camera.getWorldDirection(" \
               "window.arelem.stage.camera.position.clone()))"
        told = self.steps(
            EXAMPLES / "profile.apt",
            {"key": "Home", "get": "window.arelem.state.time"}, {"key": "ArrowRight", "get": line},
            {"key": "ArrowRight", "get": line}, {"key": "ArrowLeft", "get": line},
            {"key": "End", "get": "window.arelem.state.time === window.arelem.scene.total"},
            {"key": "1", "get": look}, {"key": "2", "get": look}, {"key": "3", "get": look},
            {"key": "c", "get": "document.getElementById('coloring').value"},
            {"key": "?", "get": "document.getElementById('keys').open && document.getElementById('keys').textContent"},
            {"key": "Escape", "get": "document.getElementById('keys').open"},
            {"key": "d", "get": "document.documentElement.className"}, {"key": "d", "get": "document.documentElement.className"})
        self.assertEqual(told[:5], [0, "16", "18", "16", True])
        self.assertEqual(told[5:8], [[0, 0, -100], [0, 100, 0], [-100, 0, 0]])
        self.assertEqual(told[8], "speed")
        self.assertIn("next statement", told[9])
        self.assertEqual(told[10:], [False, "dark", ""])

    def test_every_line_of_a_long_source_can_be_reached(self):
        # More lines than a page may be high: rows share the height.
        marked = "document.querySelector('.row.marked')?.textContent"
        told = self.steps("FROM/0,0,0\n" + "\n" * 460_000 + "GOTO/1,0,0\n" + "\n" * 9 + "FINI\n", {"key": "ArrowRight", "get": marked},
                          {"key": "ArrowRight", "get": marked}, {"key": "ArrowLeft", "get": marked},
                          {"get": "document.getElementById('source').scrollTop = 1e9"}, {"get": "new Promise(requestAnimationFrame)"},
                          {"get": "[...document.querySelectorAll('.row')].pop().textContent"})
        self.assertEqual(told[:3], ["1FROM/0,0,0", "460002GOTO/1,0,0", "1FROM/0,0,0"])
        self.assertEqual(told[5], "460013")  # behind the last line end

    def test_play_follows_the_time_law(self):
        self.assertExit(0, "time", EXAMPLES / "profile.apt")
        seconds = float(re.search(r"total ([0-9.]+) s", self.out).group(1))
        state = "({t: window.arelem.state.time, all: window.arelem.scene.total, playing: window.arelem.state.playing, " \
                "tool: window.arelem.stage.tool.group.position.toArray().map((v, a) => v + window.arelem.stage.center[a])})"
        # GOFWD/BOTTOM runs at 400 mm/min along y = -6: a second in the middle of it is 6.667 mm.
        middle = "(s => { const k = [...s.line].indexOf(19), a = s.time[s.first[k] - 1], b = s.time[s.first[k + 1] - 1];" \
                 " window.arelem.setTime((a + b) / 2 + %s); return 0; })(window.arelem.scene)"
        told = self.steps(
            EXAMPLES / "profile.apt", {"get": middle % "-.5"}, {"get": state}, {"get": middle % ".5"}, {"get": state},
            {"key": "Home"}, {"press": "#play"}, {"until": "window.arelem.state.time > 0.3"}, {"get": state}, {"press": "#play"},
            {"get": state}, {"get": "document.getElementById('clock').textContent"}, {"get": state})
        before, after = told[1], told[3]
        self.assertAlmostEqual(before["all"], seconds, delta=0.02)
        self.assertAlmostEqual(after["tool"][0] - before["tool"][0], 400 / 60, delta=1e-3)
        self.assertAlmostEqual(after["tool"][1], -6, delta=1e-3)
        self.assertTrue(told[7]["playing"])
        self.assertFalse(told[9]["playing"])
        self.assertEqual(told[9]["t"], told[11]["t"])
        self.assertRegex(told[10], r"^\d+\.\d\d s of ")

    def test_measuring(self):
        # GOFWD/BOTTOM goes along y = -6 from x = -6 to x = 106: half of it is 56 mm.
        first = "[...window.arelem.scene.line].indexOf(19)"
        where = f"window.arelem.scene.first[{first}]"
        readout = "document.getElementById('readout').textContent"
        index, = self.steps(EXAMPLES / "profile.apt", {"get": where})
        told = self.steps(EXAMPLES / "profile.apt", {"key": "1"}, {"press": "#measure", "get": readout},
                          {"on": [index, 0.5], "get": readout}, {"on": [index, 1.0], "get": readout},
                          {"get": "window.arelem.stage.marks.children.length"}, {"key": "m", "get": readout})
        self.assertIn("first place", told[1])
        self.assertIn("second place", told[2])
        distance = float(re.search(r"distance ([0-9.]+) mm", told[3]).group(1))
        self.assertAlmostEqual(distance, 56, delta=0.6)  # a pixel is half a millimeter
        self.assertIn("dy 0 ", told[3])
        self.assertEqual(told[4], 3)
        self.assertEqual(told[5], "")

    def test_what_is_told_of_a_move(self):
        # GOFWD/BOTTOM goes along y = -6 from x = -6 to x = 106; it and GOLFT/RIGHT1, which runs into an arc, are straight.
        readout = "document.getElementById('readout').textContent"
        end = "(line => { const s = window.arelem.scene, k = [...s.line].indexOf(line); return s.first[k + 1] - 1; })"
        bottom, right = self.steps(EXAMPLES / "profile.apt", {"get": end + "(19)"}, {"get": end + "(20)"})
        told = self.steps(EXAMPLES / "profile.apt", {"key": "1"}, {"on": [bottom, 0.25], "get": readout},
                          {"on": [right, 0.5], "get": readout}, {"press": '.row[data-line="2"]', "get": readout})
        place = re.search(r"at \(([-0-9.]+), -6, -5\) mm\nmove ends at \(106, -6, -5\)", told[1])
        self.assertTrue(place, told[1])
        self.assertAlmostEqual(float(place.group(1)), -6 + 112 / 4, delta=0.6)
        for text in told[1:3]:
            self.assertRegex(text, r"curvature 0\n")
        self.assertEqual(told[3], "line 2: no motion")

    def test_without_a_feed_the_way_is_told(self):
        self.write("u.apt", "UNITS/MM\nFROM/0,0,0\nGOTO/30,40,0\nGOTO/30,40,10\nFINI\n")
        clock, told = self.steps(self.folder / "u.apt", {"get": "document.getElementById('clock').textContent"},
                                 {"on": [1, 0.5], "get": "document.getElementById('readout').textContent"})
        self.assertEqual(clock, "60 mm of 60 mm")
        self.assertIn("50 mm along the path", told)
        self.assertNotIn(" s ", told)

    def test_planes_are_shown_where_the_path_is(self):
        # The path runs along y = 0 from x = 0 to 100; the plane z = 0 is shown as a strip beside it, not as the whole box.
        self.write("s.apt", "CUTTER/2\nINTOL/.01\nOUTTOL/.01\nL1=LINE/0,-1,1,-1\nL2=LINE/100,0,100,1\nPL1=PLANE/0,0,1,0\n"
                            "FROM/0,0,60\nGOTO/0,0,0\nPSIS/PL1\nINDIRV/1,0,0\nTLLFT,GOFWD/L1,ON,L2\nGOTO/100,80,60\nFINI\n")
        told = self.steps(self.folder / "s.apt", {"get":
            "(m => { const p = m.geometry.attributes.position, y = []; for (let k = 0; k < p.count; ++k) "
            "y.push(p.getY(k) + window.arelem.stage.center[1]); return [p.count, Math.min(...y), Math.max(...y)]; })"
            "(window.arelem.stage.layers.surfaces.children.find(m => m.isMesh && m.name === 'PL1'))"})[0]
        self.assertEqual(told[0], 4)
        self.assertGreater(told[1], -12)
        self.assertLess(told[2], 12)

    def test_errors_come_first_with_numbers_that_mean_something(self):
        self.write("m.apt", "CLPRNT\nUNITS/MM\nFROM/0,0,0\nGOTO/NOPE\nGOTO/10,0,0\nGOTO/NOPE2\nGOTO/NOPE3\nFINI\n")
        told = self.steps(self.folder / "m.apt", {"get": "[...document.querySelectorAll('.message')].map(m => m.className)"},
                          {"get": "document.getElementById('messageHead').textContent"})
        self.assertEqual(told[0], sorted(told[0]), told)  # "message error" before "message warning"
        self.assertIn("3 errors, 1 warning", told[1])

    def test_holes_are_drilled(self):
        # Over the hole at the height of 50, down to the clearance of 2, at 30 mm/min to -30, up again; then over to the next.
        path = self.write("h.apt", "UNITS/MM\nCUTTER/5\nSPINDL/1000,RPM\nFEDRAT/60\nFROM/0,0,50\nRAPID\nCYCLE/DRILL,30,30,MMPM,2\n"
                                   "GOTO/10,0,0\nGOTO/20,0,0\nCYCLE/OFF\nGOTO/0,0,50\nFINI\n")
        self.assertExit(0, "time", path)
        seconds = float(re.search(r"total ([0-9.]+) s", self.out).group(1))
        total, places, kinds, line = self.steps(
            path, {"get": "window.arelem.scene.total"}, {"get": "[...window.arelem.scene.places]"},
            {"get": "[...window.arelem.scene.kinds]"}, {"get": "[...window.arelem.scene.line]"})
        self.assertAlmostEqual(total, seconds, delta=0.02)
        self.assertGreater(total, 2 * 32 / 30 * 60)
        visited = [tuple(places[3 * i:3 * i + 3]) for i in range(len(kinds))]
        self.assertEqual(visited[:5], [(0, 0, 50), (10, 0, 50), (10, 0, 2), (10, 0, -30), (10, 0, 2)])
        self.assertEqual(kinds[:5], [0, 1, 1, 2, 1])
        self.assertIn((20, 0, -30), visited)
        self.assertEqual(visited[-1], (0, 0, 50))
        self.assertEqual(line, [5, 8, 9, 11])

    def test_section_and_layers(self):
        shown = {"colors": True}
        told = self.steps(EXAMPLES / "profile.apt", {"key": "1"}, {"press": "#layers label:nth-child(2) input"}, shown, {"key": "x"},
                          {"get": "document.getElementById('cutAxis').value = 'x', "
                                  "document.getElementById('cutAxis').dispatchEvent(new Event('input')), "
                                  "document.getElementById('cutValue').textContent"},
                          shown, {"key": "]", "get": "document.getElementById('cutValue').textContent"}, {"key": "x"}, shown,
                          {"press": "#layers label:nth-child(1) input"}, shown)
        blue = [self.near({"colors": told[i]}, 0x1f, 0x5f, 0xbf) for i in (2, 5, 8, 10)]
        self.assertGreater(blue[0], 300)
        self.assertLess(blue[1], 0.7 * blue[0])   # x runs from -40 to 106: the plane at 33 leaves the left
        self.assertGreater(blue[1], 0.2 * blue[0])
        self.assertAlmostEqual(blue[2], blue[0], delta=0.02 * blue[0])
        self.assertLess(blue[3], 0.1 * blue[0])
        self.assertEqual(told[4], "33 mm")
        self.assertEqual(told[6], "36.65 mm")     # a fortieth of 146 mm on

    def test_dark_and_light(self):
        told = self.steps(EXAMPLES / "profile.apt", {"colors": True}, {"charts": True}, {"press": "#theme"}, {"colors": True},
                          {"charts": True}, {"get": "getComputedStyle(document.body).backgroundColor"})
        dark = lambda colors: sum(n for key, n in colors.items() if key in ("111", "112", "211", "122"))
        self.assertEqual(dark(told[0]), 0)
        self.assertGreater(dark(told[3]), 50_000)
        self.assertEqual(told[5], "rgb(20, 24, 29)")
        self.assertGreater(self.near({"colors": told[3]}, 0x6c, 0xb2, 0xff), 150, "no path in the dark")
        for charts in (told[1], told[4]):
            self.assertGreater(len(charts), 15)

    def test_charts(self):
        told = self.steps(
            EXAMPLES / "profile.apt", {"charts": True}, {"chart": 0.5, "get": "window.arelem.state.time / window.arelem.scene.total"},
            {"get": "document.querySelector('.row.marked').dataset.line"},
            {"get": "[...window.arelem.scene.curvature].map((v, i) => [window.arelem.scene.line[window.arelem.scene.stretchOf[i]], v])"})
        charts = {"colors": told[0]}
        self.assertGreater(self.near(charts, 0x1f, 0x5f, 0xbf), 300, "no speed")
        self.assertGreater(self.near(charts, 0x0a, 0x8f, 0x6c), 100, "no curvature")
        self.assertGreater(self.near(charts, 0xb5, 0x17, 0x9e), 300, "no deviation")
        self.assertGreater(self.near(charts, 0xc2, 0x41, 0x0c), 100, "no programmed feed")
        self.assertAlmostEqual(told[1], 0.47, delta=0.02)  # the charts begin 66 pixels in
        self.assertIsNotNone(told[2])
        # CORNER has a radius of 18: the tool end goes round at 24, and straight along TOP and BOTTOM.
        at = {}
        for line, value in told[3]:
            at.setdefault(line, []).append(value)
        corner = sorted(at[21])
        self.assertAlmostEqual(corner[len(corner) // 2], 1 / 24, delta=0.001)
        self.assertAlmostEqual(corner[-1], 1 / 24, delta=0.004)
        self.assertLess(max(at[19]), 0.002)

    def test_deviations_are_those_of_verify(self):
        self.assertExit(0, "verify", EXAMPLES / "profile.apt", "--json")
        rows = [json.loads(line) for line in self.out.splitlines()]
        told = self.steps(EXAMPLES / "profile.apt", {"get": "[...window.arelem.scene.line].map((n, k) => [n, window.arelem.scene.inner[k],"
                                                            " window.arelem.scene.outer[k]]).filter(r => !Number.isNaN(r[1]))"})[0]
        proven = {}
        for row in rows:
            for name in ("drive", "part"):
                if row.get(name):
                    proven.setdefault(row["line"], []).append(row[name])
        self.assertGreater(len(told), 5)
        for line, inner, outer in told:
            self.assertIn(line, proven)
            self.assertAlmostEqual(inner, min(p["inner"] for p in proven[line]), delta=1e-6)
            self.assertAlmostEqual(outer, max(p["outer"] for p in proven[line]), delta=1e-6)

    def test_films(self):
        readout = "document.getElementById('readout').textContent"
        plane = self.steps(EXAMPLES / "plate_paint.apt", {"key": "1"}, {"at": [0.5, 0.53], "get": readout})[1]
        value, wanted = re.search(r"film ([0-9.]+) \S+m, wanted ([0-9.]+)", plane).groups()
        self.assertEqual(float(wanted), 51)
        self.assertAlmostEqual(float(value), 51, delta=20)
        self.assertIn("PLATE", plane)
        stencil, colors = self.steps(EXAMPLES / "stop.apt", {"key": "1", "get": "document.getElementById('legend').textContent"},
                                     {"colors": True})
        self.assertIn("of its mean", stencil)
        green = sum(n for key, n in colors.items() if key[1] in "def" and key[0] < "c" and key[2] < "c")
        self.assertGreater(green, 2000, "no film of the letters")

    def test_films_lie_where_the_path_paints(self):
        # The truck drives 5000 mm: the second word is computed 5000 further on, and painted where the first one is.
        words = "UNITS/MM\nA=POINT/0,0\nB=POINT/0,5000\nSTENCL/'I',HEIGHT,2440,FAN,63.5,SPEED,600,ORIGIN,A,TILT,BEST\n" \
                "TRACUT/(MATRIX/TRANSL,0,-5000,0)\nSTENCL/'I',HEIGHT,2440,FAN,63.5,SPEED,600,ORIGIN,B,TILT,BEST\n" \
                "TRACUT/NOMORE\nFINI\n"
        system = "UNITS/MM\nM=MATRIX/TRANSL,700,0,0\nREFSYS/M\nSTENCL/'I',HEIGHT,2440,FAN,63.5,SPEED,600,TILT,BEST\n" \
                 "REFSYS/NOMORE\nFINI\n"
        low = "window.arelem.scene.films.map(f => [0, 1].map(a => Math.min(...f.corners.filter((v, i) => i % 3 === a))))"
        moved, within = self.look({"source": words, "steps": [{"get": low}]}, {"source": system, "steps": [{"get": low}]})
        first, second = moved["steps"][0]
        third, = within["steps"][0]
        for axis in (0, 1):
            self.assertAlmostEqual(first[axis], second[axis], delta=0.01)
            self.assertAlmostEqual(third[axis] - first[axis], (700, 0)[axis], delta=0.01)

    def test_arcs_and_tilted_tools(self):
        arc = ("UNITS/MM\nFEDRAT/100,MMPM\nFROM/0,0,0\nGOTO/10,0,0\nCIRCLE/10,10,0,0,0,1,10\nGOTO/20,10,0\nGOTO/40,10,0\nFINI\n")
        cone = (PROJECT / "tests/golden/motion/axis_along_the_lines_of_a_cone.apt").read_text()
        round_, tilted = self.look(
            {"source": arc, "steps": [{"get": "[...window.arelem.scene.kinds].filter(k => k === 3).length"},
                                      {"get": "window.arelem.scene.way[window.arelem.scene.count - 1]"}, {"colors": True}]},
            {"source": cone, "steps": [{"get": "window.arelem.setTime(window.arelem.scene.total), "
                                               "window.arelem.stage.camera.position.clone().set(0, 0, 1).applyQuaternion("
                                               "window.arelem.stage.tool.group.quaternion).toArray()"}]})
        self.assertGreater(round_["steps"][0], 20)
        self.assertAlmostEqual(round_["steps"][1], 10 + 15.70796 + 20, delta=0.01)  # a quarter of a circle of 10
        self.assertGreater(self.near({"colors": round_["steps"][2]}, 0x0a, 0x8f, 0x6c), 300)
        axis = tilted["steps"][0]  # at the end the axis leans 30 degrees: sin and cos
        self.assertAlmostEqual(axis[0], 0.5, delta=1e-3)
        self.assertAlmostEqual(axis[2], 0.866, delta=1e-3)

    def test_the_way_over_a_missing_motion_is_not_counted(self):
        # 10 to P1 and 5 at the end; between them 40 that no statement asks for. At 60 mm/min a second is a millimeter.
        text = "UNITS/MM\nFEDRAT/60,MMPM\nFROM/0,0,0\nGOTO/10,0,0\nGOTO/NOPE\nGOTO/10,40,0\nGOTO/15,40,0\nFINI\n"
        told, = self.look({"source": text, "steps": [
            {"get": "window.arelem.scene.way[window.arelem.scene.count - 1]"}, {"get": "window.arelem.scene.total"},
            {"get": "window.arelem.scene.faults.map(f => f.line)"}]})
        way, total, lines = told["steps"]
        self.assertAlmostEqual(way, 15, delta=1e-6)
        self.assertAlmostEqual(total, 15, delta=0.1)  # and what the machine needs to speed up
        self.assertEqual(lines, [5])

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
