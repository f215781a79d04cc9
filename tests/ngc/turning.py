"""Machines with turning axes: where the tool is for the words of a program. Written apart from the compiler's code, with
homogeneous matrices, from the machine file alone."""
import math
import tomllib

import numpy


def rotation(direction, degrees):
    """Rodrigues' formula."""
    d = numpy.array(direction, float) / numpy.linalg.norm(direction)
    k = numpy.array([[0, -d[2], d[1]], [d[2], 0, -d[0]], [-d[1], d[0], 0]])
    a = math.radians(degrees)
    return numpy.eye(3) + math.sin(a) * k + (1 - math.cos(a)) * (k @ k)


def about(axis, degrees):
    """Turns about a line in space."""
    point = numpy.array(axis["point"], float)
    turn = rotation(axis["direction"], degrees)
    matrix = numpy.eye(4)
    matrix[:3, :3], matrix[:3, 3] = turn, point - turn @ point
    return matrix


class Machine:
    DIRECTIONS = {"A": (1, 0, 0), "B": (0, 1, 0), "C": (0, 0, 1)}

    def __init__(self, file):
        turning = tomllib.loads(file.read_text())["turning"]
        self.kind, self.letters, self.tolerance = turning["kinematics"], turning["axes"], turning.get("tolerance", 0.005)
        self.axes = [{"direction": self.DIRECTIONS[n], "point": (0, 0, 0), "range": (-99999, 99999), **turning.get(n, {})}
                     for n in self.letters]

    def pose(self, place, words):
        """Tool end and tool axis, seen from the part, for linear axes and the words A, B, C."""
        turns = [about(axis, words["ABC".index(n)]) for axis, n in zip(self.axes, self.letters)]
        table, head = numpy.eye(4), numpy.eye(4)
        head[:3, 3] = place
        if self.kind == "table-table":
            table = turns[0] @ turns[1]
        elif self.kind == "head-head":
            head = head @ turns[0] @ turns[1]
        else:
            head, table = head @ turns[0], turns[1]
        tool = numpy.linalg.inv(table) @ head
        return tool[:3, 3], tool[:3, 2]

    def in_range(self, words):
        return all(axis["range"][0] - 1e-4 <= words["ABC".index(n)] <= axis["range"][1] + 1e-4
                   for axis, n in zip(self.axes, self.letters))
