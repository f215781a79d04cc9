"""Every kind of surface as part, as drive and as check surface, in every relation.

Each kind is defined through a place with a normal there, and stands in for part, drive and check surface in turn, the others
being planes. The certificate proves all motions; the places of the stops are known with a pencil. Where a definition gives
vertical surfaces only, the tool lies down instead.
"""
import json
import math
import unittest

import moved_surfaces as surfaces
from arelem_run import ArelemCase

BAND = 0.004
CUTTERS = ("1,.5", "1", "1,.2", ".8,.1,.313071,.1,0,8,4", "1,0,0,0,30,0,4")
X, Y, Z = (1, 0, 0), (0, 1, 0), (0, 0, 1)
WAVE = [(-10, 0, -.2), (-6, 0, .1), (-3, 0, -.1), (0, 0, 0), (3, 0, .1), (6, 0, -.2), (10, 0, .1)]


def along(place, direction, way):
    return tuple(a + way * b for a, b in zip(place, direction))


class Frame:
    """A place, the direction that meets `across` and `normal` squarely, and those two. Vertical kinds go up along `across`."""

    def __init__(self, place, first, across, normal):
        self.place, self.first, self.across, self.normal = place, first, across, normal
        self.similarity = surfaces.Similarity(tuple(zip(first, across, normal)), place)

    def at(self, first, normal):
        return along(along(self.place, self.first, first), self.normal, normal)

    def point(self, first, normal):
        return f"(POINT/{surfaces.numbers(self.at(first, normal))})"

    def angle(self, direction):
        return surfaces.number(math.degrees(math.atan2(direction[1], direction[0])))


def anywhere(surface):
    return lambda frame, _: surfaces.define(surface, frame.similarity)


def vertical(text):
    def define(frame, _):
        return text(frame)
    define.vertical = True
    return define


def parabola(frame):
    """normal + 0.04 first^2 = 0 as coefficients of x^2, xy, y^2, x, y, 1."""
    (ux, uy, _), (wx, wy, _), (x, y, _) = frame.first, frame.normal, frame.place
    cu, cw = -(ux * x + uy * y), -(wx * x + wy * y)
    return "GCONIC/" + surfaces.numbers([0.04 * ux * ux, 0.08 * ux * uy, 0.04 * uy * uy, 0.08 * ux * cu + wx,
                                         0.08 * uy * cu + wy, 0.04 * cu * cu + cw])


def lconic(frame):
    return "LCONIC/5PT," + ",".join(frame.point(x, -8 + 8 * math.sqrt(1 - (x / 11) ** 2)) for x in (-7, -3.3, .4, 3.7, 6.9))


def hills():
    """Triangles of 16 x 16 squares over [-10, 10]^2, through the origin."""
    def at(i, j):
        x, y = -10 + 1.25 * i, -10 + 1.25 * j
        return x, y, -0.004 * x * x - 0.003 * y * y + 0.03 * math.sin(x)
    for i in range(16):
        for j in range(16):
            yield at(i, j), at(i + 1, j), at(i + 1, j + 1)
            yield at(i, j), at(i + 1, j + 1), at(i, j + 1)


