#!/usr/bin/env python3
"""Compares arelem with the results of the old system, program by program.

Per program: printed geometry, all records but motion, end positions, number of cut vectors, and whether every point
and the middle of every chord of our paths keeps the tolerances (measured by surfaces.py and cutter.py, with numpy). Our own cases lie in tests/data/oracle; the examples of
the old system are read in place where they exist (ARELEM_SHARED, or the folder `shared` beside the project).
"""
import argparse
import json
import multiprocessing
import os
import pathlib
import subprocess
import sys
import tempfile
import time

import bands
import page
import part_program
import records
import section_3

HERE = pathlib.Path(__file__).resolve().parent
PROJECT = HERE.parent.parent
CHECKS = ("geometry", "records", "ends", "vectors", "bands", "coverage", "diagnostics")
END_TOLERANCE = 1e-4  # part unit
OTHERS = ("wikipedia-apt-1", "personal-apt-sample")  # of other origin: they compile, and their paths keep the bands
COVERAGE = HERE / "coverage.tsv"


def programs():
    """(name, source, result) of every program with a result of the old system, and of some without one."""
    data = PROJECT / "tests" / "data" / "oracle"
    for folder in (data / "cases", data / "bad"):
        for result in sorted(folder.glob("*.json")):
            yield result.stem, result.with_suffix(".apt"), result
    shared = pathlib.Path(os.environ.get("ARELEM_SHARED", PROJECT.parent / "shared"))
    examples = shared / "oracle" / "examples"
    if not examples.is_dir():
        print("the old system's examples are not here (ARELEM_SHARED): compared with our own cases only")
        return
    for result in sorted(examples.glob("*.json")):
        yield "examples/" + result.stem, shared / "corpus" / "aptos-apt360" / (result.stem + ".apt"), result
    for name in OTHERS:
        yield "web/" + name, shared / "corpus" / "web" / (name + ".apt"), None


class Arelem:
    def __init__(self, binary):
        self.binary = binary

    def call(self, *words):
        done = subprocess.run([self.binary, *map(str, words)], capture_output=True, text=True, timeout=300)
        return done.returncode, done.stdout, done.stderr

    def geometry(self, path):
        code, out, _ = self.call("geometry", path, "--json", "-q", "--diagnostics=json")
        return code, json.loads(out) if out.strip() else []

    def lines(self, path):
        """Line by statement number, of the statements in the program itself and not in a library."""
        _, listing, _ = self.call("compile", path, "--to", "listing", "-o", "-", "-q")
        table = listing.split("\n * * * ")[0].split("\n    ISN   LINE\n")
        return {int(row[:7]): int(row[7:14]) for row in table[1].splitlines() if row[:7].strip().isdigit()}

    def records(self, path, *options):
        code, out, err = self.call("compile", path, "--to", "json", "-o", "-", "--diagnostics=json",
                                   "--max-errors", "100000", *options)
        messages = [json.loads(line) for line in err.splitlines() if line.startswith("{")]
        return code, [json.loads(line) for line in out.splitlines()], messages


def compare_geometry(arelem, source, oracle):
    """What the old system printed, in its order, among our definitions in the order of execution."""
    if not oracle["prints"]:
        return []
    _, rows = arelem.geometry(source)
    wrong, start, used = [], 0, set()  # nested definitions of one statement are computed in another order there
    for row in oracle["prints"]:
        if row["type"] == "UNDEF" or row["n"] != len(row["values"]):
            continue  # printed before it had a value, or more numbers than the old listing shows
        same_name = [i for i, r in enumerate(rows) if (r["name"], r["subscript"]) == (row["name"], row["subscript"])]
        same = [i for i in same_name if rows[i]["type"] == row["type"]
                and records.same_rows(rows[i]["values"], row["values"])]
        nested = row["name"].startswith("*")
        place = next((i for i in same if (i not in used if nested else i >= start)), None)
        if place is not None and nested:
            used.add(place)
        elif place is not None:
            start = place + 1 if row["type"] != "SCALAR" else start
        elif nested or not same:
            wrong.append(f"{row['name']}({row['subscript']}) {row['type']} {row['values']} is not among "
                         f"{[rows[i]['values'] for i in same_name][-3:]}")
    return wrong


