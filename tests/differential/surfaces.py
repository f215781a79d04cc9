"""Signed distances from points to surfaces, and from cutters to surfaces.

Written for the tests alone and independent of the compiler's solver: closed forms where they exist, and a plain search
over the cutter's outside for the rest. Lengths in the part's unit; p is (x, y, z). Positive is the side to which the
normal points: outside of closed surfaces, the normal's side of planes and tabulated cylinders.
"""
import math


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def along(p, t, d):
    return (p[0] + t * d[0], p[1] + t * d[1], p[2] + t * d[2])


def unit(a):
    length = math.sqrt(dot(a, a))
    return (a[0] / length, a[1] / length, a[2] / length)


class Plane:
    curved = False

    def __init__(self, canon):
        self.normal, self.offset = canon[:3], canon[3]

    def distance(self, p):
        return dot(self.normal, p) - self.offset


class Sphere:
    curved = True

    def __init__(self, canon):
        self.center, self.radius = canon[:3], canon[3]

    def distance(self, p):
        return math.dist(p, self.center) - self.radius


class Cylinder:
    """CIRCLE and CYLNDR: point on the axis, unit axis, radius."""

    def __init__(self, canon):
        self.point, self.axis, self.radius = canon[:3], canon[3:6], canon[6]
        self.curved = abs(self.axis[2]) < 1.0 - 1e-12  # an upright one is met exactly

    def distance(self, p):
        w = sub(p, self.point)
        s = dot(w, self.axis)
        return math.sqrt(max(dot(w, w) - s * s, 0.0)) - self.radius


class Cone:
    """One nappe: vertex, unit axis into it, cosine of the half angle."""

    curved = True

    def __init__(self, canon):
        self.vertex, self.axis, self.cos = canon[:3], canon[3:6], canon[6]
        self.sin = math.sqrt(1.0 - self.cos * self.cos)

    def distance(self, p):
        w = sub(p, self.vertex)
        s = dot(w, self.axis)
        rho = math.sqrt(max(dot(w, w) - s * s, 0.0))
        if s * self.cos + rho * self.sin < 0.0:  # nearest to the vertex
            return math.hypot(s, rho)
        return rho * self.cos - s * self.sin


class Quadric:
    """a x2 + b y2 + c z2 + d + 2f yz + 2g xz + 2h xy + 2p x + 2q y + 2r z = 0; sign as the polynomial.

    The foot is found by repeated Newton steps along the gradient, which is exact to second order in the distance:
    enough for points within a tolerance band of the surface.
    """

    def __init__(self, canon):
        self.k = canon
        self.curved = any(abs(v) > 1e-12 for v in (canon[2], canon[4], canon[5], canon[9]))

    def value(self, p):
        a, b, c, d, f, g, h, pp, q, r = self.k
        x, y, z = p
        return (a * x * x + b * y * y + c * z * z + d + 2 * (f * y * z + g * x * z + h * x * y)
                + 2 * (pp * x + q * y + r * z))

    def gradient(self, p):
        a, b, c, _, f, g, h, pp, q, r = self.k
        x, y, z = p
        return (2 * (a * x + g * z + h * y + pp), 2 * (b * y + f * z + h * x + q), 2 * (c * z + f * y + g * x + r))

    def distance(self, p):
        foot = p
        for _ in range(6):
            gradient = self.gradient(foot)
            square = dot(gradient, gradient)
            if square < 1e-300:
                break
            step = self.value(foot) / square
            foot = along(foot, -step, gradient)
            if abs(step) * math.sqrt(square) < 1e-13:
                break
        return math.copysign(math.dist(p, foot), self.value(p))


class TabulatedCylinder:
    """n k m1..m9, then u v a b len max min for each interval, then the last u v.

    Between two points the curve leaves its chord by v = a u3 + b u2 + c u with c = -len (a len + b).
    """

    curved = True
    samples = 64

    def __init__(self, canon):
        count = int(round(canon[0]))
        m = canon[2:11]
        self.rows = (m[0:3], m[3:6])
        self.intervals = []
        body = canon[11:]
        points = [tuple(body[7 * i:7 * i + 2]) for i in range(count)]
        for i in range(count - 1):
            a, b, length = body[7 * i + 2:7 * i + 5]
            self.intervals.append((points[i], points[i + 1], a, b, length))
        self.table = []
        for index in range(len(self.intervals)):
            for k in range(self.samples):
                u = self.intervals[index][4] * k / self.samples
                self.table.append((*self.at(index, u), index, u))
        self.table.append((*points[-1], len(self.intervals) - 1, self.intervals[-1][4]))

    def at(self, index, u):
        (u0, v0), (u1, v1), a, b, length = self.intervals[index]
        cosine, sine = (u1 - u0) / length, (v1 - v0) / length
        v = ((a * u + b) * u - length * (a * length + b)) * u
        return (u0 + u * cosine - v * sine, v0 + u * sine + v * cosine)

    def slope(self, index, u):
        (u0, v0), (u1, v1), a, b, length = self.intervals[index]
        cosine, sine = (u1 - u0) / length, (v1 - v0) / length
        dv = (3 * a * u + 2 * b) * u - length * (a * length + b)
        return (cosine - dv * sine, sine + dv * cosine)

    def distance(self, p):
        q = (dot(self.rows[0], p), dot(self.rows[1], p))
        _, _, index, u = min(self.table, key=lambda row: (row[0] - q[0]) ** 2 + (row[1] - q[1]) ** 2)
        step = self.intervals[index][4] / self.samples
        best = None
        for i, start in ((index, u), (index - 1, None), (index + 1, 0.0)):
            if not 0 <= i < len(self.intervals):
                continue
            start = self.intervals[i][4] if start is None else start
            found = self.search(q, i, max(0.0, start - step), min(self.intervals[i][4], start + step))
            best = found if best is None or found[0] < best[0] else best
        _, foot, tangent = best
        side = tangent[0] * (q[1] - foot[1]) - tangent[1] * (q[0] - foot[0])
        return math.copysign(math.dist(q, foot), side)

    def search(self, q, index, low, high):
        """Golden section for the nearest place of one stretch of an interval."""
        ratio = (math.sqrt(5.0) - 1.0) / 2.0
        square = lambda u: math.dist(q, self.at(index, u))
        for _ in range(40):
            left, right = high - ratio * (high - low), low + ratio * (high - low)
            if square(left) < square(right):
                high = right
            else:
                low = left
        u = 0.5 * (low + high)
        return square(u), self.at(index, u), self.slope(index, u)


