"""`arelem fmt`: the same meaning, comments kept, the same again."""
import concurrent.futures
import os
import pathlib
import re
import subprocess
import tempfile

import unittest

from arelem_run import ARELEM, PROJECT, ArelemCase

SHARED = pathlib.Path(os.environ.get("ARELEM_SHARED", PROJECT.parent / "shared"))

BLOCKS = """partno a text stays
  l1 = line / 0 , 0 , 8 0 , 0   $$ first line
m = macro / a = 3 , b
if ( a .lt. 4 ) then
p1=point/a,b,0
   else
p1=point/b,a,0
endif
termac
call / m , b = 7
loopst
k=1
again) k=k+1
if(k-5)again,done,done
done) x=2
loopnd
fini
 whatever stands behind
"""
BLOCKS_DONE = """partno a text stays
L1=LINE/0,0,80,0                $$ first line
M=MACRO/A=3,B
  IF (A .LT. 4) THEN
    P1=POINT/A,B,0
  ELSE
    P1=POINT/B,A,0
  ENDIF
TERMAC
CALL/M,B=7
LOOPST
  K=1
  AGAIN) K=K+1
  IF (K-5) AGAIN,DONE,DONE
  DONE) X=2
LOOPND
FINI
 whatever stands behind
"""


def programs():
    ours = [p for root in ("examples", "tests", "stdlib", "bench") for p in (PROJECT / root).rglob("*.apt")]
    folders = [SHARED / "corpus", SHARED / "oracle"]
    theirs = [p for f in folders if f.is_dir() for p in f.rglob("*")
              if p.suffix.lower() in (".apt", ".aptsource", ".cls", ".clsf", ".ncl", ".cldata", ".clt", ".pro", ".1")]
    return sorted(ours), sorted(theirs)


def meaning(path, include):
    """Exit code, codes of the messages, and the records with their statement numbers and identifications."""
    done = subprocess.run([ARELEM, "compile", str(path), "--to", "json", "--diagnostics=gnu", "-I", str(include),
                           "--max-errors", "1000"], capture_output=True, timeout=300)
    tape = subprocess.run([ARELEM, "compile", str(path), "--to", "cltape", "--force", "-q", "-I", str(include)],
                          capture_output=True, timeout=300)
    codes = sorted(re.findall(rb"(?:error|warning)\[(\w+)\]", done.stderr))
    return done.returncode, codes, done.stdout, tape.stdout


def try_one(path):
    """What is wrong with the layout of this program, or nothing."""
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / path.name
        copy.write_bytes(path.read_bytes())
        for data in path.parent.glob("*.DAT"):
            (pathlib.Path(folder) / data.name).symlink_to(data)
        before = meaning(copy, path.parent)
        first = subprocess.run([ARELEM, "fmt", str(copy), "-q"], capture_output=True, timeout=60)
        if first.returncode not in (0, 3):
            return f"{path}: fmt ended with {first.returncode}: {first.stderr.decode(errors='replace')}"
        once = copy.read_bytes()
        if meaning(copy, path.parent) != before:
            return f"{path}: another meaning"
        subprocess.run([ARELEM, "fmt", str(copy), "-q"], capture_output=True, timeout=60)
        if copy.read_bytes() != once:
            return f"{path}: not the same again"
        comments = [re.findall(rb"\$\$(.*?)[ \t\r]*$", text, re.M) for text in (path.read_bytes(), once)]
        # Columns 73-80 may stand behind a comment.
        if [c[:40].rstrip() for c in comments[0]] != [c[:40].rstrip() for c in comments[1]]:
            return f"{path}: other comments"
    return None


