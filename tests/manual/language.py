#!/usr/bin/env python3
"""Writes the language reference, docs/manual/language, from the tables that the compiler is made of.

  language.py --arelem build/arelem            fails if the pages are stale
  language.py --arelem build/arelem --write    writes them

The tables come from `arelem language --json`, the examples are the golden programs of tests/golden/reference, one an id,
and the results are what `arelem geometry` prints for them. ambiguities.md is written by hand; its links to tests are
checked here.
"""
import argparse
import json
import os
import pathlib
import re
import subprocess
import sys

PROJECT = pathlib.Path(__file__).resolve().parents[2]
PAGES = PROJECT / "docs" / "manual" / "language"
EXAMPLES = PROJECT / "tests" / "golden" / "reference"
GENERATED = "<!-- Made by tests/manual/language.py from the compiler's tables: ./dev manual writes it again. -->"

# The canonical numbers of each type; the counts are checked against the results.
CANON = {
    "POINT": "x y z",
    "LINE": "a b 0 d of the vertical plane a x + b y = d, a b a unit normal",
    "PLANE": "a b c d of a x + b y + c z = d, a b c a unit normal",
    "CIRCLE": "x y 0, the axis 0 0 1, r: a vertical cylinder",
    "CYLNDR": "x y z of a point of the axis, unit axis i j k, r",
    "ELLIPS": "a b c d f g h p q r of a x^2 + b y^2 + c z^2 + d + 2 f y z + 2 g x z + 2 h x y + 2 p x + 2 q y + 2 r z = 0",
    "HYPERB": "as ELLIPS", "GCONIC": "as ELLIPS", "LCONIC": "as ELLIPS", "QADRIC": "as ELLIPS",
    "CONE": "x y z of the vertex, unit axis i j k into the nappe, cosine of the half angle",
    "VECTOR": "i j k, not normalized",
    "MATRIX": "twelve coefficients by rows; a point p becomes A p + t, t in the last column",
    "SPHERE": "x y z of the center, r",
    "TABCYL": "n intervals, k values behind k, the 3 x 3 matrix of the controlling plane, then u v a b length max min an "
              "interval and the last u v; the first and last interval are straight. u v are x y with NOZ, y z with NOX, z x with NOY",
    "POLCON": "jroots, m1 to m12, t, cb, pb, then of each of A B C D L H P the coefficients of d^0 to d^7, then of each that of "
              "the square root of d",
    "RLDSRF": "sub-forms one after another, each with its type code and count",
    "PATERN": "x y z of each point",
    "TORUS": "x y z of the center, unit axis i j k, radius of the center circle, radius of the tube",
    "GUN": "kind (1 ELLIPS, 2 CONE, 3 FAN, 4 CALIB, 5 TABLE), half axes along and across, stand-off (mm), flow (l/min), "
           "efficiency, speed (mm/s), output, lead on and off (s), half angle (degrees), c0, c1; of a table place and density "
           "of each point",
    "REGION": "unit normal i j k, number of boundaries, then of each the number of corners and their x y z; holes run clockwise",
    "REVOLV": "x y z and unit direction i j k of the axis, first and last angle (degrees), then the numbers of the TABCYL",
    "MESH": "numbers of vertices and of triangles, x y z of each vertex, three vertex numbers (from 1) of each triangle",
    "BSPLIN": "0 (open) or 1 (closed), number m of control points, the different knots, x y z of each control point (closed: from "
              "the last one on)",
    "TYPE": "those of the type",
}
ABOUT = {
    "LINE": "A LINE is a vertical plane. LEFT and RIGHT are seen in the direction from the first entity to the second.",
    "CIRCLE": "A CIRCLE is a vertical cylinder; z of its points is ignored. XLARGE and its kin speak of the new center.",
    "PLANE": "A LINE may stand wherever the syntax says plane.",
    "MATRIX": "In a product the right factor acts first. Only a rotation beside TRANSL reads in time order.",
    "GUN": "A spray gun at its distance from the work. Lengths are in the unit of the program, process quantities as written "
           "here. [Spray painting](../spray.md) tells what it is for.",
    "REGION": "What is painted, in one plane. Boundaries close by themselves, must not cross or touch, and lie in each other: "
              "a HOLE in an outline, an ISLAND in a hole or outside. [Spray painting](../spray.md).",
    "POLCON": "A polyconic: conics in the planes x = cb + pb d, 0 <= d <= 1. The conic of d begins at (y, z) = (L, H) in the "
              "direction (C, B) and ends at (L + A + C, H + B + D) in the direction (A, D); (L + C, H + B) is where these two tangents meet. "
              "P says how full it is: its tangent parallel to the chord touches it at P of the way from the first tangent's "
              "start to its end, as L + A (1 - P) + C P. P lies between 1/2 and 1: at 0.75 there is a parabola, and 0.70710678 between "
              "perpendicular tangents of the same length is a quarter of a circle. Each of the seven is k0 + k1 d + ... + k7 d^7 + k sqrt(d). "
              "jroots is 1 without square roots, else 2: then both signs of the root belong to the surface. The matrix (by rows, the shift in every "
              "fourth place; twelve zeros: none) turns the part into the system of the conics. What the tool meets lies at t from the "
              "conics, on the side of the normal: the direction of the conic times the direction of growing d. Beyond its ends a conic "
              "goes on along its tangents, and the functions along theirs. Drive, part and check surface as any other; the cut vectors "
              "are proven, but for the tip of a nose, where the normal's direction is not bounded. The example is a quarter of the cylinder of "
              "radius 5 about the x axis.",
    "REVOLV": "A surface of revolution, for SPRAY. Angles count from the curve's own place.",
    "MESH": "Triangles whose normals, by the order of their corners, stand on the positive side. Drive, part and check surface as "
            "any other; each edge belongs to one triangle or two. Triangles without an area are left out. Cut vectors "
            "are proven over all triangles below them. Lengths are in the unit of the program.",
    "BSPLIN": "A cubic B-spline that a tool follows with GOTO/spline. Open ones begin and end in their end points, closed ones go "
              "round; curvature is continuous. [Smooth paths](../smoothing.md).",
    "TYPE": "Canonical input for every type, and copies with some numbers replaced.",
}
CLASSES = {
    "fixedField": "texts", "arelemValue": "motion parameters", "arelemSwitch": "motion switches",
    "geometry": "types", "function": "functions", "modifier": "modifiers", "motion": "motion", "toolPosition": "tool positions",
    "postWithParameters": "post-processor words with parameters", "postWithoutParameters": "post-processor words alone",
    "transformation": "transformations of the output", "runControl": "run control", "unused": "reserved without a use",
}


