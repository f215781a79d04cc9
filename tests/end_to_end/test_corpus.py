#!/usr/bin/env python3
"""Every file of the collection, what becomes of its words, and why each message is there: docs/manual/corpus.md.

`test_corpus.py --write` writes the page again. The collection belongs to others and is read in place (ARELEM_SHARED)."""
import collections
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from arelem_run import ARELEM, PROJECT

SHARED = pathlib.Path(os.environ.get("ARELEM_SHARED", PROJECT.parent / "shared"))
CORPUS = SHARED / "corpus"
PAGE = PROJECT / "docs" / "manual" / "corpus.md"
GROUPS = {
    "aptos-apt360": "Part programs for APT360",
    "aamorim-aptpost": "SolidWorks CAM and CAMWorks",
    "alexandrums-catia": "CATIA, turning",
    "karlo-catia": "CATIA, milling",
    "hofft-creopost": "Creo",
    "s2538-creo": "Creo",
    "humman-clsf": "NX",
    "jmr1-bcpost": "NX, single lines",
    "steptools-stepnode": "STEP tools",
    "kuka-fdm": "Fusion and a slicer for robots",
    "web": "Manuals and web pages",
    "cam-i-apt4-ssv3": "CAM-I tests of APT IV, 1989",
}
SCULPTURED = ("SSURF", "SCURV", "SMESH", "GENCUR", "PATCH", "REVOLV", "RULED", "COMBIN", "SPLINE", "POLYGN", "PNTSON", "CURSEG", "SCON",
              "SMIL")
# What a message means in these files. A code that is not here fails the test: nothing stays unexplained.
WHY = {
    "W0201": "text behind FINI, which the old system did not read either",
    "W0203": "a comma behind the type of OBTAIN, as the old system allowed",
    "W0204": "a name in PRINT that nothing defines: passed on as text",
    "W0208": "IF and JUMPTO outside loops and macros: APT IV and the old system differ, taken",
    "W0209": "half an axis in a list of lines that a parser must take: no axis",
    "W0474": "words without an effect here (CLPRNT, an axis 0, 0, 0, the tool behind an arc), counted",
    "W0490": "motion inside REFSYS is moved to the base system",
    "W0501": "TLLFT or TLRGT on the other side than the tool is: the old system warns and goes on, so do we",
    "W0579": "UNITS/INCHES and FEDRAT in MMPM in one file, a fault of the system that wrote it",
    "W0598": "one path through several frames",
    "E0504": "the tool is 7 off the part surface: the old system ends here with its number 502",
    "E0505": "the upper rim of the tilted cutter is 0.0067 inside C4B, 67 times the program's tolerance of 0.0001. Its author left out the "
             "CUTTER/OPTION that he gave for the other circles; the old system looks at the lower end of the cutter only. With the "
             "line `cutter/option,2,(cut1/2),0` before statement 96 the program compiles. The later ones follow",
    "E0201": "a name that an unsupported statement would have defined",
    "E0212": "a name that is a word of the language (STOP): APT IV let names be words",
    "E0248": "SYN of WEIGHT, a word of the sculptured surfaces",
    "E0276": "a name that an unsupported statement would have defined, in a place where only a surface may stand",
    "E0277": "the name STOP again, which stays a word",
    "E0402": "an element of an array that an unsupported statement would have filled",
    "E0415": "a second definition of a name, in a macro that is called twice: APT IV took it, APT360 and we want CANON/ON",
    "E0442": "TLAXIS/PARLEL with numbers for the height on a ruled surface, a form of APT IV",
    "E0299": "SSURF and SCURV: sculptured curves and surfaces of APT IV are not computed",
}


def run(*words):
    done = subprocess.run([ARELEM, *map(str, words)], capture_output=True, timeout=120)
    return done.returncode, done.stdout.decode(errors="replace"), done.stderr.decode(errors="replace")


def first_word(line):
    """What stands before the slash, a comma or an equal sign; the first word of texts."""
    head = re.split(r"[/,=($]", line, maxsplit=1)[0].strip().upper()
    return " ".join(head.split())


def look(path):
    """Counts of --words, and what compile says."""
    counts = collections.Counter()
    words = set()
    _, out, _ = run("check", path, "--words", "-q")
    for line in out.splitlines():
        found = re.match(r"(.+?) +(\d+)  (understood|passed on|reported|comments)", line)
        counts[found[3]] += int(found[2])
        words.add(found[1].strip())
    with tempfile.TemporaryDirectory() as folder:
        code, _, err = run("compile", path, "-o", f"{folder}/x.cltape", "--diagnostics", "gnu", "--max-errors", "1000")
    codes = collections.Counter(re.findall(r"(?:error|warning)\[([EW]\d{4})\]", err))
    text = path.read_bytes().decode(errors="replace").upper()
    used = [w for w in SCULPTURED if re.search(rf"\b{w}\b", text)]
    return counts, words, code, codes, used


