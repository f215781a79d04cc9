#!/usr/bin/env python3
"""Random scenes: a tool of any shape along a pair of surfaces to a check surface.

For every pair of kinds of part and drive surface, a number of scenes is drawn. For each of them

* the motion is computed, or refused with one of the motion diagnostics that name the cause (EXPLAINED);
* `arelem verify` proves its tolerances over whole cut vectors;
* the scene moved, turned about z, turned in space with the tool axis, scaled and mirrored gives the moved, turned, scaled
  and mirrored motion: the same diagnostics, and stops within a share of the tolerance band.

A scene that fails is named, and written to the folder of --found. Every scene has a number: `--only N` runs it again.
`--pair PART,DRIVE --count N` runs N scenes of one pair. `--table FILE` adds what was run to the counts of a table.
known.tsv lists scenes whose failure waits to be mended, with its cause; counts.tsv is the table of scenes run so far.
"""
import argparse
import collections
import concurrent.futures
import json
import math
import os
import pathlib
import random
import resource
import signal
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import surfaces  # noqa: E402

CUTTERS = [(0.75, 0.375), (0.75,), (1, 0.1875), (0.5, 0.25), (0.25,), (0.5, 0.0625), (1.5, 0.25),
           (1, 0, 0.5, 0, 0, 0, 3), (0.8, 0.1, 0.3, 0.1, 0, 0, 4)]
BANDS = [(0, 0.002), (0.002, 0), (0.002, 0.002), (0.001, 0.001), (0.01, 0.01), (0, 0.0005)]
# Why a motion may be refused: the scene has no such motion. The message says what and where.
EXPLAINED = {
    "E0505": "the startup's contact is not the one that the motion follows",
    "E0504": "the same for the part surface",
    "E0508": "the check surface is not on the way",
    "E0510": "no position touches all three surfaces",
    "E0511": "the tool stands on the surface to which it shall go",
    "E0512": "the contact is lost",
    "E0513": "more cut vectors than NUMPTS",
    "E0521": "the cutter does not fit",
}
# Stops of moved scenes may lie apart by this share of the band over the sine at which they are met.
SHARE = 0.5
# Seconds of the processor for one command: other programs may keep the machine busy.
TIME_LIMIT = 60
PAIRS = len(surfaces.PAIRS)


class Scene:
    def __init__(self, index, seed):
        self.pair = surfaces.PAIRS[index % PAIRS]
        r = random.Random(f"{seed}/{index}")
        u = r.uniform
        self.part = surfaces.part(self.pair[0], u)
        self.drive = surfaces.drive(self.pair[1], u)
        self.check = surfaces.check(u, r.choice)
        self.cutter = r.choice(CUTTERS)
        self.band = r.choice(BANDS)
        self.relation = r.choice(["TLON", "TLLFT", "TLRGT"])
        self.stop = r.choice(["TO", "ON", "PAST"])
        self.moves = {
            "as drawn": surfaces.Similarity(),
            "moved": surfaces.Similarity(shift=(u(-9, 9), u(-9, 9), u(-9, 9))),
            "turned": surfaces.Similarity(surfaces.about((0, 0, 1), u(0, 360)), (u(-3, 3), u(-3, 3), 0)),
            "mirrored": surfaces.Similarity(((1, 0, 0), (0, -1, 0), (0, 0, 1))),
            "scaled": surfaces.Similarity(scale=r.choice([0.125, 0.5, 4.0, 25.4])),
            "in space": surfaces.Similarity(surfaces.about(unit((u(-1, 1), u(-1, 1), u(-1, 1))), u(0, 360)),
                                            (u(-3, 3), u(-3, 3), u(-3, 3))),
        }

    def program(self, move):
        """The part program of the scene moved."""
        length, scaled = move.length, lambda values: surfaces.numbers(map(move.length, values))
        relation = self.relation
        if move.mirrors() and relation != "TLON":
            relation = {"TLLFT": "TLRGT", "TLRGT": "TLLFT"}[relation]
        start = {"TLON": "ON", "TLLFT": "TO", "TLRGT": "PAST"}[self.relation]
        cutter = [c if len(self.cutter) == 7 and i in (4, 5) else length(c) for i, c in enumerate(self.cutter)]
        if len(cutter) < 7:
            # The old system's height of short forms is not scaled: write it out.
            d, r = self.cutter[0], (self.cutter + (0,))[1]
            cutter = [length(d), length(r), length(d / 2 - r), length(r), 0, 0, length(5)]
        lines = [
            "PARTNO RANDOM SCENE", "MULTAX", "3DCALC",
            f"INTOL/{surfaces.number(length(self.band[0]))}", f"OUTTOL/{surfaces.number(length(self.band[1]))}",
            f"MAXDP/{surfaces.number(length(10))}", f"CUTTER/{surfaces.numbers(cutter)}",
            "PS1=" + surfaces.define(self.part, move), "DS1=" + surfaces.define(self.drive, move),
            "CS1=" + surfaces.define(self.check, move),
            "X1=" + surfaces.define(("PLANE", (1, 0, 0), -4.25), move),
            f"FROM/{surfaces.numbers(move.point((-7.15, 2.55, 6.25)))},{surfaces.numbers(move.direction((0, 0, 1)))}",
            f"GO/{start},DS1,TO,PS1,ON,X1",
            f"INDIRV/{surfaces.numbers(move.direction((1, 0, 0)))}",
            f"{relation},GOFWD/DS1,{self.stop},CS1", "FINI"]
        return "\n".join(card for line in lines for card in cards(line)) + "\n"


