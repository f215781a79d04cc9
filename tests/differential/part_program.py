"""What a part program asks of each motion, read from its source text without the compiler.

The text is followed from record to record: between the statements of two records everything in between was executed,
and a record of an earlier statement means that a jump was taken. Cutters and tolerances of library macros come from
their records. Local reference systems, macros with motion and POCKET are not followed.
"""
import re

HEADINGS = {"GOLFT", "GORGT", "GOFWD", "GOBACK", "GOUP", "GODOWN"}
SIDES = {"TLLFT", "TLRGT", "TLON", "TLNDON"}
FIXED = {"PARTNO", "PPRINT", "INSERT", "REMARK", "TITLES"}
CONDITIONS = {"TO", "ON", "PAST", "TANTO", "PSTAN", "DSTAN"}
UNFOLLOWED = {"REFSYS", "SYN", "TRANTO", "READ", "POCKET", "CUT", "DNTCUT", "VTLAXS"}
SECTION_3 = re.compile(r"\s*(?:\w+\))?\s*(TRACUT|COPY|INDEX)\s*/", re.I)
DEFINITION = re.compile(r"(\w+(?:\(\d+\))?)=(?!MACRO)[A-Z]+/")


class Unfollowed(Exception):
    pass


def statements(text):
    """(line, statement without blanks) of each statement; the line is the one that it begins on."""
    begin, pending = 0, None
    for number, line in enumerate(text.splitlines(), 1):
        line = line.expandtabs(8)[:72]
        if pending is None:
            begin = number
            if line[:6].upper() in FIXED:
                yield number, line[:6].upper()
                continue
            pending = ""
        code, mark, rest = line.partition("$")
        pending += re.sub(r"\s", "", code).upper()
        if mark and not rest.lstrip().startswith("$"):
            continue
        if pending:
            yield begin, pending
        pending = None


def without_section_3(text):
    """The program with its TRACUT, COPY and INDEX statements emptied, or None if it has none."""
    lines = ["$$" if SECTION_3.match(line) else line for line in text.splitlines()]
    return "\n".join(lines) + "\n" if lines != text.splitlines() else None


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
        self.cutter, self.disks = None, {}  # disks of CUTTER/OPTION: 1 for the part surface, 2 for the drive surface
        self.defined = {}  # how often each name was defined


def spread(values):
    return (list(values) + [values[-1]] * 4)[:4]


def number(parameter, scalars):
    """The value of a sum, product or name; scalars are those at the end of the program."""
    text = re.sub(r"[A-Z]\w*", lambda m: repr(scalars.get(m.group(), m.group())), parameter)
    if not re.fullmatch(r"[-+*/().\de]+", text):
        raise Unfollowed(f"parameter {parameter}")
    return float(eval(text, {"__builtins__": {}}))  # digits and operators only


def numbers(parameters, scalars):
    return [number(p, scalars) for p in parameters]


