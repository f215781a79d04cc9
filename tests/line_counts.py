#!/usr/bin/env python3
"""Lines of each room, and the house rule: no source file has more than 400. Tables and texts may be longer."""
import pathlib
import subprocess
import sys

ROOMS = ["grammar", "ir", "frontend", "runtime", "backend", "app", "stdlib", "examples", "tests", "bench", "docs"]
MOST = 400
SOURCES = {".cpp", ".h", ".g4", ".py", ".sh"}
# Longer ones that still have to be divided, with the most they may have until then. The list only gets shorter.
LONGER: dict[str, int] = {}
TEXT = {".cpp", ".h", ".def", ".g4", ".py", ".sh", ".apt", ".md", ".cmake"}


def objections(lines):
    for path, count in sorted(lines.items()):
        most = LONGER.get(str(path), MOST)
        if path.suffix in SOURCES and count > most:
            yield f"{path} has {count} lines, {most} are allowed"
        elif str(path) in LONGER and count <= MOST:
            yield f"{path} keeps the rule now: take it out of LONGER in tests/line_counts.py"


def main():
    listed = subprocess.run(["git", "ls-files"], capture_output=True, text=True, check=True).stdout.split("\n")
    paths = [pathlib.Path(p) for p in listed if pathlib.Path(p).suffix in TEXT]
    total, wrong = 0, []
    for room in ROOMS:
        files = [p for p in paths if p.parts[0] == room and "data" not in p.parts and p.exists()]
        lines = {p: sum(1 for _ in p.open(errors="replace")) for p in files}
        wrong += objections(lines)
        if lines:
            largest = max(lines, key=lines.get)
            print(f"{room:10} {len(files):5} files {sum(lines.values()):7} lines   largest {largest} {lines[largest]}")
            total += sum(lines.values())
    print(f"{'together':10} {total:19} lines")
    wrong += [f"{path} is gone: take it out of LONGER in tests/line_counts.py" for path in LONGER
              if not pathlib.Path(path).exists()]
    for sentence in wrong:
        print(sentence, file=sys.stderr)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