def compare_ends(ours, theirs, band, demands):
    """Ends agree to END_TOLERANCE. On curved surfaces stops lie within the band: there an end may differ by the band if
    it is no farther from the exact stop than the old system's, measured without either. The exact stops of startups and
    tangencies are not known to these tests; such ends are noted."""
    wrong, worst, noted, before = [], 0.0, [], None
    for a, b, demand in zip(ours, theirs, demands or [None] * len(ours)):
        if a["isn"] != b["isn"] or a["kind"] != b["kind"]:
            wrong.append(f"{a['kind']} of statement {a['isn']} where the old system has {b['kind']} of {b['isn']}")
            break
        off = records.end_distance(a, b)
        worst = max(worst, off)
        if off > END_TOLERANCE + band:
            wrong.append(f"statement {a['isn']}: {a['points'][-1]} is {off:.6f} from {b['points'][-1]}")
        elif off > END_TOLERANCE:
            gaps = bands.from_exact_stop(demand, before, [a["points"][-1], b["points"][-1]])
            noted.append((a["isn"], off, gaps))
            if gaps is not None and gaps[0] > gaps[1] + bands.SLACK:
                wrong.append(f"statement {a['isn']}: {gaps[0]:.6f} from the exact stop, the old system {gaps[1]:.6f}")
        before = a["points"][-1]
    if not wrong and len(ours) != len(theirs):
        wrong.append(f"{len(ours)} motions instead of {len(theirs)}")
    return wrong, worst, noted


def named_rows(arelem, text):
    """All definitions of a program in order, as (name, type, canon), those of motion statements named."""
    with tempfile.NamedTemporaryFile("w", suffix=".apt") as file:
        file.write(text)
        file.flush()
        _, rows = arelem.geometry(file.name)
    name = lambda r: r["name"] if r["subscript"] == 0 else f"{r['name']}({r['subscript']})"
    return [(name(r), r["type"], r["values"]) for r in rows]


def measure_bands(arelem, source, ours):
    """Deviation rows, reasons for what was not measured, a sentence if TRACUT or COPY put a motion elsewhere, and the
    demands of each motion where nothing is moved.

    Where a program moves or copies its path, the path before that is measured, and the records are compared with its
    images.
    """
    named = part_program.name_nested(source.read_text(errors="replace"))
    rows = named_rows(arelem, named)
    lines = arelem.lines(source)
    bare = part_program.without_section_3(named)
    if bare is None:
        demands = part_program.Follower(named, rows).demands(ours, lines)
        return *bands.measure(demands, records.motions(ours)), None, demands
    with tempfile.NamedTemporaryFile("w", suffix=".apt") as file:
        file.write(bare)
        file.flush()
        _, before, _ = arelem.records(file.name)
        bare_lines = arelem.lines(file.name)
    demands = part_program.Follower(bare, rows).demands(before, bare_lines)
    wanted = section_3.expected(named, rows, records.motions(before), bare_lines)
    return *bands.measure(demands, records.motions(before)), section_3.difference(wanted, records.motions(ours)), None


def compare_diagnostics(oracle, code, messages):
    """A program that fails there must fail here, with the old numbers among ours."""
    wanted = {str(d["number"]) for d in oracle["diagnostics"] if d.get("number", 0) > 0}
    told = {m["legacy"] for m in messages if m["legacy"]}
    wrong = [f"old number {number} is not reported" for number in sorted(wanted - told)]
    if wanted and code == 0:
        wrong.append("it compiles without an error")
    return wrong


def compare_bands(arelem, source, ours, outcome):
    """Notes in the outcome whether the path keeps its bands; the demands of its motions, or None."""
    moved = demands = None
    try:
        outcome["rows"], outcome["skipped"], moved, demands = measure_bands(arelem, source, ours)
    except part_program.Unfollowed as reason:
        outcome["skipped"] = [f"not followed: {reason}"]
    outcome["wrong"]["bands"] = ([moved] if moved else []) + [
        f"statement {r['isn']}, {r['role']} surface: {r['low']:+.6f} to {r['high']:+.6f}, middles of chords "
        f"{r['middle_low']:+.6f} to {r['middle_high']:+.6f}, allowed {-r['inner']:+.6f} to {r['outer']:+.6f}"
        for r in outcome["rows"] if bands.violation(r)]
    outcome["wrong"]["coverage"] = compare_coverage(outcome["name"], len(outcome["rows"]))
    return demands


