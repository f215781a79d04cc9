#!/usr/bin/env python3
"""Makes docs/manual/library.md of the heads of stdlib/*.apt, with a picture of each example, and compares them (--write: writes)."""
import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

PROJECT = pathlib.Path(__file__).resolve().parents[2]
PAGE = PROJECT / "docs" / "manual" / "library.md"
PICTURES = PROJECT / "docs" / "pictures"
ORDER = ("BOLTC", "HGRID", "FACMIL", "RPOCK", "CPOCK", "SLOTP", "CONPAS", "CHMCON", "FILCON", "THRMIL", "STRTUP", "TLEND")
# What stands before the example of a head, so that it is a program.
BEFORE = {
    "BOLTC": ["UNITS/MM", "CUTTER/8", "SPINDL/900,RPM,CLW", "P0=POINT/0,0,0", "FROM/0,0,15"],
    "HGRID": ["UNITS/MM", "CUTTER/8", "SPINDL/900,RPM,CLW", "P0=POINT/0,0,0", "FROM/-20,-20,15"],
    "FACMIL": ["UNITS/MM", "CUTTER/50", "FROM/-50,-50,15"],
    "RPOCK": ["UNITS/MM", "CUTTER/10", "FROM/0,0,15"],
    "CPOCK": ["UNITS/MM", "CUTTER/10", "P0=POINT/40,30,0", "FROM/0,0,15"],
    "SLOTP": ["UNITS/MM", "CUTTER/10", "P1=POINT/10,10,0", "P2=POINT/60,40,0", "FROM/0,0,15"],
    "CONPAS": ["UNITS/MM", "CUTTER/10", "L1=LINE/0,0,0,50", "L2=LINE/0,50,80,50", "L3=LINE/80,50,80,0", "L4=LINE/80,0,0,0",
               "CONPS=PLANE/0,0,1,0", "OUTLN=MACRO/", "RAPID", "GOTO/-30,-30,5", "GO/TO,L1,TO,CONPS,PAST,L4", "INDIRV/0,1,0",
               "TLLFT,GOFWD/L1,PAST,L2", "GORGT/L2,PAST,L3", "GORGT/L3,PAST,L4", "GORGT/L4,PAST,L1", "RAPID", "GODLTA/0,0,20",
               "TERMAC", "FROM/-30,-30,15"],
    "CHMCON": ["UNITS/MM", "CUTTER/12", "FROM/-30,-30,15"],
    "FILCON": ["UNITS/MM", "CUTTER/12", "FROM/-30,-30,15"],
    "THRMIL": ["UNITS/MM", "CUTTER/16", "P0=POINT/20,20,0", "FROM/0,0,15"],
    "STRTUP": ["UNITS/INCHES", "SETPT=POINT/2,1,.5", "FROM/0,0,4"],
    "TLEND": ["UNITS/INCHES", "SETPT=POINT/2,1,.5", "FROM/0,0,4", "LIBRY/STRTUP", "CALL/STRTUP, TL=1, SFMIN=100, CUTR=.5, SPT=SETPT"],
}
INTRO = """# The standard library

<!-- Made by tests/manual/library.py from the heads of stdlib/*.apt: ./dev manual writes it again. -->

Macros in the language itself. `LIBRY/NAME` makes one known (`INCLUDE/'name.apt'` too), `CALL/NAME, ...` uses it. Lengths are in
the unit of the program; variables in brackets may be left out. Parameters with which a macro cannot work are an error at the CALL
that says why ([E0496](diagnostics/E0496.md)): nothing is cut wrongly. Tests cut pockets, slots and faces of many sizes and look for
stock that is left and for gouges.
"""
OWN = """## Macros of your own
A macro is a file `name.apt` in a folder of `-I`, or stands in the program. `REFUSE/'text', value, ...` says what a CALL asks
wrongly; the message has the place of the CALL:

```apt
SQUARE=MACRO/WIDTH,CUTR
IF (WIDTH .LE. CUTR) THEN
REFUSE/'WIDTH must be more than CUTR',WIDTH,CUTR
ENDIF
GOTO/(WIDTH-CUTR),0,0
GOTO/(WIDTH-CUTR),(WIDTH-CUTR),0
TERMAC
FROM/0,0,0
CALL/SQUARE, WIDTH=40, CUTR=10
FINI
```

REFUSE is followed by a text in quotes; elsewhere it is a name like any other. `--dialect apt360` has neither texts nor REFUSE.
"""


def head(name):
    """Title, form, text and example of a macro, from the comments in front of it."""
    lines = []
    for line in (PROJECT / "stdlib" / f"{name.lower()}.apt").read_text().splitlines():
        if not line.startswith("$$"):
            break
        lines.append(line[2:].rstrip())
    title = re.match(rf" {name}  (.*)", lines[0])[1]
    form, text, example = [], [], []
    for line in lines[1:]:
        if line.startswith(" Example:"):
            example.append(line[len(" Example:"):].strip())
        elif example:
            example.append(line.strip() if example[-1][-1:] != "$" else "     " + line.strip())
        elif line.startswith("   ") or (not line and not text):
            form.append(line[1:])
        else:
            text.append(line.strip())
    return title, "\n".join(form).strip("\n"), "\n".join(text).strip("\n"), example


def program(name, example):
    return "\n".join([f"PARTNO {name}", *BEFORE[name], *(example or [f"LIBRY/{name}", f"CALL/{name}"]), "FINI"]) + "\n"


def picture(arelem, name, text):
    with tempfile.TemporaryDirectory() as folder:
        source, out = pathlib.Path(folder) / "example.apt", pathlib.Path(folder) / "example.svg"
        source.write_text(text)
        done = subprocess.run([arelem, str(source), "-o", str(out)], capture_output=True, text=True)
        if done.returncode or done.stderr:
            raise SystemExit(f"the example of {name}: {done.stderr}")
        return out.read_text()


def outputs(arelem):
    """File and text of the page and of its pictures."""
    rows = [(name, *head(name)) for name in ORDER]
    lines = [INTRO, "| macro | what it does |", "|---|---|"]
    lines += [f"| [{name}](#{name.lower()}) | {title} |" for name, title, *_ in rows]
    lines += ["", "Text is cut by a statement of the language, [ENGRAV](engraving.md), since a macro takes no texts.", ""]
    result = {}
    for name, title, form, text, example in rows:
        code = program(name, example)
        shown = f"library_{name.lower()}.svg"
        drawn = name not in ("STRTUP", "TLEND")  # words for the machine, and one move
        lines += [f"## {name}", title[0].upper() + title[1:] + ".", "", "```", form, "```", ""]
        lines += [text, ""] if text else []
        lines += ["```apt motion", code.rstrip("\n"), "```", ""]
        lines += [f"![the path of this example](../pictures/{shown})", ""] if drawn else []
        text = picture(arelem, name, code)
        if drawn:
            result[PICTURES / shown] = text
    result[PAGE] = "\n".join([*lines, OWN])
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--arelem", default=str(PROJECT / "build" / "arelem"), type=os.path.abspath)
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    files = sorted(p.stem.upper() for p in (PROJECT / "stdlib").glob("*.apt"))
    problems = [] if files == sorted(ORDER) else [f"stdlib has {files}"]
    for path, text in outputs(options.arelem).items():
        if options.write:
            path.write_text(text)
        elif not path.exists() or path.read_text() != text:
            problems.append(f"{path.relative_to(PROJECT)} is stale: `./dev manual` writes it again")
    print("\n".join([*problems, f"{len(ORDER)} macros, {len(problems)} problems"]))
    return int(bool(problems))


if __name__ == "__main__":
    sys.exit(main())