def mesh_text(form, triangles):
    index = {}
    faces = [[index.setdefault(p, len(index)) for p in t] for t in triangles]
    points = ["%r %r %r" % p for p in index]
    if form == "OBJ":
        return "\n".join(["v " + p for p in points] + ["f %d %d %d" % tuple(i + 1 for i in f) for f in faces]) + "\n"
    rows = points + ["3 %d %d %d" % tuple(f) for f in faces]
    head = (f"OFF\n{len(points)} {len(faces)} 0\n" if form == "OFF" else
            f"ply\nformat ascii 1.0\nelement vertex {len(points)}\nproperty double x\nproperty double y\nproperty double z\n"
            f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
    return head + "\n".join(rows) + "\n"


def mesh(form):
    def define(frame, write):
        move = frame.similarity
        triangles = [[move.point(p) for p in t] for t in hills()]
        if move.mirrors():
            triangles = [t[::-1] for t in triangles]
        text = surfaces.stl(list(hills()), move) if form == "STL" else mesh_text(form, triangles)
        return f"MESH/{form},'{write(text, form.lower())}'"
    return define


RULED = ("RLDSRF", (("CYLNDR", (0, -4, -6), Y, 6), ((-4.5, -4, -2), (4.5, -4, -2), (0, -4, 2))),
         (("CYLNDR", (0, 4, -8), Y, 8), ((-4.5, 4, -2), (4.5, 4, -2), (0, 4, 2))))
SIDE = 10 * math.sin(0.7)
FALL = SIDE * math.tan(0.7)
SHARE = math.cos(0.7) / (1 + math.cos(0.7))
# Arcs of radius 10 that grow along the second direction: the shoulder lies at the origin.
POLCON = ("POLCON", (Y, X, Z), (0, 0, 0), 0, -10, 20,
          [[k, .05 * k] for k in (-SIDE, FALL, -SIDE, -FALL, SIDE)] + [[10 * math.cos(.7) - 10], [.5 * (1 + SHARE)]])

KINDS = {
    "plane": anywhere(("PLANE", Z, 0)),
    "sphere": anywhere(("SPHERE", (0, 0, -9), 9)),
    "sphere from inside": anywhere(("SPHERE", (0, 0, 9), 9)),
    "cylinder across": anywhere(("CYLNDR", (0, 0, -9), Y, 9)),
    "cylinder along": anywhere(("CYLNDR", (0, 0, -9), X, 9)),
    "cylinder from inside": anywhere(("CYLNDR", (0, 0, 9), Y, 9)),
    "cone": anywhere(("CONE", (0, 20, -20 * math.tan(math.radians(20))), (0, -1, 0), 20)),
    "tip of a cone": anywhere(("CONE", (0, 0, 0), (0, 0, -1), 60)),
    "torus from aside": anywhere(("TORUS", (0, 0, -9), Y, 7, 2)),
    "torus from above": anywhere(("TORUS", (0, 7, -2), Z, 7, 2)),
    "ellipsoid": anywhere(("QADRIC", (1 / 64, 1 / 49, 1 / 25, 0, 0, 0, 0, 0, 2 / 5, 0))),
    "hyperboloid": anywhere(("QADRIC", (1 / 64, -1 / 49, 1 / 25, 0, 0, 0, 0, 0, 2 / 5, 0))),
    "saddle": anywhere(("QADRIC", (.03, -.03, 0, 0, 0, 0, 0, 0, 1, 0))),
    "bowl": anywhere(("QADRIC", (.03, .03, 0, 0, 0, 0, 0, 0, -1, 0))),
    "paraboloid": anywhere(("QADRIC", (.03, .03, 0, 0, 0, 0, 0, 0, 1, 0))),
    "TABCYL in space": anywhere(("TABCYL", Y, WAVE)),
    "TABCYL slanted": anywhere(("TABCYL", (.2, 1, .1), WAVE)),
    "RLDSRF": anywhere(RULED),
    "POLCON": anywhere(POLCON),
    "LINE": vertical(lambda f: f"LINE/{f.point(0, 0)},{f.point(1, 0)}"),
    "CIRCLE": vertical(lambda f: f"CIRCLE/CENTER,{f.point(0, -9)},RADIUS,9"),
    "CIRCLE from inside": vertical(lambda f: f"CIRCLE/CENTER,{f.point(0, 9)},RADIUS,9"),
    "ELLIPS": vertical(lambda f: f"ELLIPS/CENTER,{f.point(0, -6)},9,6,{f.angle(f.first)}"),
    "ELLIPS from inside": vertical(lambda f: f"ELLIPS/CENTER,{f.point(0, 6)},9,6,{f.angle(f.first)}"),
    "HYPERB": vertical(lambda f: f"HYPERB/CENTER,{f.point(0, 20)},20,14,{f.angle(f.normal)}"),
    "HYPERB from inside": vertical(lambda f: f"HYPERB/CENTER,{f.point(0, -20)},20,14,{f.angle(f.normal)}"),
    "GCONIC": vertical(parabola),
    "LCONIC": vertical(lconic),
    "TABCYL": vertical(lambda f: "TABCYL/NOZ,SPLINE," + ",".join(f.point(p[0], p[2]) for p in WAVE)),
    "MESH STL": mesh("STL"), "MESH OBJ": mesh("OBJ"), "MESH PLY": mesh("PLY"), "MESH OFF": mesh("OFF"),
}
# Role, relation to the drive surface, relation to the part surface, stop.
ROWS = [("part", "TLON", "TO", "ON"), ("part", "TLON", "ON", "ON"), ("part", "TLLFT", "TO", "ON"),
        ("drive", "TLLFT", "TO", "ON"), ("drive", "TLRGT", "TO", "ON"), ("drive", "TLON", "TO", "ON"),
        ("check", "TLON", "TO", "TO"), ("check", "TLON", "TO", "ON"), ("check", "TLON", "TO", "PAST"),
        ("check", "TLLFT", "TO", "TO")]


def negative(v):
    return tuple(-x for x in v)


class Row:
    """One motion along e1 with the drive plane square to e2 and the part plane square to e3."""

    def __init__(self, number, row, define, write):
        self.role, self.relation, self.toPart, self.stop = row
        lies = getattr(define, "vertical", False) and self.role == "part"
        self.e1, self.e2, self.e3 = (X, Z, (0, -1, 0)) if lies else (X, Y, Z)
        frame = {"part": (lambda: Frame((0, 0, 0), self.e1, self.e2, self.e3)),
                 "drive": (lambda: Frame((0, 0, 0), self.e1, self.e3,
                                         negative(self.e2) if self.relation == "TLRGT" else self.e2)),
                 "check": (lambda: Frame(along((0, 0, 0), self.e1, 5), self.e2, self.e3, negative(self.e1)))}[self.role]()
        self.text = define(frame, write)
        self.number = number

    def plane(self, normal, offset):
        return f"(PLANE/{surfaces.numbers(normal)},{surfaces.number(offset)})"

    def lines(self):
        name = f"S{self.number}"
        part = name if self.role == "part" else self.plane(self.e3, 0)
        drive = name if self.role == "drive" else self.plane(self.e2, 0.3 if self.role == "part" else 0)
        check = name if self.role == "check" else self.plane(self.e1, 4)
        side = -1 if self.relation == "TLRGT" else 1
        start = along(along(along((0, 0, 0), self.e1, -4.3), self.e2, side * 2.1), self.e3, 3.2)
        yield f"{name}={self.text}"
        yield f"FROM/{surfaces.numbers(start)},{surfaces.numbers(self.e3)}"
        yield (f"GO/{'ON' if self.relation == 'TLON' else 'TO'},{drive},{self.toPart},{part},ON,"
               f"{self.plane(self.e1, -4)}")
        yield f"INDIRV/{surfaces.numbers(self.e1)}"
        yield f"{self.relation},{'TLONPS' if self.toPart == 'ON' else 'TLOFPS'},GOFWD/{drive},{self.stop},{check}"


def cards(line):
    while len(line) > 70:
        cut = line.rfind(",", 0, 68) + 1
        yield line[:cut] + "$"
        line = line[cut:]
    yield line


class SurfaceRoles(ArelemCase):
    def paths(self, kind, cutter):
        """Per row the points of its motion, proven."""
        names = []

        def write(text, suffix):
            names.append(f"m{len(names)}.{suffix}")
            self.write(names[-1], text)
            return names[-1]

        rows = [Row(i, row, KINDS[kind], write) for i, row in enumerate(ROWS)]
        lines = ["PARTNO ROLES", "MULTAX", "3DCALC", "INTOL/.002", "OUTTOL/.002", "MAXDP/100", f"CUTTER/{cutter}"]
        for row in rows:
            lines += row.lines()
        self.write("roles.apt", "\n".join(card for line in [*lines, "FINI"] for card in cards(line)) + "\n")
        self.assertExit(0, "compile", "roles.apt", "--to", "json", "-o", "-")
        statements = {}
        for record in map(json.loads, self.out.splitlines()):
            if record["type"] == 5000:
                statements.setdefault(record["isn"], []).extend(record["points"])
        self.assertExit(0, "verify", "roles.apt")
        self.assertIn("all tolerances are proven", self.err)
        motions = list(statements.values())[2::3]
        self.assertEqual(len(motions), len(rows))
        return zip(rows, motions)

    def check_kind(self, kind, cutter):
        reach = float(cutter.split(",")[0]) / 2
        for row, points in self.paths(kind, cutter):
            with self.subTest(kind=kind, cutter=cutter, role=row.role, relation=row.relation, stop=row.stop):
                end = [sum(a * b for a, b in zip(points[-1], e)) for e in (row.e1, row.e2, row.e3)]
                if row.role != "check":
                    self.assertAlmostEqual(end[0], 4, delta=1e-9)
                elif row.stop == "ON":
                    # The crest of the POLCON lies near the place, the other surfaces go through it.
                    self.assertAlmostEqual(end[0], 5, delta=BAND if kind != "POLCON" else 0.1)
                elif row.stop == "TO" and kind == "tip of a cone":
                    pass  # how far the tool comes depends on where beside the tip it runs; the certificate tells
                elif row.stop == "TO":
                    self.assertLess(end[0], 5 - 0.5 * reach)
                else:
                    self.assertGreater(end[0], 5)
                if row.role == "check" and row.relation == "TLON":
                    self.assertAlmostEqual(end[1], 0, delta=1e-9)
                if row.role != "part":
                    self.assertAlmostEqual(end[2], 0, delta=1e-9)


def add_tests():
    # Each kind meets one cutter, all kinds together all of them; the tip of a cone and a mesh meet all.
    pairs = [(kind, CUTTERS[(i + 1) % len(CUTTERS)]) for i, kind in enumerate(KINDS)]
    for kind, cutter in pairs + [(kind, c) for kind in ("tip of a cone", "MESH OFF") for c in CUTTERS]:
        def test(self, kind=kind, cutter=cutter):
            self.check_kind(kind, cutter)
        name = "".join(c if c.isalnum() else "_" for c in f"{kind} {cutter}").lower()
        setattr(SurfaceRoles, f"test_{name}", test)


add_tests()

if __name__ == "__main__":
    unittest.main()
