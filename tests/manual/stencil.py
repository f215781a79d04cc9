#!/usr/bin/env python3
"""Writes what the manual shows of roadway letters: the page of the alphabet and the pictures of stencils.

  stencil.py --arelem build/arelem            fails if the page is stale
  stencil.py --arelem build/arelem --write    writes page and pictures

The page is docs/manual/roadway_alphabet.md: how evenly each symbol is painted, as `arelem alphabet` prints it, and how much
paint words take. The pictures come from the examples.
"""
import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

PROJECT = pathlib.Path(__file__).resolve().parents[2]
PAGE = PROJECT / "docs" / "manual" / "roadway_alphabet.md"
PICTURES = PROJECT / "docs" / "pictures"
EXAMPLES = PROJECT / "examples"
RULES = ("OFF", "TRAPZ", "QUADR", "BEST")

# Square feet of words 8 ft tall that a state's standard sheet of pavement markings gives (see the page for what that is worth).
SHEET = {"AHEAD": 31, "CLEAR": 27, "FWY": 16, "KEEP": 24, "LANE": 24, "LEFT": 19, "NO": 14, "ONLY": 22, "RIGHT": 26, "SCHOOL": 35,
         "SIGNAL": 32, "STOP": 22, "TURN": 24, "XING": 21, "YIELD": 24}

HEAD = """<!-- Made by tests/manual/stencil.py: ./dev manual writes it again. -->
# The roadway alphabet

`roadway.alphabet` has the capitals, the digits, the hyphen and three arrows, made of five primitives on a grid of 4 by 25.

![The symbols of roadway.alphabet](../pictures/roadway_alphabet.svg)

As on the road:

![The symbols as they are painted](../pictures/roadway_plain.svg)

"""

PROPORTIONS = """## Proportions
The source names the standard that the letters follow: the US Department of Transportation's *Standard Alphabets for Highway Signs
and Pavement Markings* (1977; since 2002 the chapter on pavement markings of *Standard Highway Signs*). Its letters are 8 ft tall or
more, on a grid of 4 units by 25. What is known here of its proportions, and what ours are:

| | standard | roadway.alphabet |
|---|---|---|
| height to width of a letter | 25 to 4 | 25 to 4; but `I` is 1 wide, `1` 2, `-` 3, the turning arrows 5 |
| upright stroke | 1 unit, 4 in | 1 unit; 97.6 mm (3.84 in) in letters of 2440 mm |
| lying stroke | about 4 units | 4 units, 3.5 the middle bars of E, F and the bars that join |
| space between letters | 1 unit or more | 1 unit |

The sheets themselves were not at hand. As a check, here is how much paint words take: a state's
standard sheet (California's A24 series) lists the square feet of its words, as remembered, not as read; ours are the sums of the areas
in the table below for a grid unit of 4 in. They agree within {worst:.0f} %.

| word | sheet, ft2 | ours | | word | sheet, ft2 | ours |
|---|---|---|---|---|---|---|
"""

FILM_HEAD = """
## How evenly each symbol is painted
Smallest and largest film over the mean, in ten strips of each cell, by each rule of TILT, for a fan of 63.5 degrees, letters 2440 mm
tall and 600 mm/s over a grid unit; `arelem alphabet` prints it for your gun. Area in grid units, paint that lies twice counted twice.

| symbol | strokes | cells | area | OFF | TRAPZ | QUADR | BEST |
|---|---|---|---|---|---|---|---|
"""

FILM_FOOT = """
A straight stroke is even by every rule. In a bend the outer edge is longer than the inner one: with lean = (outer - inner) /
(outer + inner), taken across the cell, a gun that stands upright lays films of 1 / (1 - lean) and 1 / (1 + lean) at the edges. A
tilted one lays m / ((s + m (1 - s))^2 (1 + lean (2 s - 1))) at the share s of its line, with m of the tilt; the best m leaves a
departure of about 0.4 lean^2. `TILT, BEST` moves the lines until all cells of a run lean alike, so what is left is the run's own:
its two edges have the lengths that they have. The rings of the 8 are the tightest: their outer edge is {ratio:.1f} times as long as the
inner one.

Paint lies twice where strokes cover each other: the middle bars of B, 3 and 8 and the tail of Q. It is not in these numbers; the
`.png` of `arelem stencil --film` shows it.
"""


def run(arelem, *words):
    done = subprocess.run([arelem, *map(str, words)], capture_output=True, text=True, cwd=PROJECT)
    if done.returncode != 0:
        sys.exit(f"arelem {' '.join(map(str, words))}: {done.stderr}")
    return done.stdout


def symbols(arelem):
    """Rows of `arelem alphabet`: name, strokes, cells, area, then least and most by each rule."""
    rows = [line.split() for line in run(arelem, "alphabet").splitlines()]
    return [row for row in rows if len(row) == 4 + 2 * len(RULES) and row[0] != "symbol"]


