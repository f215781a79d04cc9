"""`arelem verify PART [CL]`: proves every cut vector of a path, refutes paths that were tampered with, and finds where
the old system leaves its own tolerance."""
import json
import math
import os
import pathlib
import re
import subprocess
import unittest

from arelem_run import ARELEM, PROJECT, ArelemCase

CASES = PROJECT / "tests" / "data" / "oracle" / "cases"
# Paths of the old system that leave their tolerance, by its design: chords use the whole band but their ends lie a
# tenth of it too low, and contacts that jump from one side of the cutter to the other are not seen.
# docs/differences-motion.md gives the figures.
OLD_SYSTEM_VIOLATES = {
    "c14_ellipse_ds", "c15_hyperb_gconic", "d01_sphere_ball", "d02_sphere_flat", "d03_sphere_bull", "d04_sphere_taper",
    "d05_cyl_ball", "d07_cyl_bull", "d08_cyl_taper", "d09_cylx_ball", "d10_cylx_flat", "d12_cylx_taper", "d13_cone_ball",
    "d14_cone_flat", "d16_cone_taper", "d23_quadric_bull", "d24_quadric_taper", "d26_tabcyl_flat", "d28_tabcyl_taper",
    "d44_ds_sphere", "d45_ds_quadric", "d46_ds_tabcyl_ps_sphere", "d52_sph_tol2", "d53_sph_tol3", "d54_sph_tol4",
    "d60_concave_sphere", "d61_rldsrf", "e15_tlaxis_atangl", "e19_toler_2dcalc", "e20_gougck", "e27_tlaxis_4axis",
    "e34_pstan",
}

SPHERE = """PARTNO SPHERE
INTOL/0.001
OUTTOL/0.001
CUTTER/2,1
S1=SPHERE/0,0,0,9
L1=LINE/0,0,1,0
L2=LINE/-6,-9,-6,9
L3=LINE/6,-9,6,9
FROM/-8,0,9
GO/ON,L1,TO,S1,ON,L2
INDIRV/1,0,0
TLON,GOFWD/L1,ON,L3
GOTO/8,0,9
FINI
"""
POCKET = """PARTNO POCKET
CUTTER/0.5
OUTTOL/0.001
L1=LINE/0,0,5,0
L2=LINE/5,0,5,4
C1=CIRCLE/3,4,2
L3=LINE/0,6,3,6
L4=LINE/0,0,0,6
FROM/1,2,1
GO/TO,L1
TLLFT,GOLFT/L1,TO,L2
GOLFT/L2,TANTO,C1
GOFWD/C1,TANTO,L3
GOFWD/L3,TO,L4
GOLFT/L4,TO,L1
FINI
"""


def programs():
    for path in sorted(CASES.glob("*.apt")):
        if re.search(r"\bGO", path.read_text()):
            yield path.stem, path


