#!/usr/bin/env python3
"""The page docs/manual/motion-words.md: for every word and form of motion the golden programs that use it, whose numbers a pencil
gives. Fails for a word without a program and for a page that is not what --write would make; see `./dev manual`."""
import argparse
import pathlib
import re
import sys

PROJECT = pathlib.Path(__file__).resolve().parents[2]
PROGRAMS = PROJECT / "tests" / "golden" / "motion"
PAGE = PROJECT / "docs" / "manual" / "motion-words.md"
DRIVE = r"GO(FWD|BACK|LFT|RGT|UP|DOWN)/\w+"
# What is to be shown, and what a statement that shows it looks like.
WORDS = [
    ("startup with one surface", r"^GO/((TO|ON|PAST),)?\w+$"),
    ("startup with two surfaces", r"^GO/(TO|ON|PAST),\w+,(TO|ON|PAST),\w+$"),
    ("startup with three surfaces", r"^GO/(TO|ON|PAST),\w+,(TO|ON|PAST),\w+,(TO|ON|PAST),"),
    ("startup TO", r"^GO/TO,"), ("startup ON", r"^GO/ON,"), ("startup PAST", r"^GO/PAST,"),
    ("INDIRV", r"^INDIRV/"), ("INDIRV for several surfaces", r"^INDIRV/.*VECTOR.*VECTOR"), ("INDIRP", r"^INDIRP/"),
    ("SRFVCT", r"^SRFVCT/"), ("OFFSET", r"^OFFSET/"), ("NOPS", r"^NOPS"), ("AUTOPS", r"^AUTOPS"), ("PSIS", r"^PSIS/"),
    ("TLLFT", "TLLFT"), ("TLRGT", "TLRGT"), ("TLON", "TLON,"), ("TLNDON", "TLNDON"), ("TLONPS", "TLONPS"),
    ("TLOFPS", "TLOFPS"),
    ("GOFWD", "GOFWD"), ("GOBACK", "GOBACK"), ("GOLFT", "GOLFT"), ("GORGT", "GORGT"), ("GOUP", "GOUP"), ("GODOWN", "GODOWN"),
    ("the 2 degrees of a direction word", r"error\[E0507\]"),
    ("stop TO", DRIVE + ",TO,"), ("stop ON", DRIVE + ",ON,"), ("stop PAST", DRIVE + ",PAST,"),
    ("TANTO", DRIVE + ",TANTO,"), ("DSTAN", DRIVE + ",DSTAN,"), ("PSTAN", DRIVE + ",PSTAN,"),
    ("n,INTOF", r",\d,INTOF,"), ("implied check surface", DRIVE + "$"), ("check surfaces with labels", r",ID1,TO,\w+,ID2"),
    ("TRANTO", r"^TRANTO/"), ("DNTCUT and CUT", r"^DNTCUT"), ("THICK per surface", r"^THICK/[^,]+,[^,]+,"),
    ("INTOL per surface", r"^INTOL/[^,]+,[^,]+,"), ("OUTTOL per surface", r"^OUTTOL/[^,]+,[^,]+,"), ("TOLER", r"^TOLER/"),
    ("MAXDP", r"^MAXDP/"), ("NUMPTS", r"^NUMPTS/"), ("GOUGCK", r"^GOUGCK/"), ("MULTAX", r"^MULTAX"),
    ("POCKET", r"^POCKET/"),
    ("TLAXIS with a vector", r"^TLAXIS/V1"), ("TLAXIS with numbers", r"^TLAXIS/[\d.]+,[\d.]+,"), ("TLAXIS/1", r"^TLAXIS/1$"),
    ("TLAXIS/NORMPS", "TLAXIS/NORMPS"), ("TLAXIS/NORMDS", "TLAXIS/NORMDS"), ("TLAXIS/PARLEL,1", "TLAXIS/PARLEL,1"),
    ("TLAXIS/PARLEL,2", "TLAXIS/PARLEL,2"), ("TLAXIS/ATANGL,1", r"TLAXIS/ATANGL,1,[-\d.]+$"),
    ("TLAXIS/ATANGL,2", r"TLAXIS/ATANGL,2,[-\d.]+$"), ("lead angle", r"TLAXIS/ATANGL,.*CUTANG,\d"),
    ("lag angle", r"TLAXIS/ATANGL,.*CUTANG,-"), ("four axes", r"TLAXIS/ATANGL,.*VECTOR"),
]


def statements(path):
    """Lines without comments, but for the errors that they must have; without blanks."""
    for line in path.read_text().splitlines():
        code, _, comment = line.partition("$$")
        expected = re.search(r"error\[E\d+\]", comment)
        yield re.sub(r"\s+", "", code) if not expected or not code.strip() else expected[0]
        yield re.sub(r"\s+", "", code)


def page():
    programs = {path.stem: list(statements(path)) for path in sorted(PROGRAMS.glob("*.apt"))}
    rows, missing = [], []
    for word, pattern in WORDS:
        using = [name for name, lines in programs.items() if any(re.search(pattern, line) for line in lines)]
        if not using:
            missing.append(word)
        links = ", ".join(f"[{name}](../../tests/golden/motion/{name}.apt)" for name in using[:4])
        rows.append(f"| {word} | {links} |")
    text = ["<!-- Made by tests/manual/motion_words.py: ./dev manual writes it again. -->", "",
            "# Which program shows which word of motion", "",
            "The numbers in the comments of each program are what a pencil gives; `tests/golden/run.py` compares them with the output of",
            "every build. [Motion along surfaces](motion.md) tells what the words mean.", "",
            "| word or form | programs |", "|---|---|", *rows, ""]
    return "\n".join(text), missing


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    text, missing = page()
    for word in missing:
        print(f"no golden program of tests/golden/motion shows: {word}")
    if options.write:
        PAGE.write_text(text)
    elif not PAGE.exists() or PAGE.read_text() != text:
        print(f"{PAGE.relative_to(PROJECT)} is not what ./dev manual writes")
        return 1
    print(f"{len(WORDS)} words and forms, {len(missing)} without a program")
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
