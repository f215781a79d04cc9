#!/usr/bin/env python3
"""Large CL text is read piece by piece: in little memory, and with the same outputs as when it is read at once."""
import resource
import subprocess
import unittest

from arelem_run import ARELEM, ArelemCase

LINES = 220_000  # some 6 MB: more than is read at once


def places(count=LINES):
    return [f"GOTO/{i * 0.0625:.4f},{(i * 7919) % 1000 * 0.01:.4f},{-(i % 50) * 0.1:.4f}" for i in range(count)]


class Streamed(ArelemCase):
    def both(self, text, *words):
        """--report wants what only the whole program tells, so that it is read at once."""
        self.write("a.cls", text)
        outputs = [f"{way}.{suffix}" for way in "sw" for suffix in ("cltape", "cls", "jsonl")]
        for way, more in (("s", ()), ("w", ("--report", "r.json"))):
            files = [word for name in outputs if name[0] == way for word in ("-o", name)]
            self.assertExit(0, "compile", "a.cls", *files, *more, *words)
        for suffix in ("cltape", "cls", "jsonl"):
            streamed, whole = ((self.folder / f"{way}.{suffix}").read_bytes() for way in "sw")
            self.assertEqual(len(streamed), len(whole), suffix)
            self.assertTrue(streamed == whole, suffix)
        return streamed

    def head(self, *statements):
        return "\n".join(("$$ISO", "PARTNO LARGE", "UNITS/MM", "CUTTER/10,1", *statements, ""))

    def test_places_words_and_arcs(self):
        lines = places()
        for i in range(500, LINES - 1, 500):
            lines[i] += "\nRAPID"
            lines[i + 250] += " $\n" if i % 1000 == 0 else ""  # a line that goes on, and nothing behind it
        lines[1001] = "FEDRAT/250,MMPM\nGOTO/5,0,0\nCIRCLE/0,0,0,0,0,1,5\nGOTO/0,5,0\nTLAXIS/0,0.6,0.8\nMULTAX/ON"
        self.both(self.head() + "\n".join(lines) + "\nFINI\n")

    def test_without_fini(self):
        self.both(self.head() + "\n".join(places()) + "\n")

    def test_text_behind_fini(self):
        lines = places()
        lines[LINES // 2] += "\nFINI"
        self.both(self.head() + "\n".join(lines) + "\n")

    def test_definitions_and_warnings_far_behind(self):
        lines = places()
        lines[LINES - 50] += "\nFEDRAT/10,IPM"       # W0579
        lines[LINES - 40] += "\nP9=POINT/1,2,3\nGOTO/P9"
        records = self.both(self.head() + "\n".join(lines) + "\nFINI\n")
        self.assertIn(b"P9", records)
        self.assertIn("W0579", self.err)

    def test_an_error_far_behind_leaves_the_old_file(self):
        lines = places()
        lines[LINES - 2] += "\nGOTO/1,2,)"
        self.write("a.cls", self.head() + "\n".join(lines) + "\nFINI\n")
        self.write("old.cltape", "old")
        self.assertExit(1, "compile", "a.cls", "-o", "old.cltape")
        self.assertEqual((self.folder / "old.cltape").read_text(), "old")
        self.assertIn(f"a.cls:{LINES + 4}:", self.err)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["a.cls", "old.cltape"])

    def test_limits_count_the_whole_file(self):
        self.write("a.cls", self.head() + "\n".join(places()) + "\nFINI\n")
        self.assertExit(7, "compile", "a.cls", "-o", "a.cltape", "--max-steps", "200000")
        self.assertIn("200000", self.err)

    def test_memory_does_not_grow_with_the_file(self):
        most = []
        for copies in (1, 3):
            self.write("a.cls", self.head() + "\n".join(places()) + "\n" + "\n".join(places() * (copies - 1)))
            done = subprocess.run([ARELEM, "a.cls", "-o", "a.cltape"], cwd=self.folder, capture_output=True,
                                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (400 << 20, 400 << 20)))
            most.append((done.returncode, done.stderr))
        self.assertEqual(most, [(0, b"")] * 2)


if __name__ == "__main__":
    unittest.main()
