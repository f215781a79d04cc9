"""The page docs/comparison-motion.md: cut vectors and ends of our paths beside the old system's."""
import pathlib

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs" / "comparison-motion.md"
NOTED = 1e-4  # what the page says of ends holds behind this
HEAD = """<!-- Made by tests/differential/run.py --write-page: ./dev manual writes it again. -->

# Motion beside the old system's, case by case

All programs of `tests/data/oracle/cases` that move a tool. `vectors` counts the locations of the CL file; `end off` is the farthest
that any end of a motion lies from the old system's end, in the part unit. Where that is more than 0.0001, both ends lie within
the tolerance band of their surfaces, and ours is no farther from the exact place than the old one, but for the reasons named.
Every path of ours is proven to keep its tolerances ([the certificate](manual/verify.md)); [differences](differences-motion.md)
tells where the old system's are not.

| case | vectors | old | end off | |
|---|---|---|---|---|
"""


STARTUP = ("a startup: ours lies a tenth of the band inside its edge (decision 0005), the old system's anywhere in the band, here "
           "and there nearer to the exact place")


def text(outcomes, known):
    """The page; outcomes are those of run.py's compare()."""
    rows, ours, olds = [], 0, 0
    for o in outcomes:
        if "/" in o["name"] or o["name"][0] not in "cde" or not o["vectors"][1]:
            continue
        reasons = [reason.removeprefix("meant: ") for (name, check), reason in known.items()
                   if name == o["name"] and check in ("ends", "vectors")]
        if not reasons and any(off > NOTED and gaps is None for _, off, gaps in o["stops"]):
            reasons = [STARTUP]
        count, old = o["vectors"]
        ours, olds = ours + count, olds + old
        rows.append(f"| {o['name']} | {count} | {old} | {o['end']:.4f} | {'; '.join(reasons)} |\n")
    return HEAD + "".join(rows) + f"| all {len(rows)} | {ours} | {olds} | | |\n"


def check(outcomes, known, write):
    """Writes the page, or tells that it is not what would be written."""
    wanted = text(outcomes, known)
    if write:
        PAGE.write_text(wanted)
    elif not PAGE.exists() or PAGE.read_text() != wanted:
        return ["docs/comparison-motion.md is not what ./dev manual writes"]
    return []
