#!/usr/bin/env python3
"""Every row of the golden files of spray painting that has a number is a test, found by its name."""
import json
import pathlib
import re
import subprocess
import unittest

import arelem_run
from arelem_run import ArelemCase, PROJECT

BUILD = pathlib.Path(arelem_run.ARELEM).parent
BINARIES = [BUILD / "test_runtime", BUILD / "test_backend"]
HERE = {"SEN-pos"}  # tested below, by the whole command
# What the manual shows of the rows that differ: of its table the line that holds all of it.
SHOWN = {
    "BART-ell-offset-listing-bug": ("68.503", "69.906"), "BART-inset2": ("0.74 b", "0.9445", "0.7065", "0.52473"),
    "BART-bpref-correct": ("71.4, 62.2, 55.1, 49.5", "70.30, 61.40, 54.50, 48.99"), "BART-nbounds": ("23.35", "5.57", "24.35", "6.57"),
    "BART-vertex-hit-text": ("1 hit", "2"), "BART-vertex-peak-program": ("1 hit", "peak", "0"),
    "SEN-dialog-table": ("21.08", "7.68", "20.23", "65.13", "20.3, 7.769, 20.47, 61.99"), "SEN-dialog-lines": ("20.16, 7.642, 20.13, 62.59",),
    "SEN-dialog-pressure-lines": ("20.63, 7.694, 20.26, 63.63",), "SEN-dialog-bilinear-regression": ("20.32, 7.539, 19.85, 63.97",),
    "SEN-pqr-ppp": ("(1, 1, 1)", "45", "9.74", "35.26"), "SEN-pqr-x": ("(1, 0, 0)", "Q = 90"), "SEN-pqr-ppn": ("(1, 1, -1)", "45", "-135"),
    "SEN-pqr-g": ("12.14", "0.57", "11.57"),
}
SAME = {"SEN-pqr-npp": "SEN-pqr-ppp", "SEN-pqr-nnp": "SEN-pqr-ppp", "SEN-pqr-pnp": "SEN-pqr-ppp"}  # but for signs


def rows(name):
    return json.loads((PROJECT / "tests" / "data" / "golden" / name).read_text())


class Rows(ArelemCase):
    @unittest.skipUnless(all(b.exists() for b in BINARIES), "the unit tests are not built")
    def test_every_row_is_a_test(self):
        listed = "".join(subprocess.run([b, "--gtest_list_tests"], capture_output=True, text=True, check=True).stdout
                         for b in BINARIES)
        names = set(re.findall(r"GivesTheNumbers/(\w+)", listed))
        for file in ("cases_bartlett.json", "cases_sen.json"):
            for row in rows(file):
                with self.subTest(row["id"]):
                    if row["status"] == "not reproducible":
                        self.assertNotIn("expected", row)
                    elif row["id"] not in HERE:
                        self.assertIn(re.sub(r"\W", "_", row["id"]), names)

    def test_both_values_are_shown_where_the_source_differs(self):
        page = (PROJECT / "docs" / "manual" / "spray.md").read_text()
        table = [line for line in page.split("## Where the sources are wrong")[1].splitlines() if line.startswith("|")]
        for file in ("cases_bartlett.json", "cases_sen.json"):
            for row in rows(file):
                if row["status"] == "differs":
                    with self.subTest(row["id"]):
                        shown = SHOWN[SAME.get(row["id"], row["id"])]
                        self.assertTrue(any(all(one in line for one in shown) for line in table), shown)

    def test_the_gun_stands_off_along_the_normal(self):
        row, = (r for r in rows("cases_sen.json") if r["id"] == "SEN-pos")
        (x, y, z), n, d = row["inputs"]["xw"], row["inputs"]["n"], row["inputs"]["d"]
        self.assertEqual(n, [0, 0, 1])
        self.write("a.apt", f"UNITS/MM\nG=GUN/CONE,10,STNDOF,{d},SPEED,100\nP=PLANE/0,0,1,{z}\n"
                            f"SPRAY/P,GUN,G,FILM,.05,ULINES,LIMITS,{x},{x + 100},{y},{y + 40}\nFINI\n")
        self.assertExit(0, "a.apt")
        first = next(line for line in self.out.splitlines() if "GOTO" in line)
        place = [float(v) for v in first.split("/")[1].split(",")]
        for got, wanted in zip(place, row["expected"]["p"] + n):
            self.assertAlmostEqual(got, wanted, places=6)


if __name__ == "__main__":
    unittest.main()
