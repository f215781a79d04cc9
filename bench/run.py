#!/usr/bin/env python3
"""Whole-process speed, memory and start-up time of arelem. The figures are of the machine that runs this."""
import argparse
import math
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import time

import paths

HERE = pathlib.Path(__file__).resolve().parent
SPEED = HERE.parent / "tests" / "data" / "speed"
REPEATS = 5
ROUNDS = 5  # over all paths: what else goes on in the machine lasts longer than a case
ENOUGH = 3.0  # seconds of a case, after which it is not repeated: the whole table takes under five minutes

# Program, what it measures, what the rate counts.
CASES = [
    (HERE / "sphere_ball_1e-4.apt", "sphere, ball cutter, tolerance 1e-4", "cut vectors"),
    (SPEED / "sph_100k.apt", "sphere, ball cutter, 920 passes", "cut vectors"),
    (SPEED / "sph_bull_10k.apt", "sphere, bull-nose cutter", "cut vectors"),
    (SPEED / "qad_10k.apt", "general quadric", "cut vectors"),
    (SPEED / "tab_100k.apt", "tabulated cylinder", "cut vectors"),
    (SPEED / "circle2d_100k.apt", "circle in the plane", "cut vectors"),
    (SPEED / "goto_loop_32k.apt", "interpreted loop: GOTO, IF, SINF, COSF", "points"),
]


class Run:
    """One process: wall time, processor time, largest memory, what it told."""

    def __init__(self, words):
        with tempfile.TemporaryFile("w+") as err:
            start = time.perf_counter()
            process = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=err)
            _, status, usage = os.wait4(process.pid, 0)
            self.seconds = time.perf_counter() - start
            process.returncode = os.waitstatus_to_exitcode(status)
            err.seek(0)
            self.told = err.read()
        self.code = process.returncode
        self.processor = usage.ru_utime + usage.ru_stime
        self.megabytes = usage.ru_maxrss / 1024