KINDS = {"LINE": Plane, "PLANE": Plane, "CIRCLE": Cylinder, "CYLNDR": Cylinder, "SPHERE": Sphere, "CONE": Cone,
         "ELLIPS": Quadric, "HYPERB": Quadric, "GCONIC": Quadric, "LCONIC": Quadric, "QADRIC": Quadric,
         "TABCYL": TabulatedCylinder}


def surface(kind, canon):
    """The surface of a canonical form, or None for a type that these tests do not know."""
    return KINDS[kind](canon) if kind in KINDS else None


FRACTIONS = (1 / 1024, 1 / 256, 1 / 64, 1 / 16, 1 / 4, 1 / 2, 3 / 4)


class Cutter:
    """The seven-parameter cutter: bottom line, corner arc and side line, turned about the axis; no top face."""

    def __init__(self, values):
        d, r, e, f, alpha, beta, h = self.complete(values)
        self.height = h
        up, out = math.radians(alpha), math.radians(90.0 - beta)
        # Where the bottom line and the side line leave the arc: its normals there are known.
        low = (e + r * math.sin(up), f - r * math.cos(up))
        high = (e + r * math.sin(out), f - r * math.cos(out))
        if r == 0.0:
            low = high = (d / 2, d / 2 * math.tan(up))
        side = math.tan(math.radians(beta))
        top = (d / 2 + side * (h - d / 2 * math.tan(up)), h)
        self.arc = (e, f, r, up, out)
        self.low, self.high, self.top = low, high, top

    @staticmethod
    def complete(values):
        if len(values) < 7:
            d, r = values[0], values[1] if len(values) > 1 else 0.0
            return d, r, d / 2 - r, r, 0.0, 0.0, max(5.0, r)
        d, r, e, f, alpha, beta, h = values
        if e == f == alpha == beta == 0.0 and r > 0.0:
            e, f = d / 2 - r, r
        return d, r, e, f, alpha, beta, h if h > 0.0 else max(5.0, r)

    def profile(self, t):
        """Radius and height at t: bottom 0 to 1, arc 1 to 2, side 2 to 3."""
        if t <= 1.0:
            return (t * self.low[0], t * self.low[1])
        if t >= 2.0:
            s = min(t, 3.0) - 2.0
            return (self.high[0] + s * (self.top[0] - self.high[0]), self.high[1] + s * (self.top[1] - self.high[1]))
        e, f, r, up, out = self.arc
        if r == 0.0:
            return self.low
        angle = up + (t - 1.0) * (out - up)
        return (e + r * math.sin(angle), f - r * math.cos(angle))

    def gap(self, end, axis, surf):
        """Least distance of the cutter from the surface, negative where it cuts into it."""
        across = unit((axis[1], -axis[0], 0.0) if abs(axis[2]) < 0.9 else (0.0, axis[2], -axis[1]))
        third = (axis[1] * across[2] - axis[2] * across[1], axis[2] * across[0] - axis[0] * across[2],
                 axis[0] * across[1] - axis[1] * across[0])
        inside = along(end, min(self.height, max(self.top[0], 1e-3)) / 2, axis)
        sign = 1.0 if surf.distance(inside) >= 0.0 else -1.0

        def value(t, phi):
            rho, z = self.profile(t)
            p = along(end, z, axis)
            p = along(along(p, rho * math.cos(phi), across), rho * math.sin(phi), third)
            return sign * surf.distance(p)

        # A search from inside each of the three pieces: at the pole of a ball, and where two pieces meet, no direction
        # would be told apart.
        return min(self.search(value, piece) for piece in range(3))

    @staticmethod
    def search(value, piece):
        """The least value over one piece of the profile: the best of a grid, refined by halving steps.

        The grid is dense towards the beginning of the piece, where the pole of a ball lies: there an angle that is off
        by a quarter turn could not be mended by small steps.
        """
        low, high = float(piece), piece + 1.0
        grid = [(value(piece + k, j * math.pi / 8), piece + k, j * math.pi / 8) for k in FRACTIONS for j in range(16)]
        best, t, phi = min(grid)
        dt, dphi = 0.25, math.pi / 8
        while dphi > 1e-6 or dt > 1e-6:
            found = (best, t, phi)
            for i, j in ((1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (1, -1), (-1, 1), (-1, -1)):
                place = (min(max(t + i * dt, low), high), phi + j * dphi)
                found = min(found, (value(*place), *place))
            if found[0] < best - 1e-14:
                best, t, phi = found
            else:
                dt, dphi = dt / 2, dphi / 2
        return best
