#!/usr/bin/env python3
"""What is written as CL text, tape or JSON is the same program when it is read again: every example and every file of the
collection (ARELEM_SHARED; read in place), compared record by record."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

from arelem_run import ARELEM, PROJECT

SHARED = pathlib.Path(os.environ.get("ARELEM_SHARED", PROJECT.parent / "shared"))
# Applied already when the text was written, where they are comments.
# The side of a spray gun has no place on a tape: W0604.
WITH_SIDES = {"ahead.apt", "plate_paint.apt", "right_turn.apt", "school_xing.apt", "stop.apt", "door_paint.apt", "sen_plane.apt",
              "sen_half_cylinder.apt", "sen_revolved.apt"}
APPLIED = {"TRACUT", "COPY", "INDEX", "SMOOTH", "VTLAXS", "WCORN"}
# Words with one number on a tape.
SAME = {"CW": "CLW", "CCW": "CCLW", "OPSKIP": "DELETE"}
LARGE = 400_000  # bytes; larger files say nothing that smaller ones do not


def programs():
    rows = sorted((PROJECT / "examples").glob("*.apt"))
    folders = ("aptos-apt360", "aamorim-aptpost", "alexandrums-catia", "karlo-catia", "hofft-creopost", "s2538-creo", "humman-clsf",
               "steptools-stepnode", "kuka-fdm", "web")
    for folder in folders:
        rows += sorted(p for p in (SHARED / "corpus" / folder).glob("*") if p.is_file() and p.stat().st_size < LARGE)
    return rows


def run(*words):
    done = subprocess.run([ARELEM, *map(str, words)], capture_output=True, timeout=120)
    return done.returncode, done.stdout.decode(errors="replace"), done.stderr.decode(errors="replace")


def meaning(lines):
    """What a machine would do: places with axes and ways, words with parameters, texts, switches; in order. Names of points
    and surfaces, statement numbers and how places are grouped into records are not in CL text."""
    out, axis, circle = [], False, None
    for line in lines:
        r = json.loads(line)
        kind = r["kind"]
        if kind == "SURFACE":
            circle = r["canon"]
        elif "points" in r:
            way = r.get("way", "")
            for p in r["points"]:
                axis = axis or len(p) > 3
                out.append(("FROM" if kind == "FROM" else "GOTO", [*p], way, circle if way and circle else []))
            circle = None
        elif kind == "POST" and "text" in r:
            text = r["text"].strip()
            out.append((r["word"], text[1:].strip() if text.startswith("/") and r["word"] != "INSERT" else text))
        elif kind == "POST" and r["word"] not in APPLIED:
            # A surface of CLRSRF has no name in CL text.
            args = [SAME.get(a, a) if isinstance(a, str) else a for a in r.get("args", [])]
            args = ["surface", *args[2:]] if r["word"] in ("CLRSRF", "CLEARP") and len(args) > 5 else args
            out.append((SAME.get(r["word"], r["word"]), args))
        elif kind in ("CUTTER", "INTOL", "OUTTOL"):
            out.append((kind, tuple(r["values"])))
        elif kind in ("MULTAX", "UNITS"):
            out.append((kind, r.get("on"), r.get("unit")))
    return out


def near(a, b):
    """Equal; numbers up to the last digits of CL text."""
    if isinstance(a, (list, tuple)) and isinstance(b, (list, tuple)):
        return len(a) == len(b) and all(near(x, y) for x, y in zip(a, b))
    if isinstance(a, (int, float)) and isinstance(b, (int, float)):
        return abs(a - b) <= 1e-9 * max(1.0, abs(a))
    return a == b


def first_difference(wanted, found):
    for i, (a, b) in enumerate(zip(wanted, found)):
        if not near(a, b):
            return f"{i}: {a} became {b}"
    return "" if len(wanted) == len(found) else f"{len(wanted)} became {len(found)}: {(wanted + found)[min(len(wanted), len(found))]}"


class Reread(unittest.TestCase):
    def test_text_tape_and_json_come_back_as_the_same_program(self):
        compared = 0
        for path in programs():
            with self.subTest(path.name), tempfile.TemporaryDirectory() as folder:
                first = pathlib.Path(folder) / "first"
                code, _, told = run("compile", path, "--to", "json", "--to", "cl", "--to", "cltape", "--out-dir", first)
                if code in (1, 4):
                    continue  # docs/manual/corpus.md tells of them
                self.assertEqual(code, 0, told)
                wrote = {p.suffix: p for p in first.iterdir()}
                wanted = meaning(wrote[".jsonl"].read_text().splitlines())
                for suffix, input_ in wrote.items():
                    if suffix == ".cltape" and path.name in WITH_SIDES:
                        continue
                    again = pathlib.Path(folder) / ("again" + suffix)
                    dialect = ("--dialect", "cl") if suffix == ".cls" else ()
                    code, _, told = run("compile", input_, *dialect, "--to", "json", "--out-dir", again)
                    self.assertEqual(code, 0, told)
                    found = meaning(next(again.iterdir()).read_text().splitlines())
                    self.assertEqual(first_difference(wanted, found), "", suffix)
                compared += 1
        self.assertGreater(compared, 15)


if __name__ == "__main__":
    unittest.main()