def page(arelem):
    rows = symbols(arelem)
    areas = {row[0]: float(row[3]) for row in rows}
    square_feet = {word: sum(areas[c] for c in word) / 9 for word in SHEET}  # 4 in by 4 in is 1/9 ft2
    worst = max(abs(square_feet[word] / SHEET[word] - 1) for word in SHEET) * 100
    text = HEAD + PROPORTIONS.replace("{worst:.0f}", f"{worst:.0f}")
    words = sorted(SHEET)
    half = (len(words) + 1) // 2
    for i in range(half):
        cells = []
        for word in (words[i], words[half + i] if half + i < len(words) else None):
            cells += ["", "", ""] if word is None else [word, str(SHEET[word]), f"{square_feet[word]:.1f}"]
        text += "| " + " | ".join(cells[:3]) + " | | " + " | ".join(cells[3:]) + " |\n"
    text += FILM_HEAD
    for row in rows:
        films = " | ".join(f"{row[4 + 2 * i]} {row[5 + 2 * i]}" for i in range(len(RULES)))
        name = f"`{row[0]}`" if row[0].startswith("<") else row[0]
        text += f"| {name} | {row[1]} | {row[2]} | {row[3]} | {films} |\n"
    return text + FILM_FOOT.replace("{ratio:.1f}", f"{ring_ratio():.1f}")


def ring_ratio():
    """Edges of the 8's ring: four hooks and the sides between them, from the file of the alphabet."""
    import math

    def length(f, n=4000):
        points = [f(i / n) for i in range(n + 1)]
        return sum(math.dist(a, b) for a, b in zip(points, points[1:]))

    text = (PROJECT / "stdlib" / "roadway.alphabet").read_text()
    second = re.search(r"PRIMITIVE 2 .*\n.*\nSECOND SPLINE (\S+) (\S+) (\S+) (\S+)", text).groups()
    p = [tuple(map(float, q.split(","))) for q in second]

    def spline(t):
        w = (-t**3 + 2 * t**2 - t, t**3 - 2 * t**2 + 1, -t**3 + t**2 + t, t**3 - t**2)
        return tuple(sum(w[i] * p[i][k] for i in range(4)) for k in (0, 1))

    hook_out = length(spline)
    hook_in = length(lambda t: (2 + math.cos(t * math.pi / 2), 19 + 2 * math.sin(t * math.pi / 2))) + 1
    sides = re.findall(r"STROKE 4 (\S+) (\S+) TO (\S+) (\S+) ", text.split("SYMBOL 8")[1].split("SYMBOL 9")[0])[:2]
    side_out = side_in = 0.0
    for a, b, c, d in sides:
        q = [tuple(map(float, x.split(","))) for x in (a, b, c, d)]
        lengths = sorted((math.dist(q[0], q[2]), math.dist(q[1], q[3])))
        side_in += lengths[0]
        side_out += lengths[1]
    return (4 * hook_out + side_out) / (4 * hook_in + side_in)


def write_pictures(arelem):
    run(arelem, "alphabet", "-o", PICTURES / "roadway_alphabet.svg")
    run(arelem, "alphabet", "--plain", "-o", PICTURES / "roadway_plain.svg")
    run(arelem, "alphabet", "--pens", "--plain", "-o", PICTURES / "roadway_pens.svg")
    for name in ("stop", "ahead", "right_turn"):
        run(arelem, "stencil", EXAMPLES / f"{name}.apt", "--film", PICTURES / f"{name}_film.svg")
    run(arelem, "stencil", EXAMPLES / "school_xing.apt", "--film", PICTURES / "school_xing_film.svg")
    with tempfile.TemporaryDirectory() as folder:
        letter = pathlib.Path(folder) / "letter.apt"
        text = "UNITS/MM\nSTENCL/'{}',HEIGHT,2440,FAN,63.5,SPEED,600,TILT,{}\nFINI\n"
        letter.write_text(text.format("S", "BEST"))
        run(arelem, letter, "--to", "joint-plots", "-o", PICTURES / "s_joints.svg", "--machine", "stencil_robot.machine.toml")
        for rule in RULES:
            letter.write_text(text.format("P", rule))
            name = rule.lower()
            run(arelem, "stencil", letter, "--film", PICTURES / f"p_{name}.svg", "--shares", PICTURES / f"p_shares_{name}.svg")
    run(arelem, EXAMPLES / "name_plate.apt", "-o", PICTURES / "name_plate.svg")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--arelem", default=str(PROJECT / "build" / "arelem"), type=os.path.abspath)
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    wanted = page(options.arelem)
    if options.write:
        PAGE.write_text(wanted)
        write_pictures(options.arelem)
    elif not PAGE.exists() or PAGE.read_text() != wanted:
        sys.exit(f"{PAGE.relative_to(PROJECT)} is stale: `./dev manual` writes it again")
    print("the page of the roadway alphabet is as the compiler has it")


if __name__ == "__main__":
    main()
