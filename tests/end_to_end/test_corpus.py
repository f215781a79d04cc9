#!/usr/bin/env python3
"""Every file of the collection, what becomes of its words, and why each message is there: docs/manual/corpus.md.

`test_corpus.py --write` writes the page again. The collection belongs to others and is read in place (ARELEM_SHARED)."""
import collections
import json
import math
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
    "W0506": "what follows from a motion that failed: the tool stands where that motion began",
    "W0578": "a list of single lines, in which no GOTO follows the arc",
    "W0585": "a straight move between two places of one circle; the statement says nothing of an arc, so it stays straight, and is told",
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
    "E0402": "an element of an array that an unsupported statement would have filled",
    "E0415": "a second definition of a name, in a macro that is called twice: APT IV took it, APT360 and we want CANON/ON",
    "E0442": "TLAXIS/PARLEL with numbers for the height on a ruled surface, a form of APT IV",
    "E0299": "SSURF and SCURV: sculptured curves and surfaces of APT IV are not computed",
}


ORACLE = SHARED / "oracle" / "examples"
# Why a program's result is not that of the old system. A difference that is not here fails the test.
CHORDS = "curved surfaces: its own chords, which keep the tolerance"
DIFFERS = {
    "case4axis": "its tool gouges C4B in statement 96; see E0505 below",
    "diamondCase": CHORDS + "; the axis is the normal where the tool stands, theirs 0.22 degrees off",
    "ln1000": CHORDS + "; the last stop is at the band's edge",
    "multax": CHORDS,
    "oring_groove": CHORDS + "; the last stop is at the band's edge",
    "race_4th": CHORDS + "; the axis is the normal where the tool stands, theirs 0.4 degrees off",
    "samplePart": "the old system did not run it",
    "sine": "STRTUP and TLEND are our own library's macros, those of the old system are not at hand",
    "slotarray": "STRTUP and TLEND are our own library's macros, those of the old system are not at hand",
    "sphere": CHORDS + "; the last stop is nearer to the exact one than theirs",
    "spool": "DELETE and OPSKIP have one number on the tape; the program says OPSKIP",
    "tabcyl": CHORDS,
    "test2": "the old system ends at the same statement, with its number 502; see E0504 below",
    "test3": "an iteration ends where both are within tolerance",
}


def near(a, b):
    """Equal; numbers up to rounding."""
    if isinstance(a, list):
        return isinstance(b, list) and len(a) == len(b) and all(near(x, y) for x, y in zip(a, b))
    if isinstance(a, (int, float)) and isinstance(b, (int, float)):
        return abs(a - b) <= 1e-9 * max(1.0, abs(a))
    return a == b


def against_the_old_system(path):
    """A row: places of both, how far apart the last ones are, words for the machine of both, why they differ."""
    name = path.stem
    why = DIFFERS.get(name, "")
    oracle = ORACLE / f"{name}.json"
    if not oracle.exists():
        return f"| {path.name} | | | | {why or 'NOT EXPLAINED'} |"
    code, out, _ = run("compile", path, "--to", "json", "--max-errors", "1000")
    mine = [json.loads(line) for line in out.splitlines()]
    old = json.loads(oracle.read_text())["cl"]

    def places(records):
        return [p for r in records if "points" in r for p in r["points"]]

    def posts(records):
        return [[r["word"], r["text"].strip() if "text" in r else r.get("args", [])] for r in records if r["kind"] == "POST"]
    if code:
        return f"| {path.name} | none, {len(places(old))} | | none, {len(posts(old))} | {why or 'NOT EXPLAINED'} |"
    ends = [p[-1][:3] for p in (places(mine), places(old)) if p]
    apart = math.dist(*ends) if len(ends) == 2 else 0.0
    same = near(posts(mine), posts(old))
    agree = len(places(mine)) == len(places(old)) and apart < 1e-6 and same
    counts = f"{len(places(mine))}" if len(places(mine)) == len(places(old)) else f"{len(places(mine))}, {len(places(old))}"
    words = f"{len(posts(mine))}" if same else f"{len(posts(mine))}, {len(posts(old))}"
    end = "no place" if not ends else "the same" if apart < 1e-6 else f"{apart:.2g} apart"
    return f"| {path.name} | {counts} | {end} | {words} | {why if not agree else ''}{'' if agree or why else 'NOT EXPLAINED'} |"


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
        if path == max((CORPUS / folder).iterdir()):
            lines.append("")
        if path == max((CORPUS / folder).iterdir()) and folder == "aptos-apt360":
            lines += ["### Against the old system", "",
                      "What arelem writes beside what the old system wrote: places of the path, how far apart the last ones are, words for the "
                      "machine; two numbers where they differ, arelem's first. Stops and deviations all along the paths are compared by "
                      "`./dev test differential` ([differences](../differences-motion.md)).", "",
                      "| file | places | last place | words | why they differ |", "|---|---|---|---|---|"]
            lines += [against_the_old_system(p) for p in sorted((CORPUS / folder).iterdir())] + [""]
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