class Certify(ArelemCase):
    def rows(self, *words):
        code = self.run_arelem("verify", *words, "--json")
        return code, [json.loads(line) for line in self.out.splitlines()]

    def records(self, text=SPHERE, name="s.apt", output="s.jsonl"):
        self.write(name, text)
        self.assertExit(0, name, "-o", output)
        return [json.loads(line) for line in (self.folder / output).read_text().splitlines()]

    def store(self, records, name="s.jsonl"):
        self.write(name, "".join(json.dumps(r) + "\n" for r in records))

    def test_our_paths_are_proven(self):
        for name, path in programs():
            with self.subTest(name):
                self.assertExit(0, "verify", path)

    def test_every_format_is_read_back_and_proven(self):
        for name in ("d03_sphere_bull", "e05_copy_transl", "e23_transl_tracut_copy", "e30_tracut_multax", "c18_implied_check"):
            with self.subTest(name):
                source = CASES / (name + ".apt")
                self.assertExit(0, source, "-o", "p.jsonl", "-o", "p.cltape")
                self.assertExit(0, "verify", source, "p.jsonl")
                self.assertExit(0, "verify", source, "p.cltape")

    def test_cl_text_without_statement_numbers_is_associated_by_its_stops(self):
        for name in ("d03_sphere_bull", "c03_inside_to", "c18_implied_check", "d26_tabcyl_flat"):
            with self.subTest(name):
                source = CASES / (name + ".apt")
                self.assertExit(0, source, "-o", "p.cls")
                self.assertExit(0, "verify", source, "p.cls")

    def test_paths_of_the_old_system(self):
        for name, path in programs():
            with self.subTest(name):
                code, rows = self.rows(path, path.with_suffix(".json"))
                self.assertEqual(code, 5 if name in OLD_SYSTEM_VIOLATES else 0, self.err)
                self.assertTrue(rows or name.startswith("g"))  # g: geometry only

    def test_paths_of_the_old_system_as_plain_text(self):
        """What any other system may write: locations only, nine decimals, no statement numbers."""
        for name, path in programs():
            records = json.loads(path.with_suffix(".json").read_text())["cl"]
            lines = [f"{'FROM' if r['kind'] == 'FROM' else 'GOTO'} / " + ", ".join(f"{x:.9f}" for x in point)
                     for r in records if r["type"] == 5000 for point in r["points"]]
            if not lines:
                continue
            with self.subTest(name):
                self.write("old.cls", "\n".join(["PARTNO OLD", *lines, "FINI", ""]))
                code, rows = self.rows(path, "old.cls")
                self.assertEqual(code, 5 if name in OLD_SYSTEM_VIOLATES else 0, self.err)
                self.assertTrue(rows)

    def test_old_ball_on_sphere_is_a_tenth_of_the_band_too_deep(self):
        case = CASES / "d01_sphere_ball.apt"
        code, rows = self.rows(case, case.with_suffix(".json"))
        self.assertEqual(code, 5)
        part = next(r["part"] for r in rows if r["statement"] == "GOFWD")
        self.assertEqual((part["innerIs"], part["outerIs"]), ("violated", "proven"))
        self.assertAlmostEqual(part["measuredInner"], -0.0002, delta=1e-5)  # OUTTOL .002, INTOL 0
        self.assertLess(part["measuredOuter"], 0.0019)

    def test_first_cut_vector_of_the_old_e27_leaves_the_sphere(self):
        """It turns the axis in place by 0.45 radians, and with it the center of the ball, 0.25 above the tool end: measured here
        from the old system's locations alone. Two cut vectors turn it within the tolerance: the one that arelem has more."""
        case = CASES / "e27_tlaxis_4axis.apt"
        center, radius, ball, band = (0.25, 0.35, -6.5), 8.25, 0.25, 0.002

        def gaps(a, b):
            angle = math.acos(min(1.0, sum(x * y for x, y in zip(a[3:], b[3:]))))
            for k in range(1001):
                s = k / 1000
                share = [math.sin((1 - s) * angle), math.sin(s * angle)] if angle > 1e-9 else [1 - s, s]
                axis = [share[0] * x + share[1] * y for x, y in zip(a[3:], b[3:])]
                length = math.hypot(*axis)
                place = [x + s * (y - x) + ball * n / length for x, y, n in zip(a, b, axis)]
                yield math.dist(place, center) - radius - ball

        points = [p for r in json.loads(case.with_suffix(".json").read_text())["cl"] if r["type"] == 5000 for p in r["points"]]
        first, second = points[1], points[2]
        farthest = max(gaps(first, second))
        self.assertAlmostEqual(farthest, 0.00799, delta=1e-5)
        self.assertGreater(farthest, 3.9 * band)
        code, rows = self.rows(case, case.with_suffix(".json"))
        self.assertEqual(code, 5)
        self.assertIn(f"{farthest:.6f} off `PS1`", self.err)
        self.assertIn("on cut vector 1 of this motion", self.err)
        self.assertExit(0, case, "-o", "ours.jsonl")
        ours = [p for line in (self.folder / "ours.jsonl").read_text().splitlines()
                for p in json.loads(line).get("points", []) if len(p) == 6]
        self.assertEqual(len(ours), len(points) + 1)
        for a, b in zip(ours[1:], ours[2:-1]):  # FROM and the last GOTO are along no surface
            self.assertLess(max(abs(g) for g in gaps(a, b)), band * (1 + 1e-6))

    def test_figures_of_a_sphere_are_those_of_a_pencil(self):
        records = self.records()
        code, rows = self.rows("s.apt", "s.jsonl")
        self.assertEqual(code, 0, self.err)
        figures = next(r["part"] for r in rows if r["statement"] == "GOFWD")
        path = [p for r in records if r["kind"] in ("GOTO", "CONT") and r["isn"] in (10, 12) for p in r["points"]]
        deepest = min(math.hypot(0.5 * (p[0] + q[0]), 0.5 * (p[2] + q[2]) + 1.0) - 10.0 for p, q in zip(path, path[1:]))
        self.assertAlmostEqual(figures["measuredInner"], deepest, delta=2e-5)
        self.assertLessEqual(figures["inner"], deepest + 1e-12)
        self.assertGreaterEqual(figures["outer"], max(math.hypot(p[0], p[2] + 1.0) - 10.0 for p in path) - 1e-12)

    def test_memory_does_not_grow_with_the_cut_vectors(self):
        """20 and 400 half turns about a cylinder, some 57 000 and 1 150 000 cut vectors; one takes 48 bytes to keep."""
        program = "PARTNO MANY\n3DCALC\nNUMPTS/9999999\nOUTTOL/.0000005\nCUTTER/1\nDS1=CYLNDR/0,0,0,0,0,1,3\nPS1=PLANE/0,0,1,0\n" \
                  "X0=PLANE/1,0,0,0\nY0=PLANE/0,1,0,0\nFROM/0,-9,0\nINDIRV/0,1,0\nGO/TO,DS1,TO,PS1,ON,X0\n" \
                  "TLRGT,GORGT/DS1,ON,{},INTOF,Y0\nFINI\n"
        peaks = []
        for turns in (20, 400):
            self.write("many.apt", program.format(turns))
            run = subprocess.Popen([ARELEM, "verify", self.folder / "many.apt", "--max-points", "9999999"],
                                   stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
            self.assertGreater(int(run.stdout.read().split(b"GORGT")[1].split()[0]), 2800 * turns)
            _, status, usage = os.wait4(run.pid, 0)
            run.returncode = os.waitstatus_to_exitcode(status)
            self.assertEqual(run.returncode, 0)
            run.stdout.close()
            peaks.append(usage.ru_maxrss)
        self.assertLess(peaks[1], peaks[0] + 8 * 1024, peaks)

    def test_pushed_point_is_refuted_at_its_statement(self):
        for shift, code in ((-0.002, "E0904"), (0.004, "E0905")):
            records = self.records()
            motion = next(r for r in records if r["isn"] == 12 and r["kind"] == "GOTO")
            point = motion["points"][len(motion["points"]) // 2]
            length = math.hypot(point[0], point[2] + 1.0)
            point[0] += shift * point[0] / length
            point[2] += shift * (point[2] + 1.0) / length
            self.store(records)
            self.assertExit(5, "verify", "s.apt", "s.jsonl")
            self.assertIn(f"s.apt:12:1: error[{code}]", self.err)

    def test_tool_end_pushed_off_the_drive_surface(self):
        records = self.records()
        motion = next(r for r in records if r["isn"] == 12 and r["kind"] == "GOTO")
        motion["points"][1][1] = 0.0021
        self.store(records)
        self.assertExit(5, "verify", "s.apt", "s.jsonl")
        self.assertIn("`L1` at", self.err)

    def test_a_startup_that_is_too_low_does_not_put_the_tool_end_on_the_part(self):
        # The rim of the flat tool touches the leaning plane; 3.75 lower the tool end is on it, which no word asks for.
        records = self.records("OUTTOL/.01\nCUTTER/10\nPS=PLANE/-.6,0,.8,0\nDS=PLANE/0,1,0,0\nFROM/-20,0,20\n"
                               "GO/ON,DS,TO,PS,ON,(PLANE/1,0,0,-10)\nINDIRV/1,0,0\n"
                               "TLON,GOFWD/DS,ON,(PLANE/1,0,0,10)\nFINI\n")
        startup = next(r for r in records if r["kind"] == "GOTO")
        startup["points"][0][2] -= 3.75
        self.store(records)
        self.assertExit(5, "verify", "s.apt", "s.jsonl")
        self.assertIn("E0914", self.err)
        self.assertIn("3 inside `PS` at (-10, 0, -7.5) on cut vector 1", self.err)
        self.assertNotIn("E0905", self.err)

    def test_a_startup_that_is_too_far_does_not_put_the_tool_end_on_the_drive(self):
        records = self.records("OUTTOL/.01\nCUTTER/10\nPS=PLANE/0,0,1,0\nDS=PLANE/0,1,0,0\nFROM/-20,20,20\n"
                               "GO/TO,DS,TO,PS,ON,(PLANE/1,0,0,-10)\nINDIRV/1,0,0\n"
                               "GOFWD/DS,ON,(PLANE/1,0,0,10)\nFINI\n")
        startup = next(r for r in records if r["kind"] == "GOTO")
        startup["points"][0][1] -= 5.0
        self.store(records)
        self.assertExit(5, "verify", "s.apt", "s.jsonl")
        self.assertIn("E0914", self.err)
        self.assertIn("5 inside `DS` at (-10, 0, 0) on cut vector 1", self.err)
        self.assertNotIn("E0905", self.err)

    def test_a_chord_that_gouges_between_good_ends_is_refuted(self):
        records = self.records()
        motion = next(r for r in records if r["isn"] == 12 and r["kind"] == "GOTO")
        middle = len(motion["points"]) // 2
        del motion["points"][middle - 1 : middle + 1]  # three chords become one: sagitta times nine
        self.store(records)
        self.assertExit(5, "verify", "s.apt", "s.jsonl")
        self.assertIn("s.apt:12:1: error[E0904]", self.err)
        self.assertIn(f"on cut vector {middle} of", self.err)

    def test_short_and_long_motions_miss_their_stop(self):
        for change in ("short", "long"):
            records = self.records(POCKET, "p.apt", "p.jsonl")
            motion = next(r for r in records if r["isn"] == 11 and r["kind"] == "GOTO")
            motion["points"][-1][0] += 0.01 if change == "long" else -0.01
            self.store(records, "p.jsonl")
            self.assertExit(5, "verify", "p.apt", "p.jsonl")
            self.assertIn("p.apt:11:1: error[E0907]", self.err)

    def test_tangent_stop_that_does_not_touch(self):
        records = self.records(POCKET, "p.apt", "p.jsonl")
        motion = next(r for r in records if r["isn"] == 12 and r["kind"] == "GOTO")
        motion["points"][-1][1] -= 0.2
        self.store(records, "p.jsonl")
        self.assertExit(5, "verify", "p.apt", "p.jsonl")
        self.assertIn("p.apt:12:1: error[E0908]", self.err)

    def test_missing_surplus_and_moved_locations(self):
        whole = self.records()
        self.store([r for r in whole if r["isn"] != 12])
        self.assertExit(5, "verify", "s.apt", "s.jsonl")
        self.assertIn("s.apt:12:1: error[E0910]", self.err)
        extra = dict(next(r for r in whole if r["isn"] == 13), isn=14)
        self.store([*whole[:-1], extra, whole[-1]])
        self.assertExit(5, "verify", "s.apt", "s.jsonl")
        self.assertIn("E0911", self.err)
        moved = json.loads(json.dumps(whole))
        next(r for r in moved if r["isn"] == 13)["points"][0][2] += 0.5
        self.store(moved)
        self.assertExit(5, "verify", "s.apt", "s.jsonl")
        self.assertIn("s.apt:13:1: error[E0912]: the tool end is 0.5 away", self.err)

    def test_copy_that_moved(self):
        source = CASES / "e05_copy_transl.apt"
        self.assertExit(0, source, "-o", "p.jsonl")
        records = [json.loads(line) for line in (self.folder / "p.jsonl").read_text().splitlines()]
        points = [r for r in records if r["kind"] in ("GOTO", "FROM")]
        points[-2]["points"][0][0] += 0.01
        self.store(records, "p.jsonl")
        self.assertExit(5, "verify", source, "p.jsonl")
        self.assertRegex(self.err, "E0913|E0912")

    def test_what_touches_the_limit_is_told_from_what_does_not(self):
        # The inner tolerance is closed in upon the least gap of a path over a saddle, which a search finds only: proven at
        # one end, refuted at the other, and every tolerance between is decided, down to 1e-13.
        text = "PARTNO SADDLE\n3DCALC\nINTOL/{:.16f}\nOUTTOL/.002\nCUTTER/1,.2\nPS1=QADRIC/.03,-.03,0,0,0,0,0,0,1,0\n" \
               "DS1=PLANE/0,1,0,.3\nX1=PLANE/1,0,0,-4\nX2=PLANE/1,0,0,4\nFROM/-4,.3,3\nGO/ON,DS1,TO,PS1,ON,X1\n" \
               "INDIRV/1,0,0\nTLON,GOFWD/DS1,ON,X2\nFINI\n"
        self.records(text.format(.002))
        code, rows = self.rows("s.apt", "s.jsonl", "--slack", "0")
        self.assertEqual(code, 0)
        touching = -rows[-1]["part"]["measuredInner"]
        clear = touching + 1e-6
        while clear - touching > 1e-13:
            middle = 0.5 * (touching + clear)
            self.write("s.apt", text.format(middle))
            code = self.run_arelem("verify", "s.apt", "s.jsonl", "--slack", "0", "--diagnostics", "json")
            found = [d["code"] for d in map(json.loads, filter(lambda l: l.startswith("{"), self.err.splitlines()))]
            self.assertIn((code, found), ((0, []), (5, ["E0904"])), self.err)
            touching, clear = (middle, clear) if code else (touching, middle)
        self.assertGreater(clear, -rows[-1]["part"]["measuredInner"])

    def test_slack_is_small_beside_the_band(self):
        # A path made for ten times the tolerance is refuted, however small both are.
        text = "TOLER/{:.9f}\nNUMPTS/9000\nCUTTER/.02,.01\nS1=SPHERE/0,0,0,.09\nL1=LINE/0,0,.01,0\nL2=LINE/-.06,-.09,-.06,.09\nL3=LINE/.06,-.09,.06,.09\n" \
               "FROM/-.08,0,.09\nGO/ON,L1,TO,S1,ON,L2\nINDIRV/1,0,0\nTLON,GOFWD/L1,ON,L3\nFINI\n"
        self.records(text.format(1e-6))
        self.assertExit(0, "verify", "s.apt", "s.jsonl")
        self.write("s.apt", text.format(1e-7))
        self.assertExit(5, "verify", "s.apt", "s.jsonl")
        self.assertExit(0, "verify", "s.apt", "s.jsonl", "--slack", "1e-6")
        self.assertExit(0, "verify", "s.apt")

    def test_slack_admits_rounded_files(self):
        self.write("s.apt", SPHERE)
        self.assertExit(0, "s.apt", "-o", "s.cls", "--decimals", "4")
        self.assertExit(5, "verify", "s.apt", "s.cls")
        self.assertIn("have 4 decimals at most: `--slack 0.0001` allows", self.err)
        self.assertExit(0, "verify", "s.apt", "s.cls", "--slack", "0.0001")
        self.assertExit(0, "s.apt", "-o", "e.cls")
        self.write("s.apt", SPHERE.replace("OUTTOL/", "OUTTOL/.00000001 $$ "))
        self.assertExit(5, "verify", "s.apt", "e.cls")
        self.assertNotIn("decimals at most", self.err)

    def test_damaged_records_are_unreadable_input(self):
        self.records()
        self.write("s.jsonl", '{"rec": 2, "kind": "GOTO", "isn": 12, "points": [[1, 2]]}\n')
        self.assertExit(3, "verify", "s.apt", "s.jsonl")
        self.assertIn("E0727", self.err)
        self.write("s.jsonl", '{"rec": 2\n{}\n')
        self.assertExit(3, "verify", "s.apt", "s.jsonl")

    def test_table_names_line_surface_and_verdict(self):
        self.write("s.apt", SPHERE)
        self.assertExit(0, "verify", "s.apt")
        row = next(line for line in self.out.splitlines() if "GOFWD" in line)
        for word in ("12", "L1", "S1", "proven", "ON L3"):
            self.assertIn(word, row)


class Splines(ArelemCase):
    PROGRAM = ("CUTTER/6\nTOLER/.002\nFEDRAT/600\nB1=BSPLIN/0,0,0, 10,8,0, 20,-8,4, 30,0,0\n"
               "B2=BSPLIN/CLOSED,30,0,0, 40,5,2, 50,0,4, 40,-5,2\nFROM/0,0,9\nGOTO/B1\nGOTO/B2\nGOTO/0,0,9\nFINI\n")

    def test_paths_of_every_format_are_proven(self):
        self.write("p.apt", self.PROGRAM)
        self.assertExit(0, "compile", "p.apt", "-o", "p.cls", "-o", "p.cltape", "-o", "p.jsonl")
        self.assertIn("$$-> BSPLIN / 0.0, 4.0,", (self.folder / "p.cls").read_text())
        for path in ((), ("p.cls",), ("p.cltape",), ("p.jsonl",)):
            self.assertExit(0, "verify", "p.apt", *path, "--json")
            rows = [json.loads(line) for line in self.out.splitlines()]
            splines = [row["drive"] for row in rows if "drive" in row]
            self.assertEqual([row["surface"] for row in splines], ["B1", "B2"])
            for drive in splines:
                self.assertLessEqual(drive["outer"], 0.002)
                self.assertGreater(drive["outer"], 0.0005)
                self.assertEqual(drive["outerIs"], "proven")

    def test_a_place_off_the_curve_is_found(self):
        self.write("p.apt", self.PROGRAM)
        self.assertExit(0, "compile", "p.apt", "-o", "p.cls")
        lines = (self.folder / "p.cls").read_text().splitlines()
        at = [i for i, line in enumerate(lines) if line.startswith("GOTO")][5]
        x, y, z = (float(w) for w in lines[at].split("/")[1].split(","))
        lines[at] = f"GOTO / {x}, {y}, {z + 0.01}"
        self.write("q.cls", "\n".join(lines) + "\n")
        self.assertExit(5, "verify", "p.apt", "q.cls")
        self.assertIn("E0905", self.err)

    def test_smooth_is_told(self):
        self.write("s.apt", "CUTTER/6\nFEDRAT/600\nFROM/0,0,0\nSMOOTH/.05\nGOTO/20,0,0\nGOTO/40,.5,0\nGOTO/40,20,0\n"
                   "SMOOTH/NOMORE\nFINI\n")
        self.assertExit(5, "verify", "s.apt")
        self.assertEqual(self.err.count("error["), 1)
        self.assertIn("E0915", self.err)
        self.assertExit(0, "compile", "s.apt", "-o", "s.cls")
        self.assertExit(0, "verify", "s.cls", "--with", "s.apt")


if __name__ == "__main__":
    unittest.main()
