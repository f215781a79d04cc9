"""Surfaces as plain tuples, moved by similarities, written as APT definitions."""
import math


def number(x):
    return repr(float(x) + 0.0)


def numbers(values):
    return ",".join(number(v) for v in values)


class Similarity:
    """p -> scale * rows p + shift, with orthogonal rows; a determinant of -1 mirrors."""

    def __init__(self, rows=((1, 0, 0), (0, 1, 0), (0, 0, 1)), shift=(0, 0, 0), scale=1.0):
        self.rows, self.shift, self.scale = rows, shift, scale

    def direction(self, v):
        return tuple(sum(r * x for r, x in zip(row, v)) for row in self.rows)

    def point(self, p):
        return tuple(self.scale * x + s for x, s in zip(self.direction(p), self.shift))

    def length(self, x):
        return self.scale * x

    def mirrors(self):
        a, b, c = self.rows
        return sum(x * (b[(i + 1) % 3] * c[(i + 2) % 3] - b[(i + 2) % 3] * c[(i + 1) % 3])
                   for i, x in enumerate(a)) < 0

    def form(self, q):
        """The symmetric 4x4 matrix of a quadric in the new place."""
        inverse = [[self.rows[j][i] / self.scale for j in range(3)] for i in range(3)]
        m = [row + [-sum(a * t for a, t in zip(row, self.shift))] for row in inverse] + [[0, 0, 0, 1]]
        half = [[sum(q[i][k] * m[k][j] for k in range(4)) for j in range(4)] for i in range(4)]
        return [[sum(m[k][i] * half[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def define(surface, to):
    """The APT definition of ("kind", values...) moved by the similarity `to`."""
    kind, *v = surface
    if kind == "PLANE":
        normal = to.direction(v[0])
        offset = to.scale * v[1] / math.sqrt(sum(x * x for x in v[0]))
        unit = tuple(x / math.sqrt(sum(y * y for y in normal)) for x in normal)
        return f"PLANE/{numbers(unit)},{number(offset + sum(a * b for a, b in zip(unit, to.shift)))}"
    if kind == "SPHERE":
        return f"SPHERE/{numbers(to.point(v[0]))},{number(to.length(v[1]))}"
    if kind == "CYLNDR":
        return f"CYLNDR/{numbers(to.point(v[0]))},{numbers(to.direction(v[1]))},{number(to.length(v[2]))}"
    if kind == "CONE":
        return f"CONE/(POINT/{numbers(to.point(v[0]))}),(VECTOR/{numbers(to.direction(v[1]))}),{number(v[2])}"
    if kind == "TORUS":
        radii = number(to.length(v[2])) + "," + number(to.length(v[3]))
        return f"TORUS/{numbers(to.point(v[0]))},{numbers(to.direction(v[1]))},{radii}"
    if kind == "TABCYL":
        return f"TABCYL/XYZ,SPLINE,(VECTOR/{numbers(to.direction(v[0]))})," + ",".join(
            numbers(to.point(p)) for p in v[1])
    if kind == "RLDSRF":
        return "RLDSRF/" + ",".join(
            f"({define(carrier, to)})," + ",".join(f"(POINT/{numbers(to.point(p))})" for p in points)
            for carrier, points in v)
    if kind == "POLCON":
        return polyconic(v, to)
    if kind == "MESH":
        return "MESH/STL,'mesh.stl'"
    a, b, c, f, g, h, p, q, r, d = v[0]
    m = to.form([[a, h / 2, g / 2, p / 2], [h / 2, b, f / 2, q / 2], [g / 2, f / 2, c, r / 2],
                 [p / 2, q / 2, r / 2, d]])
    return "QADRIC/" + numbers([m[0][0], m[1][1], m[2][2], 2 * m[1][2], 2 * m[0][2], 2 * m[0][1],
                                2 * m[0][3], 2 * m[1][3], 2 * m[2][3], m[3][3]])


def polyconic(v, to):
    """A POLCON of (three unit directions, origin, t, cb, pb, coefficients of A to P by powers of d)."""
    frame, origin, thick, cb, pb, rows = v
    matrix = []
    for e in map(to.direction, frame):
        matrix += [*e, -sum(a * b for a, b in zip(e, to.point(origin)))]
    values = [1, *matrix, to.length(thick), to.length(cb), to.length(pb)]
    for i, row in enumerate(rows):
        values += [k if i == 6 else to.length(k) for k in row] + [0] * (8 - len(row))
    return "POLCON/CANON," + numbers(values + [0] * 7)


def stl(triangles, to):
    """The text of an STL file of triangles moved; mirrors keep the outside outside."""
    lines = ["solid mesh"]
    for triangle in triangles:
        corners = [to.point(p) for p in triangle]
        if to.mirrors():
            corners.reverse()
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += ["vertex " + " ".join(map(repr, p)) for p in corners] + ["endloop", "endfacet"]
    return "\n".join(lines + ["endsolid mesh", ""])
