"""Signed distances from points to surfaces.

Written for the tests alone and independent of the compiler's solver: closed forms where they exist, else the foot of
the perpendicular by Newton steps or by plain search. Lengths in the part's unit. Points are arrays of shape (n, 3),
distances of shape (n,). Positive is the side to which the normal points: outside of closed surfaces, the normal's side
of planes and tabulated cylinders.
"""
import numpy as np


def unit(a):
    a = np.asarray(a, float)
    return a / np.linalg.norm(a, axis=-1, keepdims=True)


class Plane:
    def __init__(self, canon):
        self.normal, self.offset = np.array(canon[:3]), canon[3]

    def distance(self, p):
        return p @ self.normal - self.offset


class Sphere:
    def __init__(self, canon):
        self.center, self.radius = np.array(canon[:3]), canon[3]

    def distance(self, p):
        return np.linalg.norm(p - self.center, axis=1) - self.radius


def about_axis(p, point, axis):
    """Height along the axis and distance from it."""
    w = p - point
    s = w @ axis
    return s, np.sqrt(np.maximum(np.einsum("ij,ij->i", w, w) - s * s, 0.0))


class Cylinder:
    """CIRCLE and CYLNDR: point on the axis, unit axis, radius."""

    def __init__(self, canon):
        self.point, self.axis, self.radius = np.array(canon[:3]), np.array(canon[3:6]), canon[6]

    def distance(self, p):
        return about_axis(p, self.point, self.axis)[1] - self.radius


class Cone:
    """One nappe: vertex, unit axis into it, cosine of the half angle."""

    def __init__(self, canon):
        self.vertex, self.axis, self.cos = np.array(canon[:3]), np.array(canon[3:6]), canon[6]
        self.sin = np.sqrt(1.0 - self.cos * self.cos)

    def distance(self, p):
        s, rho = about_axis(p, self.vertex, self.axis)
        beyond = s * self.cos + rho * self.sin < 0.0  # nearest to the vertex
        return np.where(beyond, np.hypot(s, rho), rho * self.cos - s * self.sin)


class Quadric:
    """a x2 + b y2 + c z2 + d + 2f yz + 2g xz + 2h xy + 2p x + 2q y + 2r z = 0; sign as the polynomial.

    The foot is found by repeated Newton steps along the gradient, which is exact to second order in the distance:
    enough for points within a tolerance band of the surface.
    """

    def __init__(self, canon):
        a, b, c, self.constant, f, g, h, p, q, r = canon
        self.form = np.array([[a, h, g], [h, b, f], [g, f, c]])
        self.linear = np.array([p, q, r])

    def value(self, p):
        return np.einsum("ij,ij->i", p @ self.form, p) + 2.0 * (p @ self.linear) + self.constant

    def distance(self, p):
        foot = p
        for _ in range(6):
            gradient = 2.0 * (foot @ self.form + self.linear)
            square = np.maximum(np.einsum("ij,ij->i", gradient, gradient), 1e-300)
            foot = foot - (self.value(foot) / square)[:, None] * gradient
        return np.copysign(np.linalg.norm(p - foot, axis=1), self.value(p))


class TabulatedCylinder:
    """n k m1..m9, then u v a b len max min for each interval, then the last u v.

    Between two points the curve leaves its chord by v = a u3 + b u2 + c u with c = -len (a len + b). A place on the
    curve is one number: the interval and, behind the point, the share of its chord.
    """

    samples = 16   # places of the table in each interval
    rounds = 9     # of the search around the nearest of them, each to a quarter of the stretch before
    chunk = 4000   # points at once

    def __init__(self, canon):
        count = int(round(canon[0]))
        self.rows = np.array([canon[2:5], canon[5:8]])
        body = np.array(canon[11:11 + 7 * count - 5])
        points = np.array([body[7 * i:7 * i + 2] for i in range(count)])
        self.start, self.chord = points[:-1], points[1:] - points[:-1]
        self.a, self.b, self.length = (np.array([body[7 * i + k] for i in range(count - 1)]) for k in (2, 3, 4))
        self.along = self.chord / self.length[:, None]
        self.last = count - 1.0
        self.table = np.arange((count - 1) * self.samples + 1) / self.samples
        self.known = self.at(self.table)

    def split(self, place):
        index = np.minimum(place.astype(int), len(self.length) - 1)
        return index, (place - index) * self.length[index]

    def at(self, place):
        index, u = self.split(place)
        a, b, length = self.a[index], self.b[index], self.length[index]
        v = ((a * u + b) * u - length * (a * length + b)) * u
        cosine, sine = self.along[index, 0], self.along[index, 1]
        return self.start[index] + np.stack([u * cosine - v * sine, u * sine + v * cosine], axis=-1)

    def slope(self, place):
        index, u = self.split(place)
        a, b, length = self.a[index], self.b[index], self.length[index]
        dv = (3 * a * u + 2 * b) * u - length * (a * length + b)
        cosine, sine = self.along[index, 0], self.along[index, 1]
        return np.stack([cosine - dv * sine, sine + dv * cosine], axis=-1)

    def distance(self, p):
        return np.concatenate([self.some(p[i:i + self.chunk]) for i in range(0, len(p), self.chunk)])

    def some(self, p):
        q = p @ self.rows.T
        square = (q[:, :1] - self.known[:, 0]) ** 2 + (q[:, 1:] - self.known[:, 1]) ** 2
        place, reach = self.table[np.argmin(square, axis=1)], 1.0 / self.samples
        steps = np.linspace(-1.0, 1.0, 9)
        for _ in range(self.rounds):
            tried = np.clip(place[:, None] + reach * steps, 0.0, self.last)
            off = self.at(tried.ravel()).reshape(*tried.shape, 2) - q[:, None, :]
            best = np.argmin(np.einsum("ijk,ijk->ij", off, off), axis=1)
            place, reach = tried[np.arange(len(q)), best], reach / 4.0
        off, tangent = q - self.at(place), self.slope(place)
        side = tangent[:, 0] * off[:, 1] - tangent[:, 1] * off[:, 0]
        return np.copysign(np.linalg.norm(off, axis=1), side)


KINDS = {"LINE": Plane, "PLANE": Plane, "CIRCLE": Cylinder, "CYLNDR": Cylinder, "SPHERE": Sphere, "CONE": Cone,
         "ELLIPS": Quadric, "HYPERB": Quadric, "GCONIC": Quadric, "LCONIC": Quadric, "QADRIC": Quadric,
         "TABCYL": TabulatedCylinder}


def surface(kind, canon):
    """The surface of a canonical form, or None for a type that these tests do not know."""
    return KINDS[kind](canon) if kind in KINDS else None
