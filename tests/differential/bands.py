"""Is every point of a path within the tolerances of its drive and part surface? Measured with surfaces.py alone."""
import part_program
import surfaces

# Slack for what a path may exceed its band by: rounding of coordinates, and the placing of end points.
SLACK = 1e-6
UPRIGHT = (0.0, 0.0, 1.0)


def deviation(cutter, end, axis, surf, on, thick):
    """Signed deviation from the wanted relation: positive outside (metal left), negative inside."""
    if on:
        return surf.distance(end)
    return cutter.gap(end, axis, surf) - thick


def resolve(name, entities, position):
    if name is None:
        return surfaces.Plane([0.0, 0.0, 1.0, 0.0])
    if name == "AUTOPS":
        return surfaces.Plane([0.0, 0.0, 1.0, position[2]])
    entity = entities.get(name)
    return surfaces.surface(*entity) if entity else None


def middle(p, q):
    return tuple(0.5 * (a + b) for a, b in zip(p, q))


def measure(source, entities, scalars, motions):
    """Rows of what was measured, and the reasons for motions that were not.

    A row: (statement, surface role, points, worst inside, worst outside, band, worst inside and outside of chord
    middles). `motions` are those of arelem's records, in order.
    """
    wanted = part_program.demands(source, scalars)
    rows, skipped = [], []
    last = None
    for motion in motions:
        demand = wanted.get(motion["isn"])
        points = motion["points"]
        if demand and last is not None:
            for role in ("drive", "part"):
                row = measure_one(demand, role, motion["isn"], entities, last, points)
                (skipped if isinstance(row, str) else rows).append(row)
        last = points[-1]
    return rows, skipped


def measure_by_names(records, entities):
    """The same for programs with loops and calls, whose text is not followed: the drive surface is the one that the
    records name, with the cutter and tolerances that stand before them. Nothing where records are transformed, and no
    TABCYL: its distance takes too long here for the many points of such programs."""
    rows = []
    if any(r.get("word") in ("TRACUT", "COPY") for r in records):
        return rows
    entities = {name: e for name, e in entities.items() if e[0] != "TABCYL"}
    cutter, inner, outer, last, run = None, 0.0, 0.0005, None, None

    def close():
        if run and len(run["points"]) > 1 and cutter and last:
            demand = {"drive": run["name"], "on": cutter[0] == 0.0, "on_part": False, "cutter": cutter, "option": False,
                      "thick": [0.0, 0.0], "inner": [inner, inner], "outer": [outer, outer], "word": "by name"}
            row = measure_one(demand, "drive", run["isn"], entities, last, run["points"])
            if not isinstance(row, str):
                rows.append(row)

    for record in records:
        if record["kind"] == "CONT":
            run["points"] += record["points"]
            continue
        close()
        last = run["points"][-1] if run else last
        run = None
        if record["kind"] in ("GOTO", "FROM"):
            run = {"name": record["name"], "isn": record["isn"], "points": list(record["points"])}
        elif record["kind"] == "CUTTER":
            cutter = record["values"]
        elif record["kind"] in ("INTOL", "OUTTOL"):
            inner, outer = (record["values"][0], outer) if record["kind"] == "INTOL" else (inner, record["values"][0])
    close()
    return rows


def measure_one(demand, role, isn, entities, before, points):
    index = 1 if role == "drive" else 0
    surf = resolve(demand[role], entities, before)
    if surf is None:
        return f"statement {isn}: {role} surface {demand[role]}"
    on = demand["on"] if role == "drive" else demand["on_part"]
    if demand["cutter"] is None or (demand["option"] and not on):
        return f"statement {isn}: cutter"
    cutter = surfaces.Cutter(demand["cutter"])
    thick = demand["thick"][index]

    def off(p):
        axis = surfaces.unit(p[3:6]) if len(p) > 3 else UPRIGHT
        return deviation(cutter, tuple(p[:3]), axis, surf, on, thick)

    at_points = [off(p) for p in points]
    path = [before] + points
    at_middles = [off(middle(p, q)) for p, q in zip(path, path[1:])] if len(points) <= 400 else []
    return {"isn": isn, "role": role, "points": len(points), "low": min(at_points), "high": max(at_points),
            "middle_low": min(at_middles, default=0.0), "middle_high": max(at_middles, default=0.0),
            "inner": demand["inner"][index], "outer": demand["outer"][index], "on": on, "word": demand["word"]}


def violation(row):
    """How far the points of a row leave their band; 0 when they keep it. A tool ON a surface may be off either way."""
    inner = max(row["inner"], row["outer"]) if row["on"] else row["inner"]
    outer = max(row["inner"], row["outer"]) if row["on"] else row["outer"]
    excess = max(-row["low"] - inner, row["high"] - outer)
    return excess if excess > SLACK else 0.0
