"""Is every point of a path within the tolerances of its drive and part surface? Measured with surfaces.py alone."""
import numpy as np

import cutter as cutters
import surfaces

# Slack for what a path may exceed its band by: rounding of coordinates, and the placing of end points.
SLACK = 1e-6
UPRIGHT = (0.0, 0.0, 1.0)


def resolve(demanded, position):
    if demanded is None:
        return surfaces.Plane([0.0, 0.0, 1.0, 0.0])
    if demanded == "AUTOPS":
        return surfaces.Plane([0.0, 0.0, 1.0, position[2]])
    return surfaces.surface(*demanded)


def measure(demands, motions):
    """Rows of what was measured, and the reasons for paths that were not.

    A row: statement, surface role, points, worst inside and outside, band, worst inside and outside of the chords'
    middles. `motions` are those of arelem's records, in order, and `demands` what the program asks of each.
    """
    rows, skipped = [], []
    last = None
    for motion, demand in zip(motions, demands, strict=True):
        points = motion["points"]
        if demand and last is not None:
            for role in ("drive", "part"):
                row = measure_one(demand, role, motion["isn"], last, points)
                (skipped if isinstance(row, str) else rows).append(row)
        last = points[-1]
    return rows, skipped


def tool(demand, role, on):
    """The cutter that a surface sees, None for the tool end alone, and the thickness that is left on it."""
    index = {"part": 0, "drive": 1, "check": 2}[role]
    disk = demand["disks"].get(index + 1)
    body = None if on else cutters.Disk(*disk) if disk else cutters.Cutter(demand["cutter"])
    return body, demand["thick"][index]


def locations(points):
    ends = np.array([p[:3] for p in points])
    return ends, surfaces.unit([p[3:6] if len(p) > 3 else UPRIGHT for p in points])


def measure_one(demand, role, isn, before, points):
    index = 1 if role == "drive" else 0
    surf = resolve(demand[role], before)
    if surf is None:
        return f"statement {isn}: {role} surface {demand[role][:1]}"
    on = demand["on"] if role == "drive" else demand["on_part"]
    if demand["cutter"] is None:
        return f"statement {isn}: cutter"
    path, axes = locations([before] + points)
    ends = np.concatenate([path[1:], 0.5 * (path[1:] + path[:-1])])
    turned = np.concatenate([axes[1:], surfaces.unit(axes[1:] + axes[:-1])])
    # Positive outside (metal left), negative inside. The side is that of the ends: a thin cutter may lie beyond the
    # surface between them.
    body, thick = tool(demand, role, on)
    off = surf.distance(ends) if on else body.gaps(ends, turned, surf, body.side(path[1:], axes[1:], surf)) - thick
    at_points, at_middles = off[:len(points)], off[len(points):]
    return {"isn": isn, "role": role, "points": len(points), "low": at_points.min(), "high": at_points.max(),
            "middle_low": at_middles.min(), "middle_high": at_middles.max(), "inner": demand["inner"][index],
            "outer": demand["outer"][index], "on": on, "word": demand["word"]}


def from_exact_stop(demand, before, points):
    """How far each of the locations is from touching drive, part and check surface exactly: the root of the sum of
    the squared gaps. None where a surface is not known to these tests or the check is a tangency."""
    if demand is None or demand["touch"] or demand["check"] is None or demand["cutter"] is None:
        return None
    ends, axes = locations(points)
    square = np.zeros(len(points))
    for role, on in (("drive", demand["on"]), ("part", demand["on_part"]), ("check", demand["check_on"])):
        surf = resolve(demand[role], before)
        if surf is None:
            return None
        body, thick = tool(demand, role, on)
        gaps = surf.distance(ends) if on else body.gaps(ends, axes, surf, body.side(ends, axes, surf)) - thick
        square += gaps ** 2
    return np.sqrt(square)


def violation(row):
    """How far the points or the middles of the chords of a row leave their band; 0 when they keep it. A tool ON a
    surface may be off either way."""
    inner = max(row["inner"], row["outer"]) if row["on"] else row["inner"]
    outer = max(row["inner"], row["outer"]) if row["on"] else row["outer"]
    excess = max(-min(row["low"], row["middle_low"]) - inner, max(row["high"], row["middle_high"]) - outer)
    return excess if excess > SLACK else 0.0
