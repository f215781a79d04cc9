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
        told = []
        for way, more in (("s", ()), ("w", ("--report", "r.json"))):
            files = [word for name in outputs if name[0] == way for word in ("-o", name)]
            self.assertExit(0, "compile", "a.cls", *files, *more, *words)
            told.append(self.err)
        self.assertEqual(*told)
        self.told = told[0]
        counts = []
        for more in ((), ("--report", "r.json")):
            self.assertExit(0, "check", "a.cls", "--words", *more)
            counts.append((self.out, self.err))
        self.assertEqual(*counts)
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

    def test_warnings_are_those_of_a_text_read_at_once(self):
        lines = places()
        for i in (5, 70_000, 140_000, LINES - 5):
            lines[i] += "\nSPINDL/FLOOD\nFEDRAT/10,IPM\nGOTO/0,0,0,0,0,0\nSOME WORD/1,A\nCLPRNT"
        lines[100_000] += "\nGOTO/5,0,0\nCIRCLE/0,0,0,0,0,1,5,1,1,1,1\nGOTO/0,5.001,0"
        self.both(self.head() + "\n".join(lines) + "\nFINI\n")
        for code in ("W0583", "W0579", "W0474", "W0576"):
            self.assertIn(code, self.told)
        self.assertExit(0, "compile", "a.cls", "-o", "a.jsonl", "--diagnostics", "json")
        streamed = self.err
        self.assertExit(0, "compile", "a.cls", "-o", "a.jsonl", "--diagnostics", "json", "--report", "r.json")
        self.assertEqual(streamed, self.err)

    def test_text_without_the_mark_of_a_system(self):
        lines = [line.lower() for line in places()]
        lines[7] += "\nfedrat/(2*50)\nrapid"
        self.both("partno plain\ncutter/10\n" + "\n".join(lines) + "\nfini\n")
        self.limited("a.cls", "-o", "a.cltape")

    def test_a_part_program_is_read_at_once(self):
        lines = places()
        lines[LINES // 2] += "\nA=2\nGOTO/A,A,A"
        self.both("PARTNO PROGRAM\n" + "\n".join(lines) + "\nFINI\n")

    def test_a_frame_between_two_pieces_stays_whole(self):
        frame = "$$*CATIA0\n$$ AXIS\n" + "".join(
            f"$$ {a:.5f} {b:.5f} {c:.5f} 1.0\n" for a, b, c in ((0, 1, 0), (1, 0, 0), (0, 0, -1)))
        lines = [frame + line if i % 3 == 0 else line for i, line in enumerate(places(60_000))]
        self.both(self.head() + "\n".join(lines) + "\nFINI\n", "--frame", "part")

    def limited(self, *words):
        """Runs in 400 MB of addresses, of which a program with its libraries and threads takes half."""
        done = subprocess.run([ARELEM, *words], cwd=self.folder, capture_output=True,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (400 << 20, 400 << 20)))
        self.assertEqual((done.returncode, done.stderr), (0, b""), words)
        return done.stdout

    def test_memory_does_not_grow_with_the_file(self):
        for copies in (1, 3):
            self.write("a.cls", self.head() + "\n".join(places()) + "\n" + "\n".join(places() * (copies - 1)))
            self.limited("a.cls", "-o", "a.cltape")
            self.assertIn(b"GOTO", self.limited("check", "a.cls", "--words", "--quiet"))
            self.limited("a.cltape", "-o", "b.cls")
            self.assertIn(f"{LINES * copies} moves".encode(), self.limited("diff", "a.cls", "a.cltape"))

    def test_differences_in_pieces(self):
        lines = places()
        self.write("a.cls", self.head() + "\n".join(lines) + "\nFINI\n")
        lines[200_000] = "GOTO/0,0,99"
        self.write("b.cls", self.head() + "\n".join(lines) + "\nFINI\n")
        self.assertExit(5, "diff", "a.cls", "b.cls")
        self.assertIn("first difference: move 200001 (a.cls:200005)", self.out)
        # A transformation far behind: the second file is read once more, at once.
        lines[LINES - 9] += "\nTRACUT/(MATRIX/TRANSL,0,0,1)"
        self.write("b.cls", self.head() + "\n".join(lines) + "\nFINI\n")
        self.assertExit(5, "diff", "a.cls", "b.cls")
        self.assertIn("first difference: move 200001 (a.cls:200005)", self.out)
        self.assertIn("; 9 differ", self.out)


if __name__ == "__main__":
    unittest.main()