def public(identifier):
    return "-".join(identifier.split("_")[:2])


def read_tables(arelem):
    return json.loads(subprocess.run([arelem, "language", "--json"], capture_output=True, text=True, check=True).stdout)


def example_path(identifier, defines=False):
    """The program of an id; where one is refused and one runs, `defines` picks the one that runs."""
    name = public(identifier).lower().replace("-", "_") + ".apt"
    fails, runs = EXAMPLES / ("fail_" + name), EXAMPLES / name
    return fails if fails.exists() and not (defines and runs.exists()) else runs


def example(arelem, identifier, defines=False):
    """The fenced program of a form and the table of what it defines."""
    path = example_path(identifier, defines)
    if not path.exists():
        sys.exit(f"{public(identifier)}: there is no example {path.relative_to(PROJECT)}")
    lines = []
    for line in path.read_text().splitlines():
        if re.match(r"\$\$ (RUN|CHECK|CHECK-NOT|CHECK-NEXT|VALUES):", line):
            continue
        lines.append(re.sub(r"\s*\$\$ (warning|error)\[.*", "", line))
    fails = path.name.startswith("fail_")
    text = ["```text" if fails else "```apt", *lines, "```"]
    names = [line.split()[2] for line in path.read_text().splitlines() if line.startswith("$$ VALUES:")]
    done = subprocess.run([arelem, "geometry", "--json", str(path)], capture_output=True, text=True, timeout=60)
    rows = []
    for entry in json.loads(done.stdout) if not fails else []:
        name = entry["name"] + (f"({entry['subscript']})" if entry["subscript"] else "")
        if name in names or (not names and entry["type"] not in ("POINT", "PLANE", "VECTOR", "SCALAR")):
            shown = " ".join(f"{v:.10g}" for v in entry["values"][:24])
            rows.append(f"| {name} | {entry['type']} | {shown}{' ...' if len(entry['values']) > 24 else ''} |")
    if rows:
        text += ["", "| name | type | canonical numbers |", "|---|---|---|", *rows]
    return text


def noun_page(arelem, noun, rows):
    text = [GENERATED, "", f"# {noun}", ""]
    if noun in ABOUT:
        text += [ABOUT[noun], ""]
    text += [f"Canonical numbers: {CANON[noun]}.", ""]
    done = set()
    for row in rows:
        text += [f"## {row['id'].replace('_', '-')}", "", f"`{noun}/ {row['pattern']}`", "", row["meaning"] + ".", ""]
        if public(row["id"]) not in done:
            text += [*example(arelem, row["id"], defines=True), ""]
        done.add(public(row["id"]))
    return "\n".join(text)


