"""TRACUT and COPY once more, without the compiler: the motions of a program from those of the program without them."""
import re

import numpy as np

import part_program

SAME = 1e-9


def rigid(matrix, points):
    """Points (x,y,z or x,y,z,i,j,k) under a matrix of three rows of four."""
    turn, shift = matrix[:, :3], matrix[:, 3]
    moved = []
    for p in points:
        axis = p[3:6]
        direction = turn @ axis if len(axis) else []
        moved.append([*(turn @ p[:3] + shift), *(direction / np.linalg.norm(direction) if len(axis) else [])])
    return moved


def copy_matrix(parameters, scalars):
    """The step of COPY/n,SAME,count, COPY/n,TRANSL,x,y,z,count and COPY/n,XYROT,angle,count, and the count."""
    word, values = parameters[1], part_program.numbers(parameters[2:], scalars)
    step = np.eye(4)
    if word == "TRANSL":
        step[:3, 3] = values[:3]
    elif word != "SAME":
        axes = {"XYROT": (0, 1), "YZROT": (1, 2), "ZXROT": (2, 0)}.get(word)
        if axes is None:
            raise part_program.Unfollowed(f"COPY with {word}")
        (i, j), angle = axes, np.radians(values[0])
        step[i, i] = step[j, j] = np.cos(angle)
        step[j, i], step[i, j] = np.sin(angle), -np.sin(angle)
    return step, int(values[-1])


def expected(text, rows, motions, lines):
    """Point lists of all motions in order. `motions` are those without Section 3, `lines` as in part_program."""
    matrices = {name: np.array(canon).reshape(3, 4) for name, kind, canon in rows if kind == "MATRIX"}
    scalars = {name: canon[0] for name, kind, canon in rows if kind == "SCALAR"}
    section = [(line, s) for line, s in part_program.statements(text) if part_program.SECTION_3.match(s)]
    out, blocks, moving, given = [], {}, None, list(motions)

    def place(motion):
        """The line of a motion; of a library macro's motion that of its CALL, whose number comes before."""
        return lines[max(isn for isn in lines if isn <= motion["isn"])]

    def take_until(line):
        while given and place(given[0]) < line:
            points = given.pop(0)["points"]
            out.append(rigid(moving, points) if moving is not None else points)

    for line, statement in section:
        take_until(line)
        word, _, tail = re.sub(r"^\w+\)", "", statement).partition("/")
        parameters = part_program.split_top(tail)
        if word == "TRACUT":
            moving = None if parameters[0] == "NOMORE" else matrices[parameters[0]]
        elif word == "INDEX" and len(parameters) == 1:
            blocks[parameters[0]] = [len(out), None]
        elif word == "INDEX":
            blocks[parameters[0]][1] = len(out)
        else:
            first, last = blocks[parameters[0]]
            last = len(out) if last is None else last  # COPY ends a block that INDEX/n,NOMORE has not
            step, count = copy_matrix(parameters, scalars)
            for k in range(1, count + 1):
                matrix = np.linalg.matrix_power(step, k)[:3]
                out += [rigid(matrix, points) for points in out[first:last]]
    take_until(float("inf"))
    return out


def difference(wanted, motions):
    """None, or a sentence on the first motion that is not where TRACUT and COPY put it."""
    if len(wanted) != len(motions):
        return f"{len(motions)} motions, TRACUT and COPY make {len(wanted)}"
    for i, (points, motion) in enumerate(zip(wanted, motions)):
        if len(points) != len(motion["points"]):
            return f"motion {i + 1}: {len(motion['points'])} points instead of {len(points)}"
        off = np.abs(np.array(points) - np.array(motion["points"])).max()
        if off > SAME:
            return f"motion {i + 1} of statement {motion['isn']} is {off:.3g} from where TRACUT and COPY put it"
    return None
