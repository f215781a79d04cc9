#!/usr/bin/env python3
"""Compares the tables of the methods of SMOOTH in the manual with what the compiler gives: every column but the computing time."""
import argparse
import pathlib
import subprocess
import sys

PROJECT = pathlib.Path(__file__).resolve().parents[2]
# Heads of the tables, and whether the last column is a computing time.
TABLES = (("| case | tolerance | method |", True), ("| by his law | tolerance |", False))


def table(text, head, timed):
    """The cells of the table's rows, without the computing time."""
    lines = text.splitlines()
    start = next(i for i, line in enumerate(lines) if line.startswith(head))
    found = []
    for line in lines[start + 2:]:
        if not line.startswith("|"):
            break
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        found.append(cells[:-1] if timed else cells)
    return found


def rows(text):
    return [row for head, timed in TABLES for row in table(text, head, timed)]


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
    return int(bool(wrong) or len(written) != len(measured) or len(measured) < 60)


if __name__ == "__main__":
    sys.exit(main())