def compare(task):
    name, source, result, binary = task
    arelem = Arelem(binary)
    oracle = json.loads(result.read_text()) if result else {"status": "ok", "prints": [], "diagnostics": []}
    outcome = {"name": name, "wrong": {}, "rows": [], "skipped": [], "vectors": (0, 0), "end": 0.0, "stops": []}
    try:
        strict = ["--dialect=apt360"] if oracle["status"] != "ok" else []
        code, ours, messages = arelem.records(source, *strict)
    except (subprocess.TimeoutExpired, json.JSONDecodeError) as error:
        outcome["wrong"]["diagnostics"] = [f"{type(error).__name__}: {error}"[:200]]
        return outcome
    if oracle["status"] != "ok":
        outcome["wrong"]["diagnostics"] = compare_diagnostics(oracle, code, messages)
        return outcome
    if code != 0:
        first = next((m for m in messages if m["severity"] == "error"), messages[0]) if messages else {"code": "", "message": f"exit {code}", "range": None}
        line = first["range"]["start"]["line"] if first["range"] else 0
        outcome["wrong"]["diagnostics"] = [f"exit {code}: line {line} {first['code']} {first['message']}"]
        return outcome
    outcome["wrong"]["geometry"] = compare_geometry(arelem, source, oracle)
    our_motions = records.motions(ours)
    demands = compare_bands(arelem, source, ours, outcome)
    if result is None:
        return outcome
    difference = records.first_difference(records.others(ours), records.others(oracle["cl"]))
    outcome["wrong"]["records"] = [difference] if difference else []
    outcome["wrong"]["ends"], outcome["end"], outcome["stops"] = compare_ends(
        our_motions, records.motions(oracle["cl"]), band_allowance(oracle["cl"]), demands)
    counts = records.cut_vectors(ours), records.cut_vectors(oracle["cl"])
    outcome["vectors"] = counts
    outcome["wrong"]["vectors"] = [f"{counts[0]} points, the old system needs {counts[1]}"] if counts[0] > counts[1] else []
    return outcome


def compare_coverage(name, paths):
    """A program is measured along as many surfaces as ever: the number of paths stands in coverage.tsv."""
    recorded = recorded_coverage().get(name, 0)
    if paths == recorded:
        return []
    return [f"{paths} paths along surfaces are measured, {recorded} stand in coverage.tsv"
            + ("" if paths < recorded else "; --record-coverage writes it anew")]


def recorded_coverage():
    rows = (line.split("\t") for line in COVERAGE.read_text().splitlines() if line and not line.startswith("#"))
    return {name: int(paths) for name, paths in rows}


def record_coverage(outcomes):
    coverage = recorded_coverage()
    coverage.update({o["name"]: len(o["rows"]) for o in outcomes})
    COVERAGE.write_text("# Paths along drive and part surfaces that the band check measures. Fewer are an error.\n"
                        + "".join(f"{name}\t{paths}\n" for name, paths in sorted(coverage.items()) if paths))


def band_allowance(oracle_records):
    """The band within which the old system's own points lie; ours lie on the surface."""
    inner = max((max(r["values"]) for r in oracle_records if r["kind"] == "INTOL"), default=0.0)
    outer = max((max(r["values"]) for r in oracle_records if r["kind"] == "OUTTOL"), default=0.0005)
    return inner + outer


def known_differences():
    known = {}
    for line in (HERE / "known.tsv").read_text().splitlines():
        if line and not line.startswith("#"):
            name, check, reason = line.split("\t")
            known[(name, check)] = reason
    return known


