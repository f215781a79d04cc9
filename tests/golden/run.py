#!/usr/bin/env python3
"""Runs part programs that carry their expectations in comments.

  $$ RUN: %arelem compile %s --to cl      the command; %s is the program, %t a file of its own for outputs.
                                          Several RUN lines run in order. Without one: `%arelem check %s`.
  $$ CHECK: GOTO / 1.0, 2.0               must occur in the output of the last RUN, in this order
  $$ CHECK-NEXT: text                     ... on the line behind the previous match
  $$ CHECK-NOT: text                      must not occur after the previous match
  $$ VALUES: L1 .6 -sqrt(3)/2 0 4         the entity or scalar has these canonical numbers, to 1e-9 of the largest
  L1=LINE/P1,P2      $$ error[E0201]: `P2` is not defined
                                          this line, and no other, has this error; warning[...] alike

Blanks count as one blank. A program that has error lines must fail, any other must succeed. Programs that fail are
called fail_*.apt, so that a listing of the folder is a specification.
"""
import argparse
import concurrent.futures
import json
import math
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
EXPECTED = re.compile(r"\$\$\s*(error|warning)\[([EW]\d{4})\]:?\s*(.*?)\s*$")
DIRECTIVE = re.compile(r"\$\$\s*(RUN|CHECK|CHECK-NEXT|CHECK-NOT|VALUES):\s*(.*?)\s*$")


def squeeze(text):
    return " ".join(text.split())


def find(lines, start, wanted):
    for i in range(start, len(lines)):
        if squeeze(wanted) in squeeze(lines[i]):
            return i
    return None


def check_output(directives, output):
    lines, place = output.splitlines(), -1
    for kind, text in directives:
        if kind == "CHECK-NOT":
            if find(lines, place + 1, text) is not None:
                return f"CHECK-NOT: `{text}` is there"
        elif kind == "CHECK-NEXT":
            place += 1
            if place >= len(lines) or squeeze(text) not in squeeze(lines[place]):
                return f"CHECK-NEXT: `{text}` but there is `{lines[place] if place < len(lines) else 'the end'}`"
        elif kind == "CHECK":
            found = find(lines, place + 1, text)
            if found is None:
                return f"CHECK: `{text}` is not in the output behind line {place + 1}:\n{output}"
            place = found
    return None


NAMES = {"sqrt": math.sqrt, "pi": math.pi, "atan": math.atan}


def check_values(arelem, program, wanted):
    """Compares with `arelem geometry`. Expressions are sums and products of numbers and NAMES."""
    done = subprocess.run([arelem, "geometry", "--json", str(program)], capture_output=True, text=True, timeout=120)
    if not done.stdout.startswith("["):
        return f"VALUES: {done.stderr}"
    found = {}
    for entry in json.loads(done.stdout):
        subscript = f"({entry['subscript']})" if entry["subscript"] else ""
        found[entry["name"] + subscript] = entry["values"]
    for text in wanted:
        name, *numbers = text.split()
        numbers = [eval(n, {"__builtins__": {}, **NAMES}) for n in numbers]
        ours = found.get(name)
        size = max([abs(n) for n in numbers] + [1.0])
        if ours is None or len(ours) != len(numbers) or any(abs(a - b) > 1e-9 * size for a, b in zip(ours, numbers)):
            return f"VALUES: {name} is {ours}, not {numbers}"
    return None


def diagnostics(text):
    return [json.loads(line) for line in text.splitlines() if line.startswith("{")]


def check_messages(program, expected, messages):
    """Every expected message once at its line, and none that is not expected."""
    left = list(expected)
    for m in messages:
        line = m["range"]["start"]["line"] if m["range"] else 0
        match = next((e for e in left if e[0] == line and e[2] == m["code"] and e[3] in m["message"]), None)
        if match:
            left.remove(match)
        elif m["severity"] == "error" or any(e[1] == "warning" for e in expected):
            return f"unexpected {m['severity']}[{m['code']}] in line {line}: {m['message']}"
    return f"missing in line {left[0][0]}: {left[0][1]}[{left[0][2]}]: {left[0][3]}" if left else None


def run(task):
    program, arelem = task
    text = program.read_text()
    expected, directives, runs, values = [], [], [], []
    for number, line in enumerate(text.splitlines(), 1):
        if match := EXPECTED.search(line):
            expected.append((number, *match.groups()))
        if match := DIRECTIVE.search(line):
            kind = match.group(1)
            (runs if kind == "RUN" else values if kind == "VALUES" else directives).append(match.groups())
    with tempfile.TemporaryDirectory() as folder:
        output = ""
        for _, command in runs or [("RUN", "%arelem check %s")]:
            words = [w.replace("%arelem", arelem).replace("%s", str(program)).replace("%t", folder + "/out")
                     for w in shlex.split(command)]
            extra = ["--diagnostics=json"] if words[0] == arelem and words[1] in ("check", "compile", "geometry") else []
            done = subprocess.run(words + extra, capture_output=True, text=True, timeout=120, env={**os.environ, "NO_COLOR": "1"})
            output = done.stdout
    fails = any(e[1] == "error" for e in expected)
    if fails != program.name.startswith("fail_"):
        return "programs with error lines, and no others, are called fail_*.apt"
    if fails != (done.returncode != 0):
        return f"exit code {done.returncode}: {done.stderr}"
    return (check_messages(program, expected, diagnostics(done.stderr)) or check_output(directives, output)
            or (values and check_values(arelem, program, [text for _, text in values])))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--arelem", default=str(HERE.parent.parent / "build" / "arelem"), type=os.path.abspath)
    parser.add_argument("programs", nargs="*", type=pathlib.Path)
    options = parser.parse_args()
    programs = options.programs or sorted(HERE.rglob("*.apt"))
    if not programs:
        sys.exit("there are no golden programs")
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        results = list(pool.map(run, [(p.resolve(), options.arelem) for p in programs]))
    failed = [(p, r) for p, r in zip(programs, results) if r]
    for program, reason in failed:
        print(f"{program}: {reason}")
    print(f"{len(programs)} golden programs, {len(failed)} failed")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
