#!/usr/bin/env python3
"""compile --jobs: one bad job stops no other, results and manifest do not depend on the number of jobs at once."""
import hashlib
import json
import pathlib
import unittest

from arelem_run import BAD, GOOD, ArelemCase


class Batch(ArelemCase):
    def programs(self, count):
        for i in range(count):
            self.write(f"j{i}.apt", GOOD.replace("1,2,3", f"{i},2,3"))
        return [f"j{i}.apt" for i in range(count)]

    def test_all_outputs_and_a_manifest(self):
        names = self.programs(5)
        self.assertExit(0, "compile", *names, "--jobs", 2, "--out-dir", "out", "--to", "cl", "--to", "cltape")
        manifest = json.loads((self.folder / "out/manifest.json").read_text())
        self.assertEqual([job["input"]["path"] for job in manifest["jobs"]], names)
        for job in manifest["jobs"]:
            self.assertEqual(job["exitCode"], 0)
            self.assertEqual(len(job["outputs"]), 2)
            for entry in [job["input"], *job["outputs"]]:
                data = (self.folder / entry["path"]).read_bytes()
                self.assertEqual(entry["sha256"], hashlib.sha256(data).hexdigest())
                self.assertEqual(entry["bytes"], len(data))
        self.assertIn("5 jobs: 5 done, 0 failed", self.err)

    def test_a_bad_job_stops_no_other(self):
        names = self.programs(4)
        self.write("j1.apt", BAD)
        names.append("missing.apt")
        self.assertExit(3, "compile", *names, "-j", 3, "--out-dir", "out")
        self.assertEqual([f for f in self.files() if f.startswith("out/j")], ["out/j0.cls", "out/j2.cls", "out/j3.cls"])
        self.assertIn("5 jobs: 3 done, 2 failed", self.err)
        self.assertLess(self.err.index("j1.apt:2"), self.err.index("missing.apt"), "messages follow the inputs")
        codes = [job["exitCode"] for job in json.loads((self.folder / "out/manifest.json").read_text())["jobs"]]
        self.assertEqual(codes, [0, 1, 0, 0, 3])

    def test_same_bytes_with_any_number_of_jobs(self):
        names = self.programs(6)
        texts = []
        for jobs in (1, 4, 0):
            self.assertExit(0, "compile", *names, "-q", "--jobs", jobs, "--out-dir", "out")
            texts.append({f: (self.folder / f).read_bytes() for f in self.files() if f.startswith("out/")})
        self.assertEqual(texts[0], texts[1])
        self.assertEqual(texts[0], texts[2])

    def test_options_reach_the_jobs(self):
        self.write("a.apt", "A=1\nGOTO/A,0,0\nFINI\n")
        self.write("A=7", GOOD)  # an input that looks like a value of -D
        self.assertExit(0, "compile", "-D", "A=7", "a.apt", "A=7", "--jobs=2", "--out-dir", "out", "--decimals", "2")
        self.assertIn("GOTO / 7.00, 0.00, 0.00", (self.folder / "out/a.cls").read_text())

    def test_depfile(self):
        self.write("sub/inc.apt", "P1=POINT/1,2,3\n")
        self.write("my part.apt", "INCLUDE/'sub/inc.apt'\nGOTO/P1\nFINI\n")
        self.assertExit(0, "compile", "my part.apt", "-o", "x.cls", "--depfile", "x.d")
        rule = (self.folder / "x.d").read_text()
        self.assertTrue(rule.startswith("x.cls:"), rule)
        self.assertIn("my\\ part.apt", rule)
        self.assertIn("sub/inc.apt", rule)
        machine = "g97_painter.machine.toml"
        self.assertExit(0, "compile", "my part.apt", "-o", "x.cls", "--depfile", "x.d", "--codes", "apt4", "--machine", machine)
        files = [pathlib.Path(line.strip(" \\")) for line in (self.folder / "x.d").read_text().splitlines()]
        self.assertEqual([path.name for path in files[-2:]], ["apt4.toml", machine])
        for path in files[-2:]:
            self.assertTrue((self.folder / path).is_file(), path)
        self.assertExit(2, "compile", "a.apt", "b.apt", "--out-dir", "o", "--depfile", "x.d")


if __name__ == "__main__":
    unittest.main()