def report(outcomes, show_rows):
    known, failures, used = known_differences(), 0, set()
    mark = lambda o, c: "-" if c not in o["wrong"] else "known" if (o["name"], c) in known and o["wrong"][c] \
        else "WRONG" if o["wrong"][c] else "ok"
    print(f"{'program':26}" + "".join(f"{c:>12}" for c in CHECKS) + f"{'points':>8}{'old':>7}{'end off':>10}")
    for o in outcomes:
        print(f"{o['name']:26}" + "".join(f"{mark(o, c):>12}" for c in CHECKS)
              + f"{o['vectors'][0]:8}{o['vectors'][1]:7}{o['end']:10.6f}")
    print()
    for o in outcomes:
        for check, wrong in o["wrong"].items():
            key = (o["name"], check)
            if wrong and key in known:
                used.add(key)
            elif wrong:
                failures += 1
                for sentence in wrong[:3]:
                    print(f"{o['name']}: {check}: {sentence}")
    present = {o["name"] for o in outcomes}
    for key in sorted(set(known) - used):
        if key[0] in present:
            failures += 1
            print(f"known.tsv: {key[0]} {key[1]} no longer differs; remove the line")
    if show_rows:
        print_rows(outcomes)
    print_stops(outcomes)
    print_worst(outcomes)
    return failures


def print_stops(outcomes):
    print(f"\nends that differ by more than {END_TOLERANCE:g}, all within their band: distance from the old system's, and "
          "of both from the exact stop")
    for o in outcomes:
        for isn, off, gaps in o["stops"]:
            exact = f"{gaps[0]:.6f}, old {gaps[1]:.6f}" if gaps is not None else "not known (startup, tangency)"
            print(f"  {o['name']:26} statement {isn:3}: {off:.6f}; {exact}")


def print_rows(outcomes):
    print(f"\n{'program':26} statement          role   points      inside     outside   chord inside  chord outside")
    for o in outcomes:
        for r in o["rows"]:
            print(f"{o['name']:26} {r['isn']:5} {r['word']:9} {r['role']:>8} {r['points']:8} {r['low']:+11.7f} "
                  f"{r['high']:+11.7f} {r['middle_low']:+14.7f} {r['middle_high']:+14.7f}")


def print_worst(outcomes):
    rows = [(o["name"], r) for o in outcomes for r in o["rows"]]
    skipped = sum(len(o["skipped"]) for o in outcomes)
    points = sum(r["points"] for _, r in rows)
    print(f"\ntolerance bands: {len(rows)} paths along surfaces measured, {points} points; {skipped} not measured")
    for o in outcomes:
        for reason in o["skipped"]:
            print(f"  {o['name']:26} not measured: {reason}")
    share = lambda r: max(-r["low"] - r["inner"], r["high"] - r["outer"])
    for name, r in sorted(rows, key=lambda item: -share(item[1]))[:8]:
        print(f"  {name:26} statement {r['isn']:3} {r['role']:5}: points {r['low']:+.7f} to {r['high']:+.7f}, chord "
              f"middles {r['middle_low']:+.7f} to {r['middle_high']:+.7f}, band {-r['inner']:+.5f} to {r['outer']:+.5f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--arelem", default=str(PROJECT / "build" / "arelem"), type=os.path.abspath)
    parser.add_argument("--only", help="programs whose name contains this")
    parser.add_argument("--table", action="store_true", help="every statement's deviations")
    parser.add_argument("--write-page", action="store_true", help="write docs/comparison-motion.md anew")
    parser.add_argument("--record-coverage", action="store_true", help="write coverage.tsv anew")
    options = parser.parse_args()
    start = time.time()
    tasks = [(n, s, r, options.arelem) for n, s, r in programs() if not options.only or options.only in n]
    if not tasks:
        sys.exit("no programs found")
    with multiprocessing.Pool() as pool:
        outcomes = pool.map(compare, tasks, chunksize=1)
    if options.record_coverage:
        record_coverage(outcomes)
        return
    failures = report(outcomes, options.table)
    for objection in [] if options.only else page.check(outcomes, known_differences(), options.write_page):
        failures += 1
        print(objection)
    good = sum(1 for o in outcomes if not any(o["wrong"].values()))
    print(f"\n{len(outcomes)} programs, {good} without any difference, {failures} unexplained differences, "
          f"{time.time() - start:.1f} s")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
