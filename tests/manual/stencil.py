#!/usr/bin/env python3
"""Writes what the manual shows of roadway letters: the page of the alphabet and the pictures of stencils.

  stencil.py --arelem build/arelem            fails if the page is stale
  stencil.py --arelem build/arelem --write    writes page and pictures

The page is docs/manual/roadway_alphabet.md: the proportions of the symbols, as `arelem stencil`
measures them, and how evenly each is painted, as `arelem alphabet` prints it. The pictures come from the examples.
"""
import argparse
import json
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

# Which primitives each letter uses, by table 2.1 of the source (Blank 1997).
SOURCE = {"A": "4,5", "B": "1,5", "C": "2,4", "D": "1,5", "E": "5", "F": "5", "G": "2,4,5", "H": "5", "I": "5", "J": "2,4,5", "K": "4,5",
          "L": "5", "M": "4,5", "N": "4,5", "O": "2,4", "P": "1,5", "Q": "2,4", "R": "1,4,5", "S": "2,3", "T": "5", "U": "2,4", "V": "4",
          "W": "4,5", "X": "4", "Y": "4,5", "Z": "4,5"}

# Why a letter of ours departs from that table.
DEPARTURES = {"J": "not J, whose stem here is one slanted stroke down to the hook"}

HEAD = """<!-- Made by tests/manual/stencil.py: ./dev manual writes it again. -->
# The roadway alphabet

`roadway.alphabet` has the capitals, the digits, the hyphen and three arrows, made of five primitives on a grid of 4 by 25.

![The symbols of roadway.alphabet](../pictures/roadway_alphabet.svg)

As on the road:

![The symbols as they are painted](../pictures/roadway_plain.svg)

"""

PROPORTIONS = """## Proportions
The letters follow the US Department of Transportation's *Standard Alphabets for Highway Signs and Pavement Markings* (1977; since 2002 the
chapter on pavement markings of *Standard Highway Signs*, with very slight differences in stroke widths of letters with loops: FHWA,
interpretation letter 3-179(I), 2005). **The sheets of the standard itself were not at hand**: no figure of ours was read from them. What is
compared is what the source says of them (R. Blank, Algorithms and Robotic Hardware Improvements for Painting of Roadway Markings,
1997, sections 2.1 and 2.3), whose edges were matched to the grids of the standard's letters:

| what | source | roadway.alphabet |
|---|---|---|
| height to width of a letter | 25 units to 4 | {common} of 26 letters; {others}. Round letters reach over top and foot by {over:.1f} % of the height together |
| least height of letters on a road | 2.44 m (8 ft) | any HEIGHT; pictures and table for 2.44 m |
| edges of the bowl, the hook and the half S | splines, arcs and lines of its appendix A | the same; S and B have all of its published places within 1e-6 (tests) |
| primitives of each letter | table 2.1 | {agree} of 26 alike; {differ} |

Widths of strokes and the spaces between letters are not in the source's text. Ours: upright strokes 1 unit wide (97.6 mm in letters of
2440 mm), lying ones 3.5 or 4 units high, so that both look alike to a driver who sees them foreshortened; 1 unit between symbols.

Measured along the painted lines of each symbol, in units of the height; 4 to 25 is 0.160. Widths are those of the fan lines of its strokes:

| symbol | width / height | narrowest line | widest line | primitives | source |
|---|---|---|---|---|---|
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

Paint lies twice where strokes cover each other: {twice}, in percent of the symbol's area. It is not in these numbers; `arelem stencil`
reports it for a text, and the `.png` of `arelem stencil --film` shows where.
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


def measured(arelem, names):
    """What `arelem stencil` measures of each symbol."""
    with tempfile.TemporaryDirectory() as folder:
        program = pathlib.Path(folder) / "all.apt"
        program.write_text("UNITS/MM\n" + "".join(f"STENCL/'{name}',HEIGHT,2500,FAN,63.5,SPEED,600\n" for name in names) + "FINI\n")
        return [one["symbols"][0] for one in json.loads(run(arelem, "stencil", program, "--json"))]


def primitives():
    """Numbers of the strokes of each symbol, from the file of the alphabet."""
    used = {}
    for line in (PROJECT / "stdlib" / "roadway.alphabet").read_text().splitlines():
        words = line.split()
        if words[:1] == ["SYMBOL"]:
            name = words[1]
        elif words[:1] == ["STROKE"]:
            used.setdefault(name, set()).add(words[1])
    return {name: ",".join(sorted(numbers)) for name, numbers in used.items()}


def proportions(rows):
    used = primitives()
    letters = [row for row in rows if row["symbol"] in SOURCE]
    common = [row for row in letters if abs(row["size"][0] / row["size"][1] / (4 / 25) - 1) < 0.025]
    others = ", ".join(f"`{row['symbol']}` is {row['size'][0] / 100:.3g} wide" for row in letters if row not in common)
    highest = max(row["size"][1] for row in letters) / 2500 - 1
    differ = [name for name in SOURCE if used[name] != SOURCE[name]]
    text = PROPORTIONS.replace("{common}", str(len(common))).replace("{others}", others)
    text = text.replace("{over:.1f}", f"{100 * highest:.1f}")
    text = text.replace("{agree}", str(26 - len(differ))).replace("{differ}", "; ".join(DEPARTURES[name] for name in differ))
    for row in rows:
        name = f"`{row['symbol']}`" if row["symbol"].startswith("<") else row["symbol"]
        wide, high = row["size"]
        lines = " | ".join(f"{line / 2500:.3f}" for line in row["lines"])
        text += f"| {name} | {wide / high:.3f} | {lines} | {used[row['symbol']]} | {SOURCE.get(row['symbol'], '')} |\n"
    return text


def page(arelem):
    rows = symbols(arelem)
    of_symbols = measured(arelem, [row[0] for row in rows])
    text = HEAD + proportions(of_symbols) + FILM_HEAD
    for row in rows:
        films = " | ".join(f"{row[4 + 2 * i]} {row[5 + 2 * i]}" for i in range(len(RULES)))
        name = f"`{row[0]}`" if row[0].startswith("<") else row[0]
        text += f"| {name} | {row[1]} | {row[2]} | {row[3]} | {films} |\n"
    twice = [f"{row['symbol']} {100 * row['paintedTwice'] / row['area']:.1f}" for row in of_symbols if row["paintedTwice"] > 1]
    return text + FILM_FOOT.replace("{ratio:.1f}", f"{ring_ratio():.1f}").replace("{twice}", ", ".join(twice))


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
