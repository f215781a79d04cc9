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