def statements_page(arelem, features):
    text = [GENERATED, "", "# Statements and rules", "",
            "Motion and post-processor statements are not on this page. An example that is refused is in a block without color.", ""]
    group = None
    for row in features:
        if row["group"] != group:
            group = row["group"]
            text += [f"## {group}", ""]
        text += [f"### {public(row['id'])}", "", f"`{row['syntax']}`", "", row["meaning"] + ".", "",
                 *example(arelem, row["id"]), ""]
    return "\n".join(text)


def words_page(words):
    text = [GENERATED, "", "# Words", "",
            "Words are reserved: no name may be one. Those marked * came with later systems and yield to a name that the "
            "program defines. The number is the code in CL records; a modifier is stored as that number.", ""]
    groups = {}
    for row in words:
        groups.setdefault(CLASSES.get(row["class"], "other statements"), []).append(row)
    for name in sorted(groups):
        text += [f"## {name[0].upper() + name[1:]}", ""]
        shown = [f"{r['word']}{'*' if r['extension'] else ''}" + (f" ({r['code']})" if r["code"] != "0" else "")
                 for r in sorted(groups[name], key=lambda r: r["word"])]
        text += [", ".join(shown) + ".", ""]
    return "\n".join(text)


def post_words_page(tables):
    """Section 5: what each word for the machine takes, and the code profiles."""
    text = [GENERATED, "", "# Words for the machine", "",
            "Each is passed on unchanged to CL text, CL tapes and JSON, wherever it stands. A parameter is a number, a name or an "
            "expression in parentheses, or one of the words listed; CLEARP and CLRSRF take surfaces, TRACUT and COPY matrices. "
            "Another word is the warning [W0583](../diagnostics/W0583.md), another count of numbers "
            "[W0584](../diagnostics/W0584.md), and both are passed on: a postprocessor may have its own meaning. In other "
            "dialects than `cl` a name that is no word is [W0204](../diagnostics/W0204.md).", "",
            "*Acts*: outputs, times or the reading of places act on it, and `arelem check FILE --words` calls it understood. The others "
            "are for a postprocessor alone. *Code*: the number on a CL tape; `--codes apt4` and files of your own change it "
            "([profiles](../cl-files.md#numbers-of-words-on-tapes)).", "",
            "| word | code | form | numbers | words that it takes | acts | meaning |", "|---|---|---|---|---|---|---|"]
    for row in sorted(tables["postWords"], key=lambda r: r["word"]):
        bare = row["form"] == row["word"]
        count = row["least"] if row["least"] == row["most"] else f"{row['least']} to {row['most']}"
        words = {"": "none", "*": "any"}.get(row["words"], row["words"])
        form = row["word"] if bare else f"{row['word']} [/ {row['form']}]" if row["bare"] else f"{row['word']}/ {row['form']}"
        form = form.replace("|", "\\|")
        text.append(f"| {row['word']} | {row['code']} | `{form}` | {count} | {words} | {row['acts'] or 'no'} | {row['meaning']} |")
    rest = [r["word"] for r in tables["words"] if r["class"].startswith("post") and r["word"] not in {p["word"] for p in tables["postWords"]}]
    text += ["", "Without parameters, for a postprocessor alone: " + ", ".join(sorted(rest)) + ".", "",
             "Texts go with PARTNO, PPRINT and INSERT: [statements](statements.md#lx-09)."]
    return "\n".join(text) + "\n"


LATER = ["", "Both kinds of blocks nest, and may stand in LOOPST, in macros and outside of both.", "",
         "```apt", "N=0", "M=0", "DO/I=10,2,-2", "IF(I .GT. 6 .OR. I .EQ. 2) THEN", "N=N+1", "ELSE", "M=M+I", "ENDIF", "ENDDO", "FINI", "```", "",
         "| name | type | canonical numbers |", "|---|---|---|", "| N | SCALAR | 3 |", "| M | SCALAR | 10 |"]


def dialects_page(tables):
    names = ["auto", "apt360", "apt4", "cl", "native"]
    text = [GENERATED, "", "# Dialects", "",
            "`--dialect NAME` says how a text is read. `auto`, the default, takes what programs of all times need and "
            "warns of what APT360 would refuse; CL text of a CAM system it recognizes (below) and reads as `cl`. The "
            "report of a run (`--report`) names the dialect. All that differs:", "",
            "| what | " + " | ".join(names) + " |", "|---|" + "---|" * len(names)]
    text += [f"| {row['what']} | " + " | ".join(row[n] for n in names) + " |" for row in tables["dialects"]]
    text += ["", "In `apt360` two statements also do what they did there: TLLFT and TLRGT with the tool end on a line go along it "
             "([W0511](../diagnostics/W0511.md); else [E0505](../diagnostics/E0505.md)), and OBTAIN of an entity of another reference "
             "system gives its numbers as the one in force sees them ([A-14](ambiguities.md))."]
    text += ["", "## What tells CL text", "",
             "A line that begins like this (blanks do not count), with no `name =` before it:", "",
             "| begin | written by |", "|---|---|"]
    text += [f"| `{row['begin']}` | {row['writer']} |" for row in tables["clMarks"]]
    text += ["", "## Blocks of later systems", "", "| statement | meaning |", "|---|---|"]
    text += [f"| `{row['syntax']}` | {row['meaning']} |" for row in tables["blocks"]]
    return "\n".join(text + LATER) + "\n"


