#!/usr/bin/env python3
"""Compiles every part program of examples/ to every output format: no error, no warning, no empty output
(but the deck of a program that punches nothing)."""
import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

# A CL tape has no place for the turn of a gun, a robot no spindle: warnings that belong to the format.
EXPECTED = {"W0604", "W0620"}
PROJECT = pathlib.Path(__file__).resolve().parents[2]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--arelem", default=str(PROJECT / "build" / "arelem"), type=os.path.abspath)
    arelem = parser.parse_args().arelem
    listed = subprocess.run([arelem, "targets"], capture_output=True, text=True, check=True).stdout
    targets = [line.split()[0] for line in listed.splitlines()]
    programs = sorted((PROJECT / "examples").glob("*.apt"))
    problems = [] if len(programs) >= 6 else ["fewer than six examples"]
    for program in programs:
        with tempfile.TemporaryDirectory() as folder:
            words = [w for t in targets for w in ("--to", t)]
            done = subprocess.run([arelem, "compile", str(program), "--out-dir", folder, *words], capture_output=True, text=True)
            sizes = {p.suffix: p.stat().st_size for p in pathlib.Path(folder).iterdir()}
        told = set(re.findall(r"\[([EW]\d{4})\]", done.stderr))
        if done.returncode or told - EXPECTED or len(sizes) != len(targets) or 0 in [n for s, n in sizes.items() if s != ".deck"]:
            problems.append(f"{program.name}: exit {done.returncode}, outputs {sizes}\n{done.stderr}")
    print("\n".join([*problems, f"{len(programs)} examples, {len(targets)} formats, {len(problems)} problems"]))
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
