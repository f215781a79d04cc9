#!/usr/bin/env python3
"""Runs every example of the manual: the pages of diagnostics, and fenced `apt` blocks of all other pages.

A fence's first line says what is expected:
  ```apt wrong [options]    the program must give the page's code, and no other error
  ```apt right [options]    the program must be clean: no error, no warning
  ```apt                    (other pages) the program must compile without an error
Options are those of the command; `motion` among them means compile, else check; `also=CODE,...` names errors that
follow from the wrong place. A page for which no program can show
the diagnostic has a block ```sh instead, which is not run, and is listed in EXEMPT with the reason.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

PROJECT = pathlib.Path(__file__).resolve().parents[2]
MANUAL = PROJECT / "docs" / "manual"
# Drawings, meshes and tables that examples of the language name.
DATA = [p for p in (PROJECT / "tests" / "golden" / "reference").iterdir() if p.suffix != ".apt"]
FENCE = re.compile(r"^```apt[ ]*([^\n]*)\n(.*?)^```$", re.M | re.S)

# Diagnostics that no short part program can show, by reason.
REASONS = {
    "bytes that a manual page cannot hold": "E0102 W0103",
    "thousands of elements": "E0111 E0115 E0240",
    "a second file": "E0243 E0245 E0677 E0740 E0741",
    "a line of more than 250 characters": "W0676",
    "curves built in memory; tests/unit/runtime/spline shows them": "E0384 E0385",
    "the command `time`; tests/end_to_end/test_time.py shows it": "E0598 E0396",
    "a file, a folder or a device that cannot be read or written": "E0610 E0611 E0612 E0613 E0701 E0702 E0730 E0731 E0732 E0895",
    "a data file beside the program; tests/unit/runtime/define, geometry and region show them":
        "E0344 E0345 E0346 E0355 E0367 E0368 E0369 E0370 E0371 E0743 W0357",
    "a CL tape; tests/unit/backend and tests/end_to_end show them": "E0602 E0603 E0720 E0721 E0722 E0891 W0604 W0723 W0724 W0725 W0726 W0728 W0729",
    "two files to compare; tests/end_to_end/test_verify.py shows them": "E0901 E0902 E0903 E0920",
    "a path that breaks its program's tolerance; tests/end_to_end/test_certify.py and tests/unit/runtime/certify show them":
        "E0727 E0904 E0905 E0906 E0907 E0908 E0909 E0910 E0911 E0912 E0913 E0914 E0915 E0919 E0928 E0930 E0931 E0932 E0933 E0934 W0916 W0917 W0918",
    "a machine file or a V+ program; tests/unit/backend/robot, tests/unit/backend/vplus and tests/end_to_end/test_robots.py show them":
        "E0388 E0690 W0620 E0621 E0622 E0630 W0631 W0632 E0633 E0605 E0650 E0651 E0652 E0660 E0661 E0662 E0663 E0664 E0665 "
        "E0666 E0634 E0635 E0636 E0637 E0626 E0627 W0684 E0926 E0927 E0922 E0923 E0924 E0680 E0681 E0682 E0683 E0684 E0685 E0686 W0687 E0689",
    "a machine file or a G97 program; tests/unit/backend/g97 and tests/end_to_end/test_g97.py show them":
        "E0640 E0641 E0642 E0643 E0644 E0645 E0646 E0647 W0640 W0641 W0642 W0643 W0644 E0667 E0921 E0925",
    "a signal; tests/end_to_end/test_faults.py sends it": "E0810 E0811 E0890",
    "a program built in memory: the front end refuses the text first; tests/unit/runtime shows them":
        "E0407 E0408 E0410 E0411 E0412 E0414 E0416 E0417 E0419 E0420 E0421 E0422 E0423 E0424 E0425 E0426 E0429 "
        "E0430 E0432 E0433 E0435 E0441 E0451 E0465 E0467 W0468 E0475 E0501 E0802 E0804 E0805",
    "what Section 1 refuses before the motion or Section 3 sees it": "E0482 E0483 E0485 E0514 E0515 E0523 E0524",
    "a search that fails for rare data only": "E0340 E0512 E0541",
    "a command of the REPL; tests/end_to_end/test_repl.py shows it": "E0341",
    "told by `arelem spray`; tests/end_to_end/test_spray.py shows it": "W0353",
    "what is not computed yet: the message names it": "E0473",
}
EXEMPT = {code: reason for reason, codes in REASONS.items() for code in codes.split()}


def rows(arelem):
    listed = subprocess.run([arelem, "explain", "--list"], capture_output=True, text=True, check=True).stdout
    return [line.split()[0] for line in listed.splitlines()]


def run(arelem, text, options):
    words = options.split()
    command = "compile" if "motion" in words else "check"
    words = [w for w in words if w != "motion" and not w.startswith("also=")]
    with tempfile.TemporaryDirectory() as folder:
        program = pathlib.Path(folder) / "example.apt"
        program.write_text(text)
        for data in DATA:
            shutil.copy(data, folder)
        done = subprocess.run([arelem, command, str(program), "--diagnostics=json", *words], capture_output=True, text=True,
                              timeout=60, cwd=folder)
    messages = [json.loads(line) for line in done.stderr.splitlines() if line.startswith("{")]
    return done.returncode, messages


def told(messages):
    return ", ".join(f"{m['code']} {m['message']}" for m in messages) or "nothing"


def try_example(task):
    arelem, page, code, head, text = task
    kind, _, options = head.partition(" ")
    if kind not in ("wrong", "right"):
        options = head  # other pages: all words are options
    exit_code, messages = run(arelem, text, options)
    if kind == "wrong":
        codes = {m["code"] for m in messages}
        also = re.findall(r"also=(\S+)", options)
        others = {c for c in codes if c.startswith("E")} - {code, *(also[0].split(",") if also else [])}
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
        return [f"{page.name}: exempt, but it has an example"] if kinds else []
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
    problems += [f"{code}: exempt twice" for code in EXEMPT if sum(code in c.split() for c in REASONS.values()) > 1]
    for problem in problems:
        print(problem)
    print(f"{len(pages)} diagnostics, {len(tasks)} examples run, {len(EXEMPT)} exempt, {len(problems)} problems")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
