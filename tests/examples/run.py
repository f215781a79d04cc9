#!/usr/bin/env python3
"""Compiles every part program of examples/ to every output format: no error, no warning, no empty output
(but the deck of a program that punches nothing). RS-274 is refused for the programs that tests/ngc/examples.py names."""
import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

PROJECT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT / "tests" / "ngc"))
from examples import REFUSED  # noqa: E402

# Warnings that belong to a format: a CL tape has no place for the turn of a gun, a robot no spindle, RS-274 no paint.
EXPECTED = {"W0604", "W0620", "W0641", "W0643", "W0675"}


def compile_to(arelem, program, targets):
    """Exit code, codes of the messages, sizes of the outputs by suffix, and the messages."""
    with tempfile.TemporaryDirectory() as folder:
        words = [w for t in targets for w in ("--to", t)]
        done = subprocess.run([arelem, "compile", str(program), "--out-dir", folder, *words], capture_output=True, text=True)
        sizes = {p.suffix: p.stat().st_size for p in pathlib.Path(folder).iterdir()}
    return done.returncode, set(re.findall(r"\[([EW]\d{4})\]", done.stderr)), sizes, done.stderr


def check(arelem, program, targets):
    """What is wrong, or None."""
    if not re.search("^(SPRAY|STENCL)/", program.read_text(), re.M):
        targets = [t for t in targets if t != "g97"]  # a painting robot does not mill
    refusal = REFUSED.get(program.name)
    if refusal:
        # A robot cannot do without a feed either.
        refused = ["ngc", "vplus"] if refusal[0] == "E0671" else ["ngc"]
        targets = [t for t in targets if t not in refused]
        for target in refused:
            code, told, sizes, text = compile_to(arelem, program, [target])
            if code != 6 or sizes or refusal[0] not in told:
                return f"{program.name}: {target} is to be refused with {refusal[0]}; exit {code}, outputs {sizes}\n{text}"
    code, told, sizes, text = compile_to(arelem, program, targets)
    empty = [s for s, n in sizes.items() if n == 0 and s != ".deck"]
    if code or told - EXPECTED or len(sizes) != len(targets) or empty:
        return f"{program.name}: exit {code}, outputs {sizes}\n{text}"
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--arelem", default=str(PROJECT / "build" / "arelem"), type=os.path.abspath)
    arelem = parser.parse_args().arelem
    listed = subprocess.run([arelem, "targets"], capture_output=True, text=True, check=True).stdout
    # Joints are those of an arm, which a machine file describes: tests/end_to_end/test_robots.py.
    targets = [line.split()[0] for line in listed.splitlines() if "needs --machine" not in line]
    programs = sorted((PROJECT / "examples").glob("*.apt"))
    problems = [] if len(programs) >= 6 else ["fewer than six examples"]
    for program in programs:
        problem = check(arelem, program, targets)
        if problem:
            problems.append(problem)
    print("\n".join([*problems, f"{len(programs)} examples, {len(targets)} formats, {len(problems)} problems"]))
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
