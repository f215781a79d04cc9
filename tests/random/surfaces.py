"""Surfaces of random scenes: plain tuples, moved by similarities, written as APT definitions."""
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


def about(axis, degrees):
    """The rows of a rotation about a unit axis."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    x, y, z = axis
    return ((c + x * x * (1 - c), x * y * (1 - c) - z * s, x * z * (1 - c) + y * s),
            (y * x * (1 - c) + z * s, c + y * y * (1 - c), y * z * (1 - c) - x * s),
            (z * x * (1 - c) - y * s, z * y * (1 - c) + x * s, c + z * z * (1 - c)))


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


def wave(u, along, across, height):
    """A curve of seven points over [-10, 10], as an extruded surface along `across`."""
    x = [-10, -6, -3, 0, 3, 6, 10]
    points = [[0.0, 0.0, 0.0] for _ in x]
    for p, value in zip(points, x):
        p[along] = value
        p[3 - along - "xyz".index(across)] = u(-height, height)
    direction = tuple(1 if name == across else 0 for name in "xyz")
    return ("TABCYL", direction, [tuple(p) for p in points])


def hills(u):
    """A mesh of 9 x 7 places over [-10, 10] x [-6, 6]."""
    at = [[(x * 2.5 - 10, y * 2 - 6, u(-0.4, 0.4)) for y in range(7)] for x in range(9)]
    return [t for x in range(8) for y in range(6)
            for t in ((at[x][y], at[x + 1][y], at[x + 1][y + 1]), (at[x][y], at[x + 1][y + 1], at[x][y + 1]))]


def arch(u, frame, origin):
    """A POLCON: arcs to both sides of the third direction, whose radius, height, side and shoulder change along the first."""
    r, half = u(7, 20), u(0.5, 0.9)
    sine, cosine = math.sin(half), math.cos(half)
    fall, share = r * sine * sine / cosine, cosine / (1 + cosine)
    grows = u(-0.15, 0.15)
    rows = [[k, grows * k] for k in (-r * sine, fall, -r * sine, -fall)]
    rows += [[r * sine, grows * r * sine + u(-1, 1), u(-1, 1)], [r * cosine - r, u(-1, 1), u(-1, 1)],
             [0.5 * (1 + share), u(-0.04, 0.04)]]
    return ("POLCON", frame, origin, u(-0.2, 0.2), -10, 20, rows)


def part(kind, u):
    """A surface under the tool near the x axis; u(low, high) draws a number."""
    z = u(-0.5, 0.5)
    if kind == "plane":
        return ("PLANE", (u(-0.3, 0.3), u(-0.3, 0.3), 1), z)
    if kind == "sphere":
        radius = u(7, 20)
        return ("SPHERE", (u(-1, 1), u(-1, 1), z - radius), radius)
    if kind == "hollow":
        radius = u(9, 20)
        return ("SPHERE", (u(-0.5, 0.5), u(-0.5, 0.5), z + radius), radius)
    if kind == "cylinder":
        radius, turn = u(6, 12), math.radians(u(0, 180))
        return ("CYLNDR", (0, 0, z - radius), (math.cos(turn), math.sin(turn), u(-0.1, 0.1)), radius)
    if kind == "cone":
        return ("CONE", (u(-25, -15), u(-0.5, 0.5), z - 2), (1, 0, 0), u(8, 20))
    if kind == "torus":
        return ("TORUS", (u(-1, 1), u(-9, -7), z - 3), (0, u(-0.1, 0.1), 1), u(7, 9), 3.0)
    if kind == "ellipsoid":
        return ("QADRIC", (u(0.01, 0.03), u(0.03, 0.1), u(0.1, 0.4), 0, 0, 0, 0, 0, 0, -1))
    if kind == "saddle":
        return ("QADRIC", (u(0.01, 0.04), u(-0.04, -0.01), 0, 0, 0, 0, 0, 0, 1, z))
    if kind == "bowl":
        return ("QADRIC", (u(0.01, 0.05), u(0.01, 0.05), 0, 0, 0, u(-0.01, 0.01), u(-0.1, 0.1), 0, -1, z))
    if kind == "tabcyl":
        return wave(u, 0, "y", 0.5)
    if kind == "ruled":
        near, far = u(5, 8), u(5, 8)
        return ("RLDSRF",
                (("CYLNDR", (0, -4, z - near), (0, 1, 0), near), ((-4.5, -4, z - 2), (4.5, -4, z - 2), (0, -4, z + 2))),
                (("CYLNDR", (0, 4, z - far), (0, 1, 0), far), ((-4.5, 4, z - 2), (4.5, 4, z - 2), (0, 4, z + 2))))
    if kind == "mesh":
        return ("MESH", hills(u))
    if kind == "slanted":
        _, _, points = wave(u, 0, "y", 0.5)
        return ("TABCYL", (u(-0.3, 0.3), 1, u(-0.3, 0.3)), points)
    if kind == "polyconic":
        return arch(u, ((1, 0, 0), (0, 1, 0), (0, 0, 1)), (0, 0, z))
    raise KeyError(kind)


def drive(kind, u):
    """A surface standing along the x axis."""
    y = u(-0.5, 0.5)
    if kind == "plane":
        return ("PLANE", (u(-0.3, 0.3), 1, u(-0.2, 0.2)), y)
    if kind == "wall":
        return ("PLANE", (u(-0.3, 0.3), 1, 0), y)
    if kind == "circle":
        radius = u(8, 20)
        return ("CYLNDR", (u(-1, 1), y - radius, 0), (0, 0, 1), radius)
    if kind == "cylinder":
        radius = u(8, 20)
        return ("CYLNDR", (0, y - radius, 0), (u(-0.1, 0.1), u(-0.1, 0.1), 1), radius)
    if kind == "sphere":
        radius = u(10, 20)
        return ("SPHERE", (u(-1, 1), y - radius, u(-1, 1)), radius)
    if kind == "hollow":
        radius = u(10, 20)
        return ("CYLNDR", (u(-1, 1), y + radius, 0), (u(-0.1, 0.1), u(-0.1, 0.1), 1), radius)
    if kind == "cone":
        return ("CONE", (u(-1, 1), y - 14, 40), (0, 0, -1), u(15, 20))
    if kind == "torus":
        return ("TORUS", (u(-1, 1), y - 12, u(-1, 1)), (u(-0.1, 0.1), u(-0.1, 0.1), 1), u(9, 10), 2.5)
    if kind == "tabcyl":
        return wave(u, 0, "z", 0.5)
    if kind == "quadric":
        return ("QADRIC", (u(0.005, 0.01), 1, u(0.001, 0.01), 0, 0, 0, 0, u(3, 6), 0, u(-1, 1)))
    if kind == "slanted":
        _, _, points = wave(u, 0, "z", 0.5)
        return ("TABCYL", (u(-0.2, 0.2), u(-0.2, 0.2), 1), points)
    if kind == "polyconic":
        return arch(u, ((0, 0, 1), (1, 0, 0), (0, 1, 0)), (0, y, 0))
    raise KeyError(kind)


def check(u, choice):
    kind = choice(["plane", "sphere", "cylinder"])
    if kind == "plane":
        return ("PLANE", (1, u(-0.2, 0.2), u(-0.2, 0.2)), u(3.5, 5))
    if kind == "sphere":
        return ("SPHERE", (u(5, 7), u(-0.5, 0.5), u(-0.5, 1)), u(1.5, 2.5))
    return ("CYLNDR", (u(5, 7), u(-0.5, 0.5), 0), (u(-0.2, 0.2), u(-0.2, 0.2), 1), u(1.5, 2.5))


PARTS = ["plane", "sphere", "hollow", "cylinder", "cone", "torus", "ellipsoid", "saddle", "bowl",
         "tabcyl", "ruled", "mesh"]
DRIVES = ["plane", "wall", "circle", "cylinder", "sphere", "hollow", "quadric", "cone", "torus", "tabcyl"]
# Scenes keep their numbers: what was added later stands behind.
PAIRS = [(p, d) for p in PARTS for d in DRIVES]
for added in ("polyconic", "slanted"):
    PAIRS += [(added, d) for d in DRIVES] + [(p, added) for p in [*PARTS, added]]
