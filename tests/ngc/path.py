"""Tool paths from canonical calls and from CL records, and their comparison. Lengths as in the output."""
import json
import math


class Move:
    """A straight move or an arc to `end`; `axes` are A, B, C; feed None when rapid."""

    def __init__(self, start, end, axes, feed, arc=None):
        self.start, self.end, self.axes, self.feed, self.arc = start, end, axes, feed, arc

    def samples(self, count=64):
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
    moves, at, feed, plane = [], (0.0, 0.0, 0.0), 0.0, PLANES["CANON_PLANE_XY"]
    for name, words in calls:
        if name == "SELECT_PLANE":
            plane = PLANES[words[0]]
        elif name == "SET_FEED_RATE":
            feed = float(words[0])
        elif name in ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED"):
            numbers = [float(w) for w in words]
            end = tuple(numbers[:3])
            moves.append(Move(at, end, numbers[3:], feed if name == "STRAIGHT_FEED" else None))
            at = end
        elif name == "ARC_FEED":
            first, second, c1, c2, turns, third = (float(w) for w in words[:6])
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


def cl_locations(text, with_axis=False):
    """(place, rapid, feed per minute or None, axis) of every location but FROM."""
    rapid, feed, out = False, None, []
    for line in text.splitlines():
        record = json.loads(line)
        kind = record["kind"]
        if kind == "POST":
            if record["word"] == "RAPID":
                rapid = True
            elif record["word"] == "FEDRAT":
                feed = next(a for a in record["args"] if not isinstance(a, str))
        elif kind in ("GOTO", "CONT"):
            for p in record["points"]:
                out.append((tuple(p[:3]), rapid, feed, tuple(p[3:]) or (0.0, 0.0, 1.0)))
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
    """Problems, as text. Each move ends in a location; an arc passes the locations before it."""
    problems, i = [], 0
    at = None
    for move in moves:
        passed = []
        while i < len(locations):
            place = locations[i][0]
            i += 1
            if at is not None and distance(place, at) <= resolution and distance(move.end, at) > resolution:
                continue  # nothing moved, nothing is written
            passed.append(place)
            if distance(place, move.end) <= resolution:
                break
            if move.arc is None:
                problems.append(f"location {i} {place}: the move ends at {move.end}")
                return problems
        else:
            problems.append(f"move to {move.end}: no location left for it")
            return problems
        place, rapid, feed, _ = locations[i - 1]
        if rapid != (move.feed is None):
            problems.append(f"location {i}: rapid {rapid}, feed in the output {move.feed}")
        if not rapid and feed is not None and abs(feed - move.feed) > 1e-3:
            problems.append(f"location {i}: feed {feed}, in the output {move.feed}")
        if move.arc is not None:
            path = move.samples()
            for p in passed:
                if to_polyline(p, path) > arc_tolerance:
                    problems.append(f"location {p} is {to_polyline(p, path):.6f} off the arc to {move.end}")
            for p in path:
                if to_polyline(p, [at, *passed]) > 2 * arc_tolerance + resolution:
                    problems.append(f"the arc to {move.end} leaves the cut vectors at {p}")
                    break
        at = locations[i - 1][0]
    for place, *_ in locations[i:]:
        if at is None or distance(place, at) > resolution:
            problems.append(f"location {place} is not in the output")
    return problems