def unit(v):
    n = math.sqrt(sum(x * x for x in v))
    return tuple(x / n for x in v)


def cards(line):
    while len(line) > 70:
        cut = line.rfind(",", 0, 68) + 1
        yield line[:cut] + "$"
        line = line[cut:]
    yield line


class Slow(Exception):
    pass


def execute(arelem, *arguments):
    done = subprocess.run([arelem, *arguments], capture_output=True, text=True,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (TIME_LIMIT, TIME_LIMIT)))
    if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        raise Slow(f"more than {TIME_LIMIT} s: {arelem} {' '.join(arguments)}")
    return done


def write(scene, move, path):
    path.write_text(scene.program(move))
    if scene.part[0] == "MESH":
        path.with_name("mesh.stl").write_text(surfaces.stl(scene.part[1], move))


def compute(arelem, scene, move, folder, name):
    """Codes of the errors, and the last two places of every motion."""
    path = pathlib.Path(folder, name)
    write(scene, move, path)
    done = execute(arelem, "compile", str(path), "--to", "json", "-o", "-", "--diagnostics", "json")
    codes = sorted({json.loads(l)["code"] for l in done.stderr.splitlines() if l.startswith("{") and '"error"' in l})
    # Long motions fill several records: their statement's number holds them together.
    statements = {}
    for record in map(json.loads, done.stdout.splitlines()):
        if record["type"] == 5000:
            statements.setdefault(record["isn"], []).extend(point[:3] for point in record["points"])
    paths = list(statements.values())
    ends = [(path[-1], path[-2] if len(path) > 1 else before[-1]) for before, path in zip(paths[:1] + paths, paths)]
    return codes, ends, done


def meeting_sine(scene, end):
    """Sine of the angle at which the last cut vector meets the check surface, seen from the tool end."""
    place, before = end
    step = tuple(a - b for a, b in zip(place, before))
    kind, *v = scene.check
    if kind == "PLANE":
        normal = v[0]
    else:
        normal = tuple(a - b for a, b in zip(place, v[0]))
        if kind == "CYLNDR":
            axis = unit(v[1])
            along = sum(a * b for a, b in zip(normal, axis))
            normal = tuple(a - along * b for a, b in zip(normal, axis))
    lengths = math.hypot(*step) * math.hypot(*normal)
    return abs(sum(a * b for a, b in zip(step, normal))) / lengths if lengths > 0 else 1.0


def problems(arelem, scene, folder):
    """What is wrong with a scene; the outcome of the scene as drawn."""
    wrong = []
    codes, ends, done = compute(arelem, scene, scene.moves["as drawn"], folder, "scene.apt")
    outcome = codes[0] if codes else "computed"
    if done.returncode != 0 and not codes:
        wrong.append(f"exit code {done.returncode}: {done.stderr[:300]}")
    wrong += [f"{code} is not among the explained refusals" for code in codes if code not in EXPLAINED]
    if not codes:
        proof = execute(arelem, "verify", str(pathlib.Path(folder, "scene.apt")))
        if proof.returncode != 0:
            wrong.append(f"verify: exit code {proof.returncode}: {proof.stderr[:300]}")
    band = sum(scene.band)
    # Where the path hardly meets the check surface its place is known to the root of the band.
    sine = max(meeting_sine(scene, ends[-1]), math.sqrt(band)) if ends else 1.0
    for name, move in scene.moves.items():
        other, places, _ = compute(arelem, scene, move, folder, "moved.apt")
        if other != codes:
            wrong.append(f"{name}: {other or 'computed'} instead of {codes or 'computed'}")
            continue
        for i, ((at, _), (place, _)) in enumerate(zip(ends, places)):
            share = SHARE * band / (sine if i == len(ends) - 1 else 1.0)
            allowed = move.length(share) + 1e-9 * move.length(10)
            apart = math.dist(move.point(at), place)
            if apart > allowed and not codes:
                wrong.append(f"{name}: a stop is {apart:.3g} from where it should be; {allowed:.3g} is allowed")
    return wrong, outcome


