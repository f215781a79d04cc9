"""Writes drawings of random loops by ezdxf: random_drawings.py FOLDER COUNT SEED. Prints name and area (mm2) of each.

A loop is a polygon about a center whose edges are straight, arcs, half ellipses or cubics that bulge outward a little;
its area is that of the polygon and of what its edges add, by formulas. Edges come in any order, direction and kind
of entity, on mirrored planes too. Decoys lie in blocks and on other layers.
"""
import math
import pathlib
import random
import sys

import ezdxf

UNITS = {1: 25.4, 4: 1.0, 5: 10.0, 6: 1000.0}
MIRROR = (0, 0, -1)


def bulge_area(a, b, bulge):
    angle = 4 * math.atan(bulge)
    radius = math.dist(a, b) * (1 + bulge * bulge) / (4 * bulge)
    return radius * radius * (angle - math.sin(angle)) / 2


def arc_of(a, b, bulge):
    height = (1 - bulge * bulge) / (4 * bulge)
    center = ((a[0] + b[0]) / 2 - height * (b[1] - a[1]), (a[1] + b[1]) / 2 + height * (b[0] - a[0]))
    return center, *(math.degrees(math.atan2(p[1] - center[1], p[0] - center[0])) for p in (a, b))


def cubic_of(a, b, out):
    """Control points; both inner ones lie `out` times the length outside."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    return [a, *((a[0] + t * dx + out * dy, a[1] + t * dy - out * dx) for t in (1 / 3, 2 / 3)), b]


def add_edge(space, chance, kind, a, b, at):
    """Returns the area between the edge and its chord."""
    length = math.dist(a, b)
    if kind == "line":
        a, b = (a, b) if chance.random() < .5 else (b, a)
        space.add_line(a, b, dxfattribs=at)
        return 0.0
    if kind == "cubic":
        points = cubic_of(a, b, .1)
        if chance.random() < .5:
            points.reverse()
        space.add_open_spline([(*p, 0) for p in points], 3, dxfattribs=at)
        return .1 * length * length / 2  # y = 3 t (1 - t) height over a straight x
    if kind == "ellipse":
        ratio = chance.uniform(.05, .15)
        center = ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
        arm = (a[0] - center[0], a[1] - center[1])
        if chance.random() < .5:
            space.add_ellipse(center, arm, ratio, 0, math.pi, dxfattribs=at)
        else:  # seen from below it runs the other way round
            space.add_ellipse(center, (-arm[0], -arm[1]), ratio, 0, math.pi, dxfattribs={**at, "extrusion": MIRROR})
        return math.pi / 2 * ratio * (length / 2) ** 2
    bulge = chance.uniform(.03, .15)
    center, start, end = arc_of(a, b, bulge)
    if kind == "arc":
        if chance.random() < .5:
            space.add_arc(center, math.dist(center, a), start, end, dxfattribs=at)
        else:
            space.add_arc((-center[0], center[1]), math.dist(center, a), 180 - end, 180 - start, dxfattribs={**at, "extrusion": MIRROR})
    elif kind == "polyline":
        space.add_polyline2d([(*a, 0, 0, bulge), b], format="xyseb", dxfattribs=at)
    elif chance.random() < .5:
        space.add_lwpolyline([(*a, bulge), b], format="xyb", dxfattribs=at)
    else:
        space.add_lwpolyline([(-a[0], a[1], -bulge), (-b[0], b[1])], format="xyb", dxfattribs={**at, "extrusion": MIRROR})
    return bulge_area(a, b, bulge)


def loop(chance, center, size):
    n = chance.randint(4, 9)
    turn = chance.uniform(0, 6)
    return [(center[0] + size * r * math.cos(turn + 2 * math.pi * i / n), center[1] + size * r * math.sin(turn + 2 * math.pi * i / n))
            for i, r in ((i, chance.uniform(.85, 1)) for i in range(n))]


def add_loop(space, chance, kinds, center, size, at):
    corners = loop(chance, center, size)
    edges = list(zip(corners, corners[1:] + corners[:1]))
    area = sum(a[0] * b[1] - b[0] * a[1] for a, b in edges) / 2
    if chance.random() < .15:  # a polyline of the whole loop
        area += sum(bulge_area(a, b, .1) for a, b in edges)
        space.add_lwpolyline([(*a, .1) for a in corners], format="xyb", close=True, dxfattribs=at)
        return area
    chance.shuffle(edges)
    return area + sum(add_edge(space, chance, chance.choice(kinds), a, b, at) for a, b in edges)


def drawing(chance, path):
    version = chance.choice(["R12", "R2000", "R2007", "R2018"])
    unit = 4 if version == "R12" else chance.choice(list(UNITS))  # old drawings state none
    doc = ezdxf.new(version)
    doc.header["$INSUNITS"] = unit
    space = doc.modelspace()
    at = {"layer": "paint"}
    kinds = ["line", "arc", "polyline"] if version == "R12" else ["line", "arc", "polyline", "lwpolyline", "ellipse", "cubic"]
    if version == "R12":
        space.add_lwpolyline = lambda points, format, close=False, dxfattribs=None: space.add_polyline2d(
            points, format=format, close=close, dxfattribs=dxfattribs)
    doc.blocks.new("DECOY").add_circle((3, 3), 1, dxfattribs=at)
    space.add_text("not paint", dxfattribs={"layer": "notes"})
    area = 0.0
    for i in range(chance.randint(1, 3)):
        center = (400 * i + chance.uniform(0, 50), chance.uniform(-100, 100))
        area += add_loop(space, chance, kinds, center, 100, at)
        if chance.random() < .6:
            area -= add_loop(space, chance, kinds, center, 50, at)
        if chance.random() < .3:
            space.add_circle((center[0] + 180, center[1]), 12, dxfattribs=at)
            area += math.pi * 144
    doc.saveas(path)
    return area * UNITS[unit] ** 2, UNITS[unit]


def main():
    folder, count, seed = pathlib.Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
    chance = random.Random(seed)
    for i in range(count):
        area, unit = drawing(chance, folder / f"r{i}.dxf")
        print(f"r{i}.dxf", repr(area), unit)


if __name__ == "__main__":
    main()
