#!/usr/bin/env python3
"""Compares the table of the methods of SMOOTH in the manual with what the compiler gives: every column but the computing time."""
import argparse
import pathlib
import subprocess
import sys

PROJECT = pathlib.Path(__file__).resolve().parents[2]
HEAD = "| case | tolerance | method |"


def rows(text):
    """The cells of the table's rows, without the computing time."""
    lines = text.splitlines()
    start = next(i for i, line in enumerate(lines) if line.startswith(HEAD))
    found = []
    for line in lines[start + 2:]:
        if not line.startswith("|"):
            break
        found.append([cell.strip() for cell in line.strip("|").split("|")][:-1])
    return found


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--bench", required=True, help="the program that measures smoothing")
    bench = options.parse_args().bench
    measured = rows(subprocess.run([bench, "table"], check=True, capture_output=True, text=True).stdout)
    written = rows((PROJECT / "docs" / "manual" / "smoothing.md").read_text())
    wrong = [(w, m) for w, m in zip(written, measured) if w != m]
    for w, m in wrong:
        print(f"manual: {' | '.join(w)}\nnow:    {' | '.join(m)}", file=sys.stderr)
    if len(written) != len(measured):
        print(f"{len(written)} rows in the manual, {len(measured)} measured", file=sys.stderr)
    return int(bool(wrong) or len(written) != len(measured) or len(measured) < 20)


if __name__ == "__main__":
    sys.exit(main())