def trial(arelem, index, seed):
    scene = Scene(index, seed)
    with tempfile.TemporaryDirectory() as folder:
        try:
            wrong, outcome = problems(arelem, scene, folder)
        except Slow as slow:
            wrong, outcome = [str(slow)], "slow"
    return index, scene, wrong, outcome


def known(seed):
    """Numbers of the scenes of a seed that are known to fail."""
    rows = pathlib.Path(__file__).with_name("known.tsv").read_text().splitlines()
    cells = [row.split("\t") for row in rows if row and not row.startswith("#")]
    return {int(scene) for s, scene, _ in cells if int(s) == seed}


TABLE_HEAD = "# Random scenes run so far: part, drive, scenes, computed, refused with a cause, failed.\n"


def add_to_table(path, rows):
    """Adds {pair: [scenes, computed, refused, failed]} to a table."""
    table = {}
    if path.exists():
        cells = [row.split("\t") for row in path.read_text().splitlines() if not row.startswith("#")]
        table = {(c[0], c[1]): [int(x) for x in c[2:]] for c in cells}
    for pair, counts in rows.items():
        table[pair] = [a + b for a, b in zip(table.get(pair, [0] * 4), counts)]
    order = [p for p in surfaces.PAIRS if p in table]
    path.write_text(TABLE_HEAD + "".join("\t".join([*p, *map(str, table[p])]) + "\n" for p in order))


def options_of():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--arelem", default=os.environ.get("ARELEM", "build/arelem"))
    parser.add_argument("--scenes", type=int, default=PAIRS, help=f"number of scenes; {PAIRS} is one for every pair")
    parser.add_argument("--first", type=int, default=0, help="number of the first scene: shares work between machines")
    parser.add_argument("--pair", help="PART,DRIVE: only scenes of this pair, --count of them from the --first one on")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", type=int, help="number of the one scene to run")
    parser.add_argument("--found", default="", help="folder for the programs of scenes that fail")
    parser.add_argument("--table", default="", help="table to which the counts are added")
    options = parser.parse_args()
    if options.pair and tuple(options.pair.split(",")) not in surfaces.PAIRS:
        parser.error(f"no pair {options.pair}; parts: {' '.join(surfaces.PARTS)}; drives: {' '.join(surfaces.DRIVES)}")
    return options


def indices_of(options):
    if options.only is not None:
        return [options.only]
    if options.pair:
        first = surfaces.PAIRS.index(tuple(options.pair.split(",")))
        return [first + PAIRS * (options.first + k) for k in range(options.count)]
    return list(range(options.first, options.first + options.scenes))


def main():
    options = options_of()
    indices = indices_of(options)
    failed, outcomes, waiting = 0, collections.Counter(), known(options.seed)
    rows = collections.defaultdict(lambda: [0] * 4)
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for index, scene, wrong, outcome in pool.map(lambda i: trial(options.arelem, i, options.seed), indices):
            outcomes[outcome] += 1
            rows[scene.pair][0] += 1
            rows[scene.pair][3 if wrong else 1 if outcome == "computed" else 2] += 1
            if index in waiting and wrong:
                outcomes["known to fail"] += 1
                continue
            if not wrong:
                continue
            failed += 1
            print(f"scene {index} (seed {options.seed}, part {scene.pair[0]}, drive {scene.pair[1]}):")
            print("".join(f"  {w}\n" for w in wrong), end="", flush=True)
            if options.found:
                pathlib.Path(options.found).mkdir(parents=True, exist_ok=True)
                folder = pathlib.Path(options.found, f"{options.seed}_{index}")
                folder.mkdir(exist_ok=True)
                write(scene, scene.moves["as drawn"], folder / "scene.apt")
    if options.table:
        add_to_table(pathlib.Path(options.table), rows)
    for outcome, count in outcomes.most_common():
        print(f"{count:7d} {outcome} {EXPLAINED.get(outcome, '')}".rstrip())
    print(f"{len(indices)} scenes, {failed} failed")
    return 1 if failed or not indices else 0


if __name__ == "__main__":
    sys.exit(main())
