#!/usr/bin/env python3
"""REFSYS: what is defined in a local system and seen from the base is what was defined plainly and then moved by the
matrix. Every definition form whose type can be moved, under a turn about z and under a turn in space with a shift. The
programs are those of the language reference; the movement is computed here, from the canonical numbers alone."""
import json
import math
import pathlib
import unittest

from arelem_run import PROJECT, ArelemCase

REFERENCE = PROJECT / "tests" / "golden" / "reference"
CONICS = {"ELLIPS", "HYPERB", "GCONIC", "LCONIC", "QADRIC"}
MOVED = {"POINT", "PATERN", "VECTOR", "LINE", "PLANE", "CIRCLE", "CYLNDR", "CONE", "SPHERE", "TORUS"} | CONICS


def turn(axis, degrees):
    """Rows of the rotation about the axis x, y or z."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    a, b = [(1, 2), (2, 0), (0, 1)]["xyz".index(axis)]
    m = [[float(i == k) for k in range(3)] for i in range(3)]
    m[a][a], m[a][b], m[b][a], m[b][b] = c, -s, s, c
    return m


def times(m, v):
    return [sum(m[i][k] * v[k] for k in range(len(v))) for i in range(len(m))]


def product(a, b):
    columns = [times(a, [row[k] for row in b]) for k in range(len(b[0]))]
    return [list(row) for row in zip(*columns)]


def transposed(m):
    return [list(row) for row in zip(*m)]


class System:
    """p' = R p + t with a rotation R."""

    def __init__(self, rotation, shift):
        self.rotation, self.shift = rotation, shift
        self.tilted = abs(rotation[2][2] - 1.0) > 1e-9

    def text(self):
        numbers = [v for row, t in zip(self.rotation, self.shift) for v in (*row, t)]
        return "MSYS=MATRIX/" + ",$\n".join(f"{v:.17f}" for v in numbers) + "\n"

    def direction(self, v):
        return times(self.rotation, v)

    def place(self, p):
        return [a + b for a, b in zip(self.direction(p), self.shift)]

    def plane(self, numbers):
        normal = self.direction(numbers[:3])
        return [*normal, numbers[3] + sum(n * t for n, t in zip(normal, self.shift))]

    def conic(self, numbers):
        """Q' = B^T Q B with B the way back, p = R^T p' - R^T t."""
        a, b, c, d, f, g, h, p, q, r = numbers
        matrix = [[a, h, g, p], [h, b, f, q], [g, f, c, r], [p, q, r, d]]
        back = [[*row, -s] for row, s in zip(transposed(self.rotation), times(transposed(self.rotation), self.shift))]
        back.append([0.0, 0.0, 0.0, 1.0])
        m = product(transposed(back), product(matrix, back))
        return [m[0][0], m[1][1], m[2][2], m[3][3], m[1][2], m[0][2], m[0][1], m[0][3], m[1][3], m[2][3]]

    def seen(self, kind, numbers):
        """Type and canonical numbers from the base."""
        if kind in ("POINT", "PATERN"):
            return kind, [v for i in range(0, len(numbers), 3) for v in self.place(numbers[i:i + 3])]
        if kind == "VECTOR":
            return kind, self.direction(numbers)
        if kind in ("LINE", "PLANE"):
            moved = self.plane(numbers)
            return ("LINE" if kind == "LINE" and abs(moved[2]) < 1e-12 else "PLANE"), moved
        if kind in CONICS:
            return ("QADRIC" if self.tilted else kind), self.conic(numbers)
        if kind == "SPHERE":
            return kind, [*self.place(numbers[:3]), numbers[3]]
        kind = "CYLNDR" if kind == "CIRCLE" and self.tilted else kind
        return kind, [*self.place(numbers[:3]), *self.direction(numbers[3:6]), *numbers[6:]]


FORMS = {"pt", "ln", "pl", "ci", "cy", "el", "hy", "co", "gc", "lc", "ve", "sp", "qd", "pa", "tor"}
SYSTEMS = [System(turn("z", 37.0), [0.0, 0.0, 0.0]),
           System(product(turn("z", 25.0), product(turn("x", 40.0), turn("y", -70.0))), [3.0, -7.0, 11.0])]


def programs():
    """(file, statements without comments and FINI)."""
    for path in sorted(REFERENCE.glob("*.apt")):
        text = "".join(line for line in path.read_text().splitlines(True) if not line.startswith("$$"))
        text = text.replace("FINI\n", "")
        if path.stem.split("_")[0] in FORMS and "REFSYS" not in text:
            yield path, text


def full_name(row):
    return row["name"] + (f"({row['subscript']})" if row["subscript"] else "")


def uses(name, kind, numbers):
    """Statements that take the entity into the base system, a copy or its points."""
    if kind == "PATERN":
        return "".join(f"Q{name}{i}=POINT/{name},{i}\n" for i in range(1, len(numbers) // 3 + 1))
    return "QQ" + name.replace("(", "").replace(")", "") + f"={kind}/{name},CANON\n"


class Refsys(ArelemCase):
    def geometry(self, text, exit_code=0):
        self.write("part.apt", text + "FINI\n")
        self.assertExit(exit_code, "geometry", "part.apt", "--json", "-q")
        return json.loads(self.out)

    def assertSame(self, actual, wanted, kind, where):
        self.assertEqual(len(actual), len(wanted), where)
        size = max(map(abs, wanted)) or 1.0
        most = max(range(len(wanted)), key=lambda i: abs(wanted[i]))
        sign = math.copysign(1.0, actual[most] * wanted[most])  # planes and conics have two signs
        for a, b in zip(actual, wanted):
            self.assertAlmostEqual(a * (sign if kind in CONICS | {"LINE", "PLANE"} else 1.0), b, delta=1e-9 * size, msg=where)

    def test_defined_locally_is_defined_plainly_and_moved(self):
        kinds = set()
        compared = 0
        for path, text in programs():
            rows = {full_name(row): row for row in self.geometry(text) if row["type"] in MOVED and row["name"] != "*NESTED*"}
            for system in SYSTEMS:
                wanted = {name: system.seen(row["type"], row["values"]) for name, row in rows.items()}
                seen = "".join(uses(name, *moved) for name, moved in wanted.items())
                local = self.geometry(f"{system.text()}REFSYS/MSYS\n{text}REFSYS/NOMORE\n{seen}")
                actual = iter(local[-len(seen.splitlines()):])
                for name, (kind, numbers) in wanted.items():
                    got = []
                    while len(got) < len(numbers):
                        got += next(actual)["values"]
                    self.assertSame(got, numbers, kind, f"{path.name} {name} tilted={system.tilted}")
                    compared += 1
                    kinds.add(rows[name]["type"])
        self.assertEqual(kinds, MOVED)
        self.assertGreaterEqual(compared, 2 * 150)

    def test_what_cannot_be_moved_is_refused_outside(self):
        self.write("part.apt", SYSTEMS[0].text() + "REFSYS/MSYS\nX=TABCYL/NOZ,SPLINE,0,0,1,1,2,0,3,1\nREFSYS/NOMORE\n"
                   "P=POINT/INTOF,(LINE/1.5,0,1.5,1),X,(POINT/1.5,0)\nFINI\n")
        self.assertExit(4, "check", "part.apt")
        self.assertIn("E0323", self.err)


if __name__ == "__main__":
    unittest.main()