def limits_page(limits):
    text = [GENERATED, "", "# Limits", "", "Reaching one is an error that names the flag, with exit code 7; nothing is written.", "",
            "| flag | default | bounds |", "|---|---|---|"]
    return "\n".join(text + [f"| `{r['flag']} N` | {r['default']} | {r['what']} |" for r in limits]) + "\n"


def index_page(nouns, tables):
    text = [GENERATED, "", "# The language", "",
            "A statement is `name = TYPE/ parameters` (a definition), `name = expression`, or `WORD/ parameters`. In syntax "
            "lines WORD is written as it stands, lower case is a value: the name of an entity or a definition in "
            "parentheses for `point`, `line`, ...; else a number, a name or an expression in parentheses. `{a | b}` is one "
            "of several, `[a]` may be absent, `a ...` stands once or more. Angles are degrees.", "",
            "`arelem language CIRCLE` prints the forms of a type.", "",
            "* [Statements and rules](statements.md): lines, computing, arrays, control, listing, run control",
            "* [Words for the machine](post-words.md): what each takes, and which of them act", "* [Dialects](dialects.md) · [limits](limits.md) · [words](words.md) · [ambiguities decided](ambiguities.md)", "",
            "| type | forms | canonical numbers |", "|---|---|---|"]
    for noun, rows in nouns.items():
        text.append(f"| [{noun}]({noun.lower()}.md) | {len({public(r['id']) for r in rows})} | {CANON[noun]} |")
    count = len({public(r["id"]) for rows in nouns.values() for r in rows})
    return "\n".join(text + ["", f"{count} forms, {len(tables['features'])} statements and rules; each has an example that "
                                 "the tests run."]) + "\n"


def pages(arelem):
    tables = read_tables(arelem)
    nouns = {}
    for row in tables["forms"]:
        nouns.setdefault(row["noun"], []).append(row)
    result = {"README.md": index_page(nouns, tables), "statements.md": statements_page(arelem, tables["features"]),
              "words.md": words_page(tables["words"]), "dialects.md": dialects_page(tables),
              "limits.md": limits_page(tables["limits"]), "post-words.md": post_words_page(tables)}
    for noun, rows in nouns.items():
        result[noun.lower() + ".md"] = noun_page(arelem, noun, rows)
    return result


def check_ambiguities():
    """Each decision A-01 to A-26 names a test that exists."""
    text = (PAGES / "ambiguities.md").read_text()
    problems = [f"ambiguities.md: A-{n:02} is missing" for n in range(1, 27) if f"| A-{n:02} |" not in text]
    sources = {}
    for line in text.splitlines():
        if not line.startswith("| A-"):
            continue
        tests = re.findall(r"`(tests/[^` ]+)(?: ([\w.]+))?`", line)
        if not tests:
            problems.append(f"ambiguities.md: {line[:6]} names no test")
        for path, name in tests:
            file = PROJECT / path
            if not file.exists():
                problems.append(f"ambiguities.md: there is no {path}")
            elif name:
                body = sources.setdefault(path, file.read_text())
                suite, _, test = name.partition(".")
                if not re.search(rf"TEST(_F|_P)?\(\s*{suite},\s*{test}\)", body):
                    problems.append(f"ambiguities.md: there is no {name} in {path}")
    return problems


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--arelem", default=str(PROJECT / "build" / "arelem"), type=os.path.abspath)
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    problems, wanted = [], pages(options.arelem)
    PAGES.mkdir(exist_ok=True)
    for name, text in wanted.items():
        page, text = PAGES / name, text.rstrip("\n") + "\n"
        if options.write:
            page.write_text(text)
        elif not page.exists() or page.read_text() != text:
            problems.append(f"docs/manual/language/{name} is stale: `./dev manual` writes it again")
    problems += [f"docs/manual/language/{p.name}: no table makes it" for p in PAGES.glob("*.md")
                 if p.name not in wanted and p.name != "ambiguities.md"]
    problems += check_ambiguities()
    print("\n".join(problems))
    print(f"{len(wanted)} pages of the language, {len(problems)} problems")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
