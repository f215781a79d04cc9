"""What a part program asks of each motion, read from its source text without the compiler.

Follows straight-line programs only: no loops, macros, labels, reference systems or output transformations. A program
that has one of these is reported as not followed.
"""
import re

HEADINGS = {"GOLFT", "GORGT", "GOFWD", "GOBACK", "GOUP", "GODOWN"}
SIDES = {"TLLFT", "TLRGT", "TLON", "TLNDON"}
FIXED = {"PARTNO", "PPRINT", "INSERT", "REMARK", "TITLES"}
CONDITIONS = {"TO", "ON", "PAST", "TANTO", "PSTAN", "DSTAN"}
UNFOLLOWED = {"LOOPST", "MACRO", "CALL", "REFSYS", "TRACUT", "COPY", "SYN", "TRANTO", "READ", "POCKET", "CUT",
              "DNTCUT", "VTLAXS"}


class Unfollowed(Exception):
    pass


def statements(text):
    """(number, statement without blanks) of each statement; the numbers count as in the listing."""
    number, pending = 0, None
    for line in text.splitlines():
        line = line.expandtabs(8)[:72]
        if pending is None:
            number += 1
            if line[:6].upper() in FIXED:
                continue
            pending = ""
        code, mark, rest = line.partition("$")
        pending += re.sub(r"\s", "", code).upper()
        if mark and not rest.lstrip().startswith("$"):
            continue
        if pending:
            yield number, pending
        pending = None


def name_nested(text):
    """The program with every nested definition of a motion statement named, and those names by statement.

    Geometry that only a motion statement defines is then printed by `arelem geometry` like any other.
    """
    out, count = [], 0
    for line in text.splitlines():
        def named(match):
            nonlocal count
            count += 1
            return f"(ZZ{count}={match.group(1)}/"
        if re.search(r"\bGO|OFFSET|PSIS", line.upper()):
            line = re.sub(r"\(\s*([A-Za-z]{4,6})\s*/", named, line)
        out.append(line)
    return "\n".join(out) + "\n"


def split_top(text):
    """The parameters of a statement: split at commas outside parentheses."""
    parts, depth, current = [], 0, ""
    for c in text:
        depth += (c == "(") - (c == ")")
        if c == "," and depth == 0:
            parts.append(current)
            current = ""
        else:
            current += c
    return parts + [current]


def surface_name(parameter):
    """`L1`, `P(3)` or the name given in `(L1=LINE/...)`."""
    match = re.fullmatch(r"\((\w+(?:\(\d+\))?)=.*\)", parameter)
    return match.group(1) if match else parameter


class State:
    def __init__(self):
        self.side, self.on_part = None, False  # no side: as the last startup found the tool
        self.startup_on = True
        self.part = None  # the XY plane
        self.inner, self.outer, self.thick = [0.0] * 4, [0.0005] * 4, [0.0] * 4
        self.cutter, self.option = None, False


def spread(values):
    return (values + [values[-1]] * 4)[:4]


def numbers(parameters, scalars):
    found = []
    for p in parameters:
        p = p.strip("()") if p.startswith("(") else p
        sign, p = (-1.0, p[1:]) if p.startswith("-") else (1.0, p)
        if p in scalars:
            found.append(sign * scalars[p])
            continue
        try:
            found.append(sign * float(p))
        except ValueError as error:
            raise Unfollowed(f"parameter {p}") from error
    return found


def demands(text, scalars):
    """By statement number what holds while that motion runs: side, part surface and relation, tolerances, cutter.

    `scalars` are the program's scalars by name. Raises Unfollowed.
    """
    state, found = State(), {}
    for number, statement in statements(text):
        statement = re.sub(r"^\w+\)", "", statement)
        head, slash, tail = statement.partition("/")
        words = head.split(",")
        if UNFOLLOWED & set(words) or re.match(r"\w+=MACRO", statement) or head.startswith("IF("):
            raise Unfollowed(words[-1])
        for word in words:
            if word in SIDES:
                state.side = "TLON" if word == "TLNDON" else word
            elif word in ("TLONPS", "TLOFPS"):
                state.on_part = word == "TLONPS"
        word, parameters = words[-1], split_top(tail) if slash else []
        if word in ("INTOL", "OUTTOL", "TOLER"):
            values = spread(numbers(parameters, scalars))
            if word == "INTOL":
                state.inner = values
            else:
                state.outer = values
                state.inner = state.inner if word == "OUTTOL" else [0.0] * 4
        elif word == "THICK":
            state.thick = spread(numbers(parameters, scalars))
        elif word == "CUTTER":
            state.option = parameters[0] == "OPTION"
            if not state.option:
                state.cutter = numbers(parameters, scalars)
        elif word == "PSIS":
            state.part = surface_name(parameters[0])
        elif word == "AUTOPS":
            state.part = "AUTOPS"
        elif word in ("GO", "OFFSET"):
            state.startup_on = parameters[0] == "ON"
            surfaces = [surface_name(p) for p in parameters if p not in CONDITIONS]
            if len(surfaces) > 1 and not re.fullmatch(r"[-+.\d]+", surfaces[1]):
                state.part = surfaces[1]
        elif word in HEADINGS:
            on = state.startup_on if state.side is None else state.side == "TLON"
            found[number] = {"drive": surface_name(parameters[0]), "on": on, "part": state.part,
                             "on_part": state.on_part, "inner": state.inner, "outer": state.outer,
                             "thick": state.thick, "cutter": state.cutter, "option": state.option, "word": word}
    return found