class Follower:
    """Follows one program. `rows` are all its definitions in order, as (name, type, canon)."""

    def __init__(self, text, rows):
        self.statements = list(statements(text))
        self.place = {line: i for i, (line, _) in enumerate(self.statements)}
        self.scalars = {name: canon[0] for name, kind, canon in rows if kind == "SCALAR"}
        self.versions = {}
        for name, kind, canon in rows:
            if kind != "SCALAR":
                self.versions.setdefault(name, []).append((kind, canon))
        self.state, self.at, self.used = State(), -1, set()

    def demands(self, records, lines):
        """For each motion of the records what holds while it runs, or None for what is no path along a surface.

        `lines` are the lines of the program by statement number; library macros are not among them. Raises
        Unfollowed. A demand has the drive and part surface (type and canon, or None for the XY plane, or "AUTOPS"),
        sides, cutter, tolerances and the word, and the check surface if there is just one.
        """
        found = []
        for record in records:
            line = lines.get(record["isn"])
            if line is None:
                self.library(record)
            else:
                self.reach(self.place_of(line))
            if record["type"] == 5000 and record["kind"] != "CONT":
                found.append(self.demand() if line is not None else None)
        self.sweep(self.at + 1, len(self.statements))
        for name in self.used:
            if self.state.defined.get(name, 0) != len(self.versions[name]):
                raise Unfollowed(f"definitions of {name}")
        return found

    def place_of(self, line):
        if line not in self.place:
            raise Unfollowed(f"line {line}")
        return self.place[line]

    def library(self, record):
        if record["kind"] == "CUTTER":
            self.state.cutter, self.state.disks = record["values"], {}
        elif record["kind"] == "INTOL":
            self.state.inner = spread(record["values"])
        elif record["kind"] == "OUTTOL":
            self.state.outer = spread(record["values"])

    def reach(self, place):
        if place < self.at:
            jump, target = self.jump_back(place)
            self.sweep(self.at + 1, jump)
            self.sweep(target, place + 1)
        else:
            self.sweep(self.at + 1, place + 1)
        self.at = place

    def jump_back(self, place):
        """The first statement behind the current one from which a jump leads to `place` or before it."""
        labels = {m.group(1): i for i, (_, s) in enumerate(self.statements) if (m := re.match(r"(\w+)\)", s))}
        for i in range(self.at + 1, len(self.statements)):
            statement = re.sub(r"^\w+\)", "", self.statements[i][1])
            if statement.startswith(("JUMPTO/", "IF(")):
                targets = re.split(r"[/,)]", statement)
                back = [labels[t] for t in targets if labels.get(t, place + 1) <= place]
                if back:
                    return i, max(back)
        raise Unfollowed("a jump back")

    def sweep(self, first, last):
        inside = False
        for _, statement in self.statements[first:last]:
            inside = inside or "=MACRO" in statement
            if not inside:
                self.execute(statement)
            elif HEADINGS & set(re.split(r"\W", statement)):
                raise Unfollowed("a macro with motion")
            inside = inside and not statement.endswith("TERMAC")

    def execute(self, statement):
        statement = re.sub(r"^\w+\)", "", statement)
        for match in DEFINITION.finditer(statement):
            self.state.defined[match.group(1)] = self.state.defined.get(match.group(1), 0) + 1
        head, slash, tail = statement.partition("/")
        words = head.split(",")
        if UNFOLLOWED & set(words):
            raise Unfollowed(words[-1])
        state = self.state
        for word in words:
            if word in SIDES:
                state.side = "TLON" if word == "TLNDON" else word
            elif word in ("TLONPS", "TLOFPS"):
                state.on_part = word == "TLONPS"
        word, parameters = words[-1], split_top(tail) if slash else []
        if word in ("INTOL", "OUTTOL", "TOLER"):
            values = spread(numbers(parameters, self.scalars))
            if word == "INTOL":
                state.inner = values
            else:
                state.outer = values
                state.inner = state.inner if word == "OUTTOL" else [0.0] * 4
        elif word == "THICK":
            state.thick = spread(numbers(parameters, self.scalars))
        elif word == "CUTTER":
            self.cutter(words, parameters)
        elif word == "PSIS":
            state.part = surface_name(parameters[0])
        elif word == "AUTOPS":
            state.part = "AUTOPS"
        elif word in ("GO", "OFFSET"):
            state.startup_on = parameters[0] == "ON"
            surfaces = [surface_name(p) for p in parameters if p not in CONDITIONS]
            if len(surfaces) > 1 and not re.fullmatch(r"[-+.\d]+", surfaces[1]):
                state.part = surfaces[1]

    def cutter(self, words, parameters):
        if "OPTION" not in words and parameters[0] != "OPTION":
            self.state.cutter, self.state.disks = numbers(parameters, self.scalars), {}
            return
        which, *disk = parameters[1:] if parameters[0] == "OPTION" else parameters
        self.state.disks[int(which)] = None if disk == ["OFF"] else numbers(disk, self.scalars)

    def version(self, name):
        """The surface that a name means now; None for the XY plane and for what is not known."""
        if name is None or name == "AUTOPS":
            return name
        versions = self.versions.get(name)
        if versions is None:
            return ("unknown", name)
        if len(versions) > 1:
            self.used.add(name)
        return versions[min(max(self.state.defined.get(name, 0), 1), len(versions)) - 1]

    def demand(self):
        statement = re.sub(r"^\w+\)", "", self.statements[self.at][1])
        head, _, tail = statement.partition("/")
        word = head.split(",")[-1]
        if word not in HEADINGS:
            return None
        state = self.state
        on = state.startup_on if state.side is None else state.side == "TLON"
        checks = [p for p in split_top(tail)[1:] if p not in CONDITIONS and p != "INTOF" and not p.isdigit()]
        return {"check": self.version(surface_name(checks[0])) if len(checks) == 1 else None,
                "check_on": "ON" in split_top(tail), "touch": bool({"TANTO", "PSTAN"} & set(split_top(tail))),
                "drive": self.version(surface_name(split_top(tail)[0])), "on": on, "part": self.version(state.part),
                "on_part": state.on_part, "inner": state.inner, "outer": state.outer, "thick": state.thick,
                "cutter": state.cutter, "disks": dict(state.disks), "word": word}
