"""CL records as JSON, from arelem (`--to json`) and from the old system's result files: how to compare them."""
import json
import math


def motions(records):
    """The motions in order: statement number, kind, points with or without axis. A continuation belongs to the last."""
    found = []
    for r in records:
        if r.get("type") != 5000:
            continue
        if r["kind"] == "CONT" and found:
            found[-1]["points"] = found[-1]["points"] + r["points"]
        else:
            found.append({"isn": r["isn"], "kind": r["kind"], "name": r.get("name"), "points": list(r["points"])})
    return found


def others(records):
    """Every record that is no motion, and no note of the processor about itself, in a comparable form."""
    found = []
    for r in records:
        if r["type"] in (5000, 13000):
            continue
        word = {"OPSKIP": "DELETE"}.get(r.get("word"), r.get("word"))  # one code, two names
        found.append((r["type"], r["sub"], r["isn"], r["kind"], word,
                      text(r.get("text")), *flat({k: v for k, v in r.items() if k in FIELDS})))
    return found


FIELDS = ("args", "values", "canon", "surf", "name", "role", "matrix", "copy", "on", "unit")


def text(value):
    """The old system shows texts in upper case and cuts them at 66 characters."""
    return None if value is None else value.upper().rstrip()[:66].rstrip()


def flat(value):
    if isinstance(value, dict):
        return [item for key in sorted(value) for item in (key, *flat(value[key]))]
    if isinstance(value, list):
        return [item for v in value for item in flat(v)]
    return [value]


def same(a, b, relative=1e-9):
    """Equal words, and numbers to `relative` (or absolutely, near zero)."""
    if isinstance(a, (int, float)) and isinstance(b, (int, float)) and not isinstance(a, bool):
        return abs(a - b) <= relative * max(1.0, abs(a), abs(b))
    return (a or None) == (b or None)


def same_rows(a, b):
    return len(a) == len(b) and all(same(x, y) for x, y in zip(a, b))


def first_difference(ours, theirs):
    """None, or a sentence on the first record that differs."""
    for i, (a, b) in enumerate(zip(ours, theirs)):
        if not same_rows(a, b):
            return f"record {i + 1}: {json.dumps(a)} instead of {json.dumps(b)}"
    if len(ours) != len(theirs):
        longer = ours if len(ours) > len(theirs) else theirs
        extra = json.dumps(longer[min(len(ours), len(theirs))])
        return f"{len(ours)} records instead of {len(theirs)}, first extra {extra}"
    return None


def end_distance(a, b):
    """Distance of the end positions of two motions; axes count with their angle."""
    p, q = a["points"][-1], b["points"][-1]
    return max(math.dist(p[:3], q[:3]), math.dist(p[3:], q[3:]) if len(p) == len(q) else math.inf)


def cut_vectors(records):
    return sum(len(m["points"]) for m in motions(records))