def median_run(words, repeats=REPEATS):
    runs = []
    while len(runs) < repeats and sum(r.seconds for r in runs) < ENOUGH:
        runs.append(Run(words))
        if runs[-1].code != 0:
            return runs[-1]
    return sorted(runs, key=lambda r: r.seconds)[len(runs) // 2]


def least_run(words, before):
    """Another run, if that took less of the processor than the one before."""
    run = Run(words)
    return min(before, run, key=lambda r: (r.code == 0, r.processor)) if before else run


def row(what, run, count, unit, goal=None):
    """A row of the table: what was done how fast, by the clock and by processor time, which other processes disturb less."""
    if run.code != 0:
        code = re.search(r"error\[(\w+)\]", run.told)
        return (what, f"exit {run.code} {code.group(1) if code else ''}".rstrip(), "", "", "", "", "")
    return (what, f"{count} {unit}", f"{run.seconds:.3f}", f"{run.processor:.3f}", f"{count / run.processor:,.0f}",
            f"{goal:,}" if goal else "", f"{run.megabytes:.0f}")


def cut_vectors(told):
    match = re.search(r"([\d]+) cut vectors", told)
    return int(match.group(1)) if match else 0


def cl_file(path, lines):
    """A CL file as a CAM system writes it: a zigzag over a wavy surface."""
    with path.open("w") as file:
        file.write("PARTNO / BENCH\nUNITS / MM\nCUTTER / 10.0, 5.0\nFROM / 0.0, 0.0, 50.0\nFEDRAT / 800.0, MMPM\n")
        for i in range(lines):
            row, step = divmod(i, 500)
            x = (step if row % 2 == 0 else 500 - step) * 0.2
            file.write(f"GOTO / {x:.6f}, {row * 0.25:.6f}, {((i * 7919) % 10007) / 1000:.6f}\n")
        file.write("FINI\n")


def definitions(path, count):
    """Points, lines and circles that name one another, and scalars, one statement a line."""
    with path.open("w") as file:
        for i in range(count // 4):
            file.write(f"P{i}=POINT/{i % 97}.25,{i % 89}\nL{i}=LINE/P{i},ATANGL,{i % 170 + 1}\n"
                       f"C{i}=CIRCLE/CENTER,P{i},RADIUS,{i % 7 + 1}\nA{i}={i}*2+1\n")
        file.write("FINI\n")


def legacy(path, statements):
    """A part program of the old kind, ten statements a part: lines, a startup, four motions, post words, text."""
    with path.open("w") as file:
        file.write("PARTNO LEGACY\nCUTTER/.5\nINTOL/.001\nOUTTOL/.001\nFROM/-1,-1,1\n")
        for i in range(statements // 14):
            x, y = 3.0 * (i % 30), 3.0 * (i // 30 % 30)
            file.write(f"A{i}=LINE/{x},{y},{x},{y + 2}\nB{i}=LINE/{x},{y + 2},{x + 2},{y + 2}\nC{i}=CIRCLE/{x + 1},{y + 1},1.2\n"
                       f"D{i}=LINE/(POINT/{x + 2},{y}),PARLEL,A{i}\nRAPID\nGOTO/{x - .5},{y - .5},1\nFEDRAT/10,IPM\nGODLTA/0,0,-1\n"
                       f"GO/TO,A{i}\nINDIRV/0,1,0\nTLLFT,GOFWD/A{i},PAST,B{i}\nGORGT/B{i},PAST,D{i}\nPPRINT PART {i}\nGODLTA/0,0,1\n")
        file.write("FINI\n")


def growth(arelem, folder):
    """Statements a second of `check` from 1 000 to 1 000 000 definitions: linear means a level rate."""
    rows = []
    for count in (1_000, 10_000, 100_000, 1_000_000):
        source = pathlib.Path(folder) / f"definitions{count}.apt"
        definitions(source, count)
        run = median_run([arelem, "check", str(source)], 3 if count > 100_000 else REPEATS)
        rows.append(row(f"definitions, {count}", run, count, "statements"))
    return rows


def stencils(arelem, out):
    """A message of 20 letters to a CL tape by each rule of tilt: under 50 ms is the aim of the whole process."""
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for rule in ("QUADR", "BEST"):
            source = pathlib.Path(folder) / "stencil.apt"
            source.write_text((HERE / "stencil_20.apt").read_text().replace("BEST", rule))
            run = median_run([arelem, "compile", str(source), "-o", out])
            rows.append(row(f"STENCL, 20 letters, TILT {rule}", run, 20, "letters"))
    return rows


def wavy(path, corners, holes, corners_of_hole):
    """A drawing: a wavy disk of 2 m with round holes on a spiral, none of which meet."""
    def polyline(points):
        rows = ["0", "LWPOLYLINE", "8", "0", "90", str(len(points)), "70", "1"]
        for x, y in points:
            rows += ["10", repr(x), "20", repr(y)]
        return rows

    def ring(count, radius, center=(0.0, 0.0)):
        return [(center[0] + radius(t) * math.cos(t), center[1] + radius(t) * math.sin(t))
                for t in (2 * math.pi * i / count for i in range(count))]
    rows = ["0", "SECTION", "2", "ENTITIES"] + polyline(ring(corners, lambda t: 1000 + 20 * math.sin(60 * t)))
    for i in range(holes):
        away, turn = 900 * math.sqrt((i + .5) / holes), 2.399963 * i  # the golden angle: evenly spread
        rows += polyline(ring(corners_of_hole, lambda t: 15.0, (away * math.cos(turn), away * math.sin(turn))))
    path.write_text("\n".join(rows + ["0", "ENDSEC", "0", "EOF", ""]))


def sprays(arelem):
    """Searches, large regions and film maps by `arelem spray`, the whole process."""
    head = "UNITS/MM\nG1=GUN/ELLIPS,.7,1,SPEED,1000,FLOW,1,EFFIC,.65\nG2=GUN/CONE,14,STNDOF,50,SPEED,600\n"
    plate = "R1=REGION/(0,0),(1000,0),(1000,800),(0,800)\n"
    square = "G3=GUN/ELLIPS,12,12,SPEED,600\nR1=REGION/(0,0),(1000,0),(1000,1000),(0,1000)\n"
    drawing = "R1=REGION/DXF,'wavy.dxf'\nSPRAY/R1,GUN,G2,FILM,.05\n"
    cases = [
        ("SPRAY, MINCST of 16 sizes by 73 angles", 16 * 73, "trials", [], plate + "SPRAY/R1,GUN,G1,FILM,.051,OVRLAP,.175,"
         "MINCST,60,10,2,2,HEIGHT,45,75,2,ANGLE,0,360,5\n"),
        ("SPRAY, region of 10000 vertices, 200 holes", 10000, "vertices", ["--cell", "5"], drawing),
        ("the same, film as PNG with its offset curve", 10000, "vertices", ["--film", "wavy.png"], drawing),
        ("film map of 1000 by 1000 cells, 50 passes", 1_000_000, "cells", ["--cell", "1.048"], square + "SPRAY/R1,GUN,G3,FILM,.05\n"),
    ]
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        wavy(pathlib.Path(folder) / "wavy.dxf", 6000, 200, 20)
        for what, count, unit, words, text in cases:
            source = pathlib.Path(folder) / "spray.apt"
            source.write_text(head + text + "FINI\n")
            words = [str(pathlib.Path(folder) / w) if w.endswith(".png") else w for w in words]
            run = median_run([arelem, "spray", str(source), "--json", *words])
            rows.append(row(what, run, count, unit))
    return rows


def noisy(path, count, method):
    """A wave of noisy cut vectors half a millimeter apart, to be smoothed."""
    random = 1
    with path.open("w") as file:
        file.write(f"CUTTER/6\nFEDRAT/6000\nFROM/0,0,0\nSMOOTH/.05,METHOD,{method}\n")
        for i in range(1, count + 1):
            random = (1664525 * random + 1013904223) % 2 ** 32
            x = 0.5 * i
            file.write(f"GOTO/{x:.4f},{3 * math.sin(x / 7) + 0.2 * (random / 2 ** 32 - 0.5):.4f},0\n")
        file.write("SMOOTH/NOMORE\nFINI\n")


def smoothed(arelem, out):
    """SMOOTH as a user has it: cut vectors in, fit, smoothing and chords, cut vectors out."""
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder) / "noisy.apt"
        for method in (1, 2, 3):
            for count in (10_000, 100_000):
                noisy(source, count, method)
                run = median_run([arelem, "compile", str(source), "-o", out], 3)
                rows.append(row(f"SMOOTH METHOD, {method}", run, count, "cut vectors"))
    return rows


def certified(arelem):
    """`arelem verify` of a program: its path is computed and proven."""
    rows = []
    for program, what, _ in CASES[:5]:
        run = median_run([arelem, "verify", str(program)], 3)
        rows.append(row(f"verify: {what}", run, cut_vectors(run.told), "cut vectors"))
    return rows


def measure(arelem):
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        out = str(pathlib.Path(folder) / "out.cltape")
        grown = [(program, what, "cut vectors", goal) for what, program, goal in paths.cases(folder)]
        cases = [(*case, None) for case in CASES] + grown
        told = [Run([arelem, "compile", str(program), "-v", "-o", out]).told for program, *_ in cases]  # and the time of the machine
        runs = [None] * len(cases)
        for _ in range(ROUNDS):
            runs = [least_run([arelem, "compile", str(program), "-o", out], run) for (program, *_), run in zip(cases, runs)]
        rows += [row(what, run, cut_vectors(text), unit, goal) for (_, what, unit, goal), run, text in zip(cases, runs, told)]
        rows += certified(arelem)
        rows += smoothed(arelem, out)
        lines = 1_000_000
        source = pathlib.Path(folder) / "bench.cls"
        cl_file(source, lines)
        for target in ("cl", "cltape"):
            run = median_run([arelem, "compile", "--dialect", "cl", str(source), "-o", out, "--to", target])
            rows.append(row(f"CL text of {lines} lines to {target}", run, lines, "statements"))
        rows += stencils(arelem, out)
        rows += sprays(arelem)
        source = pathlib.Path(folder) / "legacy.apt"
        legacy(source, 10_000)
        run = median_run([arelem, "compile", str(source), "-o", out])
        rows.append(row("lines, circles and motions to cltape", run, 10_000, "statements"))
        rows += growth(arelem, folder)
        starts = [Run([arelem, "compile", str(SPEED / "empty.apt"), "-o", out]) for _ in range(25)]
        start, spent = (statistics.median(getattr(r, name) for r in starts) for name in ("seconds", "processor"))
        rows.append(("start-up: PARTNO, FINI", "2 statements", f"{start:.4f}", f"{spent:.4f}", "", "", f"{starts[0].megabytes:.0f}"))
    return rows


def table(rows):
    head = ("case", "work", "seconds", "processor", "per second", "goal", "MB")
    widths = [max(len(r[i]) for r in [head, *rows]) for i in range(len(head))]
    line = lambda r: "| " + " | ".join(f"{c:<{w}}" if i < 2 else f"{c:>{w}}" for i, (c, w) in enumerate(zip(r, widths))) + " |"
    rule = "|" + "|".join("-" * (w + 1) + ("-" if i < 2 else ":") for i, w in enumerate(widths)) + "|"
    return "\n".join([line(head), rule, *(line(r) for r in rows)])


def processor():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return "unknown processor"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--arelem", required=True, type=os.path.abspath)
    parser.add_argument("--save", action="store_true", help="write bench/results.md")
    options = parser.parse_args()
    rows = measure(options.arelem)
    print(table(rows))
    if options.save:
        version = subprocess.run([options.arelem, "--version"], capture_output=True, text=True, check=True).stdout.strip()
        (HERE / "results.md").write_text(
            f"# Speed of {version}\n\nMade by `./dev bench --save` on {processor()} with {os.cpu_count()} threads. The "
            f"whole process, median of {REPEATS}\nruns (of paths the one of {ROUNDS} rounds that took the processor least, of start-up 25; one of what takes {ENOUGH:.0f} s), output to a file with fsync: seconds by the clock "
            f"and of the processor; the rate is\nof processor time. MB is the largest resident memory. More: [by_hand.md](by_hand.md).\n\n"
            f"{table(rows)}\n")
    sys.exit(1 if any(r[1].startswith("exit") for r in rows) else 0)


if __name__ == "__main__":
    main()
