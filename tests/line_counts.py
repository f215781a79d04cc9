#!/usr/bin/env python3
"""Lines of each room: sources, headers, tests; and the largest file, which must keep the house rule of 400 lines."""
import pathlib
import subprocess

ROOMS = ["grammar", "ir", "frontend", "runtime", "backend", "app", "stdlib", "examples", "tests", "bench", "docs"]
TEXT = {".cpp", ".h", ".def", ".g4", ".py", ".sh", ".apt", ".md", ".cmake"}


def main():
    listed = subprocess.run(["git", "ls-files"], capture_output=True, text=True, check=True).stdout.split("\n")
    paths = [pathlib.Path(p) for p in listed if pathlib.Path(p).suffix in TEXT]
    total = 0
    for room in ROOMS:
        files = [p for p in paths if p.parts[0] == room and "data" not in p.parts and p.exists()]
        lines = {p: sum(1 for _ in p.open(errors="replace")) for p in files}
        if lines:
            largest = max(lines, key=lines.get)
            print(f"{room:10} {len(files):5} files {sum(lines.values()):7} lines   largest {largest} {lines[largest]}")
            total += sum(lines.values())
    print(f"{'together':10} {total:19} lines")


if __name__ == "__main__":
    main()
