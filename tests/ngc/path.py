"""Tool paths from canonical calls and from CL records, and their comparison. Lengths as in the output."""
import json
import math


class Move:
    """A straight move or an arc to `end`; `axes` are A, B, C; feed None when rapid."""

    def __init__(self, start, end, axes, feed, arc=None):
        self.start, self.end, self.axes, self.feed, self.arc = start, end, axes, feed, arc

    def samples(self, count=1000):
        if self.arc is None:
            return [self.start, self.end]
        (u, v, w), center, sweep = self.arc
        du, dv = self.start[u] - center[0], self.start[v] - center[1]
        points = []
        for i in range(count + 1):
            a = sweep * i / count
            p = [0.0, 0.0, 0.0]
            p[u] = center[0] + du * math.cos(a) - dv * math.sin(a)
            p[v] = center[1] + du * math.sin(a) + dv * math.cos(a)
            p[w] = self.start[w] + (self.end[w] - self.start[w]) * i / count
            points.append(tuple(p))
        return points


# First, second and third coordinate of each plane.
PLANES = {"CANON_PLANE_XY": (0, 1, 2), "CANON_PLANE_XZ": (2, 0, 1), "CANON_PLANE_YZ": (1, 2, 0)}


def canonical_moves(calls):
    """Lengths in mm, feeds in mm a minute."""
    moves, at, feed, plane, unit = [], (0.0, 0.0, 0.0), 0.0, PLANES["CANON_PLANE_XY"], 1.0
    for name, words in calls:
        if name == "SELECT_PLANE":
            plane = PLANES[words[0]]
        elif name == "USE_LENGTH_UNITS":
            unit = 25.4 if words[0] == "CANON_UNITS_INCHES" else 1.0
        elif name == "SET_FEED_RATE":
            feed = float(words[0]) * unit
        elif name in ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED"):
            numbers = [float(w) for w in words]
            end = tuple(unit * x for x in numbers[:3])
            moves.append(Move(at, end, numbers[3:], feed if name == "STRAIGHT_FEED" else None))
            at = end
        elif name == "ARC_FEED":
            first, second, c1, c2, turns, third = (float(w) * unit for w in words[:6])
            u, v, w = plane
            end = [0.0, 0.0, 0.0]
            end[u], end[v], end[w] = first, second, third
            a = math.atan2(at[v] - c2, at[u] - c1)
            sweep = math.atan2(second - c2, first - c1) - a
            while turns > 0 and sweep <= 0:
                sweep += 2 * math.pi
            while turns < 0 and sweep >= 0:
                sweep -= 2 * math.pi
            moves.append(Move(at, tuple(end), [float(x) for x in words[6:]], feed, (plane, (c1, c2), sweep)))
            at = tuple(end)
    return moves


class Location:
    """A place of the CL; `hole` is (depth, clearance, feed, whether the tool feeds out
    again) under a canned cycle, `band` INTOL + OUTTOL in force."""

    def __init__(self, place, rapid, feed, hole, band):
        self.place, self.rapid, self.feed, self.hole, self.band = place, rapid, feed, hole, band


def cl_locations(text):
    """Every location but FROM."""
    rapid, feed, hole, tolerances, out = False, None, None, {"INTOL": 0.0, "OUTTOL": 0.0005}, []
    cycle = None  # the last one, which ON takes up again behind NOMORE
    for line in text.splitlines():
        record = json.loads(line)
        kind = record["kind"]
        if kind == "POST":
            if record["word"] == "RAPID":
                rapid = True
            elif record["word"] == "FEDRAT":
                feed = next(a for a in record["args"] if not isinstance(a, str)) * (60 if "MMPS" in record["args"] else 1)
            elif record["word"] == "CYCLE":
                numbers = [a for a in record["args"] if not isinstance(a, str)]
                if numbers:
                    cycle = (abs(numbers[0]), numbers[2], numbers[1], "TAP" in record["args"])
                hole = cycle if numbers or "ON" in record["args"] else None
        elif kind in tolerances:
            tolerances[kind] = abs(record["values"][0])
        elif kind in ("GOTO", "CONT"):
            for p in record["points"]:
                out.append(Location(tuple(p[:3]), rapid, hole[2] if hole else feed, hole, sum(tolerances.values())))
            rapid = False
    return out


def distance(a, b):
    return math.dist(a, b)


def to_segment(p, a, b):
    along = [y - x for x, y in zip(a, b)]
    square = sum(x * x for x in along)
    s = 0.0 if square == 0 else max(0.0, min(1.0, sum((q - x) * d for q, x, d in zip(p, a, along)) / square))
    return distance(p, [x + s * d for x, d in zip(a, along)])


def to_polyline(p, points):
    return min(to_segment(p, a, b) for a, b in zip(points, points[1:]))


def compare(moves, locations, resolution, arc_tolerance):
    """Problems, as text. Each move ends in a location, an arc passes the locations before it, and under a cycle each
    location is drilled."""
    problems, at, moves = [], None, iter(moves)
    pending, waiting = None, []  # a move, and the locations that it has to pass
    for location in locations:
        if location.hole is not None:
            at = drill(moves, location, resolution, problems)
            continue
        if at is not None and not waiting and distance(location.place, at) <= resolution:
            continue  # nothing moved, nothing is written
        waiting.append(location)
        move = pending = pending or next(moves, None)
        if move is None:
            problems.append(f"location {location.place} is not in the output")
            break
        if distance(location.place, move.end) > resolution:
            if move.arc is None:
                problems.append(f"location {location.place}: the move ends at {move.end}")
                break
            continue
        check(move, waiting, at, resolution, arc_tolerance, problems)
        at, pending, waiting = location.place, None, []
    if waiting and not problems:
        problems.append(f"location {waiting[0].place} is not in the output")
    rest = list(moves)
    if rest and not problems:
        problems.append(f"{len(rest)} moves more than the CL has, the first to {rest[0].end}")
    return problems


def drill(moves, location, resolution, problems):
    """Takes the moves of one hole; the tool is then at the clearance above it."""
    x, y, z = location.place
    depth, clear, _, feeds_out = location.hole
    top, bottom = (x, y, z + clear), (x, y, z - depth)
    drilled = False
    for move in moves:
        if move.feed is not None:
            drilled = drilled or distance(move.end, bottom) <= resolution
            if abs(move.end[0] - x) + abs(move.end[1] - y) > resolution or abs(move.feed - location.feed) > 1e-3:
                problems.append(f"hole {location.place}: a feed move to {move.end} at {move.feed}")
        if (move.feed is None) != feeds_out and drilled and distance(move.end, top) <= resolution:
            return top
    problems.append(f"hole {location.place} is not drilled to {bottom} and left to {top}")
    return top


def check(move, passed, at, resolution, arc_tolerance, problems):
    location = passed[-1]
    if location.rapid != (move.feed is None):
        problems.append(f"location {location.place}: rapid {location.rapid}, feed in the output {move.feed}")
    if not location.rapid and abs(location.feed - move.feed) > 1e-3:
        problems.append(f"location {location.place}: feed {location.feed}, in the output {move.feed}")
    if move.arc is None:
        return
    path, places = move.samples(), [one.place for one in passed]
    for p in places:
        if to_polyline(p, path) > arc_tolerance:
            problems.append(f"location {p} is {to_polyline(p, path):.6f} off the arc to {move.end}")
    off = max(to_polyline(p, [at, *places]) for p in path)
    if off > location.band + arc_tolerance:
        problems.append(f"the arc to {move.end} leaves the cut vectors by {off:.6f}")