class Format(ArelemCase):
    def formatted(self, text, *options):
        self.write("p.apt", text)
        self.assertExit(0, "fmt", "p.apt", "-q", *options)
        return (self.folder / "p.apt").read_text()

    def test_summary_counts_what_was_written(self):
        self.write("a.apt", "p1=point/1,2\nfini\n")
        self.assertExit(3, "fmt", "a.apt", "none.apt")
        self.assertIn("arelem: 2 files, 1 changed, 1 failed\n", self.err)

    def test_layout(self):
        self.assertEqual(self.formatted(BLOCKS), BLOCKS_DONE)
        self.assertEqual(self.formatted(BLOCKS_DONE), BLOCKS_DONE)

    def test_long_statements_break_at_commas(self):
        points = ",".join(f"(POINT/{i * 10},{i},0)" for i in range(8))
        text = self.formatted(f"CRV=TABCYL/NOZ,SPLINE,{points}\nFINI\n")
        lines = text.splitlines()
        self.assertTrue(all(len(line) <= 72 for line in lines), text)
        self.assertTrue(all(line.endswith(",$") for line in lines[:-2]), text)
        self.assertEqual("".join(line.strip().rstrip("$") for line in lines[:-1]), f"CRV=TABCYL/NOZ,SPLINE,{points}")

    def test_comments_and_breaks_stay(self):
        text = self.formatted("C1=CIRCLE/80,$ the center\n 40,40 $$ and the radius\n\n$$ alone\nFINI\n")
        self.assertEqual(text, "C1=CIRCLE/80, $ the center\n    40,40  $$ and the radius\n\n$$ alone\nFINI\n")

    def test_columns_73_to_80(self):
        card = "p1 = point / 1 , 2 , 3".ljust(72) + "ABC00010\n" + "FINI".ljust(72) + "ABC00020\n"
        kept = self.formatted(card)
        self.assertEqual(kept, "P1=POINT/1,2,3".ljust(72) + "ABC00010\n" + "FINI".ljust(72) + "ABC00020\n")
        self.assertEqual(self.formatted(card, "--drop-columns"), "P1=POINT/1,2,3\nFINI\n")

    def test_deck_and_strings_stay(self):
        text = "READ/1\np1,0,POINT,3, 1.0, 2.0,3.0\nENDPCH\nSTENCL/'a b $$ c', HEIGHT, 1000\nFINI\n"
        self.assertEqual(self.formatted(text), text.replace(", HEIGHT, ", ",HEIGHT,"))

    def test_errors_in_the_program(self):
        text = "p1 = point / 1 , 2.2.2\nl1=line / p1 , p2\n"
        self.assertEqual(self.formatted(text), "p1 = point / 1 , 2.2.2\nL1=LINE/P1,P2\n")

    def test_line_ends_and_empty_files(self):
        self.write("p.apt", b"p1=point/1,2\r\nfini\r\n")
        self.assertExit(0, "fmt", "p.apt")
        self.assertEqual((self.folder / "p.apt").read_bytes(), b"P1=POINT/1,2\r\nFINI\r\n")
        self.assertEqual(self.formatted(""), "")
        self.assertEqual(self.formatted("FINI"), "FINI\n")

    def test_check_changes_nothing(self):
        self.write("a.apt", "fini\n")
        self.write("b.apt", "FINI\n")
        self.assertExit(1, "fmt", "--check", "a.apt", "b.apt")
        self.assertIn("a.apt: would change", self.err)
        self.assertIn("2 files, 1 would change", self.err)
        self.assertEqual((self.folder / "a.apt").read_text(), "fini\n")
        self.assertExit(0, "fmt", "--check", "b.apt")

    def test_streams_and_failures(self):
        self.assertExit(0, "fmt", "-", stdin=b"fini\n")
        self.assertEqual(self.out, "FINI\n")
        self.write("a.apt", "fini\n")
        self.assertExit(0, "fmt", "a.apt", "--stdout")
        self.assertEqual(self.out, "FINI\n")
        self.assertEqual((self.folder / "a.apt").read_text(), "fini\n")
        self.assertExit(3, "fmt", "absent.apt")
        self.assertExit(2, "fmt", "--stdout", "a.apt", "a.apt")

    def test_cl_text_stays(self):
        text = "TOOL PATH/A,TOOL,B\nGOTO/1,  2,3\n"
        self.write("a.cls", text)
        self.assertExit(0, "fmt", "a.cls")
        self.assertIn("CL text", self.err)
        self.assertEqual((self.folder / "a.cls").read_text(), text)

    def test_meaning_of_all_programs(self):
        ours, theirs = programs()
        self.assertGreater(len(ours), 100)
        if not theirs:
            print("the corpus is not here (ARELEM_SHARED): tried our own programs only")
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            wrong = [w for w in pool.map(try_one, ours + theirs) if w]
        self.assertEqual(wrong, [])


if __name__ == "__main__":
    unittest.main()
