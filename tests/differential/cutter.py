"""Least distance of a cutter from a surface, by a plain search over the cutter's outside for many locations at once."""
import math

import numpy as np

import surfaces

# Places on each piece of the profile where a search may begin. Dense towards the beginning of the piece, where the pole
# of a ball lies: there an angle that is off by a quarter turn could not be mended by small steps.
SHARES = (1 / 1024, 1 / 256, 1 / 64, 1 / 16, 1 / 4, 1 / 2, 3 / 4)
TURNS = 16
NEIGHBORS = np.array(((1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (1, -1), (-1, 1), (-1, -1)), float)
FINEST = 1e-6  # of the halved steps
MANY = 4000    # rounds that no search needs


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
        e, f, r, up, out = self.arc
        angle = up + (t - 1.0) * (out - up)
        s = np.clip(t - 2.0, 0.0, 1.0)
        pieces = (t <= 1.0, t < 2.0)
        rho = np.select(pieces, (t * self.low[0], e + r * np.sin(angle) if r else self.low[0] + 0 * t),
                        self.high[0] + s * (self.top[0] - self.high[0]))
        z = np.select(pieces, (t * self.low[1], f - r * np.cos(angle) if r else self.low[1] + 0 * t),
                      self.high[1] + s * (self.top[1] - self.high[1]))
        return rho, z

    def center(self):
        """Height of a place on the axis that is well inside the cutter."""
        return min(self.height, max(self.top[0], 1e-3)) / 2

    def side(self, ends, axes, surf):
        """On which side of the surface a path lies, 1 or -1: that of the center of the cutter where it is farthest."""
        off = surf.distance(ends + self.center() * axes)
        return np.copysign(1.0, off[np.argmax(np.abs(off))])

    def gaps(self, ends, axes, surf, side):
        """Least distance of the cutter from the surface at each location, negative where it cuts into it. `side`
        is that of the surface on which it is."""
        count = len(ends)
        upright = np.abs(axes[:, 2:]) < 0.9
        zero = np.zeros(count)
        across = surfaces.unit(np.where(upright, np.stack([axes[:, 1], -axes[:, 0], zero], 1),
                                        np.stack([zero, axes[:, 2], -axes[:, 1]], 1)))
        third = np.cross(axes, across)

        def value(row, t, phi):
            """Signed distances at (n, k) places t, phi of the cutters at locations row (n)."""
            rho, z = self.profile(t)
            p = (ends[row][:, None] + z[..., None] * axes[row][:, None]
                 + (rho * np.cos(phi))[..., None] * across[row][:, None]
                 + (rho * np.sin(phi))[..., None] * third[row][:, None])
            return side * surf.distance(p.reshape(-1, 3)).reshape(t.shape)

        # A search from inside each of the three pieces: at the pole of a ball, and where two pieces meet, no direction
        # would be told apart.
        row = np.repeat(np.arange(count), 3)
        low = np.tile(np.arange(3.0), count)
        grid_t, grid_phi = (g.ravel() for g in np.meshgrid(SHARES, np.arange(TURNS) * 2 * math.pi / TURNS, indexing="ij"))
        t = low[:, None] + grid_t
        phi = np.broadcast_to(grid_phi, t.shape)
        found = value(row, t, phi)
        first = np.argmin(found, axis=1)
        pick = np.arange(len(row)), first
        best = self.refine(value, row, low, found[pick], t[pick], phi[pick])
        return best.reshape(count, 3).min(axis=1)

    @staticmethod
    def refine(value, row, low, best, t, phi):
        """The least value over one piece of the profile each: from a place of the grid, by halving steps."""
        dt, dphi = np.full(len(row), 0.25), np.full(len(row), math.pi / 8)
        for _ in range(MANY):
            active = np.flatnonzero((dphi > FINEST) | (dt > FINEST))
            if not len(active):
                return best
            lowest = low[active, None]
            new_t = np.clip(t[active, None] + dt[active, None] * NEIGHBORS[:, 0], lowest, lowest + 1.0)
            new_phi = phi[active, None] + dphi[active, None] * NEIGHBORS[:, 1]
            tried = value(row[active], new_t, new_phi)
            which = np.argmin(tried, axis=1)
            pick = np.arange(len(active)), which
            better = tried[pick] < best[active] - 1e-14
            moved, stayed = active[better], active[~better]
            best[moved], t[moved], phi[moved] = tried[pick][better], new_t[pick][better], new_phi[pick][better]
            dt[stayed] /= 2
            dphi[stayed] /= 2
        raise ArithmeticError("the search over the cutter does not end")


class Disk(Cutter):
    """The disk of CUTTER/OPTION: a radius, and the height of its plane above the tool end."""

    def __init__(self, radius, height):
        self.radius, self.height = radius, height

    def center(self):
        return self.height

    def profile(self, t):
        return np.minimum(t, 1.0) * self.radius, np.full(t.shape, self.height)