def rows():
    for folder, title in GROUPS.items():
        for path in sorted((CORPUS / folder).iterdir()):
            yield folder, title, path, look(path)


def page():
    lines = ["# Files of others, and what arelem makes of them", "",
             "Every file of the collection of part programs and CL files that this project is measured by. The files belong to others and are",
             "not part of the project; `tests/end_to_end/test_corpus.py --write` makes this page, and the test compares it.", "",
             "*Statements*: understood (the path or the outputs act on them), passed on (they stand in the CL data as they were written),",
             "reported (a message tells of them), as `arelem check FILE --words` counts. *Result*: compiled, or the first step that failed.", ""]
    seen = set()
    title = None
    for folder, name, path, (counts, _, code, codes, used) in rows():
        last = folder == "cam-i-apt4-ssv3"
        if name != title:
            title = name
            lines += [f"## {title}", ""]
            if last:
                lines += ["All of them define sculptured curves or surfaces. Each such definition is an error that names its word (E0299); what does",
                          "not need them is read and checked all the same.", "",
                          "| file | understood | reported | messages | words of sculptured surfaces |", "|---|---|---|---|---|"]
            else:
                lines += ["| file | understood | passed on | reported | result | messages |", "|---|---|---|---|---|---|"]
        told = ", ".join(f"{c} x {k}" if c > 1 else k for k, c in sorted(codes.items()))
        seen |= set(codes)
        if last:
            lines.append(f"| {path.name} | {counts['understood']} | {counts['reported']} | {told} | {', '.join(used)} |")
        else:
            result = {0: "compiled", 4: "motion refused"}.get(code, f"exit code {code}")
            lines.append(f"| {path.name} | {counts['understood']} | {counts['passed on']} | {counts['reported']} | {result} | {told} |")
        following = path == max((CORPUS / folder).iterdir())
        if following:
            lines.append("")
    lines = [line for i, line in enumerate(lines) if not (line == "" and i + 1 < len(lines) and lines[i + 1].startswith("| ") and lines[i - 1].startswith("| "))]
    lines += ["## Why each message is there", "", "| message | in these files |", "|---|---|"]
    lines += [f"| [{code}](diagnostics/{code}.md) | {WHY.get(code, 'NOT EXPLAINED')} |" for code in sorted(seen, key=lambda c: (c[1:], c))]
    return "\n".join(lines) + "\n"


@unittest.skipUnless(CORPUS.is_dir(), f"the corpus is not at {SHARED}")
class Collection(unittest.TestCase):
    def test_the_page_is_true(self):
        text = page()
        self.assertNotIn("NOT EXPLAINED", text)
        self.assertEqual(text, PAGE.read_text(), "test_corpus.py --write")

    def test_case4axis_with_its_missing_line(self):
        text = (CORPUS / "aptos-apt360" / "case4axis.apt").read_text()
        mended = text.replace("gofwd/c4b,on,l7", "cutter/option,2,(cut1/2),0\ngofwd/c4b,on,l7")
        self.assertNotEqual(mended, text)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "mended.apt"
            path.write_text(mended)
            code, _, err = run("compile", path, "-o", f"{folder}/x.cl")
            self.assertEqual(code, 0, err)

    def test_every_word_is_counted(self):
        for folder in GROUPS:
            if folder in ("aptos-apt360", "cam-i-apt4-ssv3", "web"):
                continue  # programs: a line may hold several statements, names and labels
            for path in sorted((CORPUS / folder).iterdir()):
                _, words, _, _, _ = look(path)
                goes_on = False
                for line in path.read_bytes().decode(errors="replace").splitlines():
                    begins, goes_on = not goes_on, line.rstrip().endswith("$")
                    if not begins or not line.strip() or line.lstrip().startswith("$$"):
                        continue
                    word = first_word(line)
                    word = {"UNIT": "UNITS", "TLON": "CIRCLE"}.get(word, word)  # TLON,GOFWD/(CIRCLE/...) is the arc of CATIA
                    short = {w for w in words if word == w or word.startswith(w + " ") or word.replace(" ", "") == w}
                    self.assertTrue(short or word == "FINI", f"{path.name}: {line!r} in {sorted(words)}")


if __name__ == "__main__":
    if "--write" in sys.argv:
        PAGE.write_text(page())
    else:
        unittest.main()
