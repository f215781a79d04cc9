#!/usr/bin/env python3
"""Fails for a form or rule of the language reference that no golden program uses.

What a program uses is counted by the compiler itself (`arelem check --report`), by id. The ids of sections 1, 2, 3 and
6 are in tests/data/coverage/ids.txt; every id that the compiler knows must be used as well.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
IDS = HERE.parent / "data" / "coverage" / "ids.txt"


def used_by(task):
    arelem, program = task
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder) / "report.json"
        subprocess.run([arelem, "check", str(program), "--report", str(report)], capture_output=True, timeout=120)
        return set(json.loads(report.read_text())["features"])


def known(arelem):
    """Ids of the compiler's tables; rows that differ by a third part are one form."""
    tables = json.loads(subprocess.run([arelem, "language", "--json"], capture_output=True, text=True, check=True).stdout)
    return {"-".join(row["id"].split("_")[:2]) for table in ("forms", "features") for row in tables[table]}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--arelem", default=str(HERE.parent.parent / "build" / "arelem"), type=os.path.abspath)
    options = parser.parse_args()
    programs = sorted(HERE.rglob("*.apt"))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        used = set().union(*pool.map(used_by, [(options.arelem, p) for p in programs]))
    wanted = set(IDS.read_text().split())
    listed = known(options.arelem)
    problems = [f"{i}: no golden program uses it" for i in sorted((wanted | listed) - used)]
    problems += [f"{i}: the compiler has no row of this id" for i in sorted(wanted - listed)]
    print("\n".join(problems))
    print(f"{len(wanted)} ids of the reference, {len(listed)} of the compiler, {len(problems)} problems")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
