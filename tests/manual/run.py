#!/usr/bin/env python3
"""Runs every example of the manual: the pages of diagnostics, and fenced `apt` blocks of all other pages.

A fence's first line says what is expected:
  ```apt wrong [options]    the program must give the page's code, and no other error
  ```apt right [options]    the program must be clean: no error, no warning
  ```apt                    (other pages) the program must compile without an error
Options are those of the command; `motion` among them means compile, else check. A page for which no program can show
the diagnostic has a block ```sh instead, which is not run, and is listed in EXEMPT with the reason.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

PROJECT = pathlib.Path(__file__).resolve().parents[2]
MANUAL = PROJECT / "docs" / "manual"
FENCE = re.compile(r"^```apt[ ]*([^\n]*)\n(.*?)^```$", re.M | re.S)

# Diagnostics that no part program alone can cause.
EXEMPT = {}


def rows(arelem):
    listed = subprocess.run([arelem, "explain", "--list"], capture_output=True, text=True, check=True).stdout
    return [line.split()[0] for line in listed.splitlines()]


def run(arelem, text, options):
    words = options.split()
    command = "compile" if "motion" in words else "check"
    words = [w for w in words if w != "motion"]
    with tempfile.TemporaryDirectory() as folder:
        program = pathlib.Path(folder) / "example.apt"
        program.write_text(text)
        done = subprocess.run([arelem, command, str(program), "--diagnostics=json", *words], capture_output=True, text=True,
                              timeout=60, cwd=folder)
    messages = [json.loads(line) for line in done.stderr.splitlines() if line.startswith("{")]
    return done.returncode, messages


def told(messages):
    return ", ".join(f"{m['code']} {m['message']}" for m in messages) or "nothing"


def try_example(task):
    arelem, page, code, head, text = task
    kind, _, options = head.partition(" ")
    exit_code, messages = run(arelem, text, options)
    if kind == "wrong":
        codes = {m["code"] for m in messages}
        others = {c for c in codes if c.startswith("E")} - {code}
        if code not in codes or others:
            return f"{page.name}: the wrong example gives {told(messages)}"
    elif kind == "right":
        if messages or exit_code:
            return f"{page.name}: the right example gives {told(messages)} (exit {exit_code})"
    elif exit_code:
        return f"{page.name}: an example gives {told(messages)} (exit {exit_code})"
    return None


def check_page(code, page):
    """A page must show both sides, or be exempt."""
    text = page.read_text()
    if not text.startswith(f"# {code}: "):
        return [f"{page.name}: begins with `# {code}: title`"]
    kinds = [head.split(" ")[0] for head, _ in FENCE.findall(text)]
    if code in EXEMPT:
        return []
    return [f"{page.name}: has no {kind} example" for kind in ("wrong", "right") if kind not in kinds]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--arelem", default=str(PROJECT / "build" / "arelem"), type=os.path.abspath)
    parser.add_argument("--only", default="")
    options = parser.parse_args()
    problems, tasks = [], []
    pages = {code: MANUAL / "diagnostics" / f"{code}.md" for code in rows(options.arelem)}
    for code, page in pages.items():
        if not page.exists():
            problems.append(f"{code}: there is no page docs/manual/diagnostics/{code}.md")
            continue
        problems += check_page(code, page)
    for page in MANUAL.rglob("*.md"):
        if page.parent.name == "diagnostics" and page.stem not in pages:
            problems.append(f"{page.name}: there is no such diagnostic")
        for head, text in FENCE.findall(page.read_text()):
            tasks.append((options.arelem, page, page.stem, head, text))
    tasks = [t for t in tasks if options.only in t[2]]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        problems += [p for p in pool.map(try_example, tasks) if p]
    problems += [f"{code}: exempt, but there is no such diagnostic" for code in EXEMPT if code not in pages]
    for problem in problems:
        print(problem)
    print(f"{len(pages)} diagnostics, {len(tasks)} examples run, {len(EXEMPT)} exempt, {len(problems)} problems")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
