"""`arelem verify` follows COPY as the program transforms it: nested, several of one INDEX, with TRACUT around them."""
import json
import random
import unittest

from arelem_run import PROJECT, ArelemCase

NESTED = """PARTNO NESTED
CUTTER/5
FROM/0,0,20
INDEX/1
INDEX/2
GOTO/12,0,3
GOTO/30,0,3
COPY/2,XYROT,60,1
COPY/1,TRANSL,0,70,0,1
GOTO/0,0,20
FINI
"""


class Nest:
    """A random program of ranges and copies, at most three deep."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.lines, self.used = [], 0
        self.lines.append("M1=MATRIX/XYROT,20\nM2=MATRIX/SCALE,1.5\nFROM/0,0,50")
        for _ in range(self.random.randint(1, 3)):
            self.part(0)
        self.lines.append("GOTO/0,0,50\nFINI\n")

    def goto(self):
        self.lines.append(f"GOTO/{self.random.randint(1, 40)},{self.random.randint(-40, 40)},{self.random.randint(0, 9)}")

    def copy(self, number):
        how = self.random.choice(("SAME", "TRANSL,10,-5,1", "XYROT,30", "MODIFY,M1", "MODIFY,M2"))
        self.lines.append(f"COPY/{number},{how},{self.random.randint(0, 3)}")

    def part(self, depth):
        self.goto()
        if depth == 3 or self.random.random() < 0.2:
            return
        self.used += 1
        number = self.used
        self.lines.append(f"INDEX/{number}")
        for _ in range(self.random.randint(1, 2)):
            self.part(depth + 1)
        if self.random.random() < 0.3:
            self.lines.append(f"INDEX/{number},NOMORE")
        for _ in range(self.random.randint(1, 2)):
            self.copy(number)
        if self.random.random() < 0.3:
            self.lines.append("TRACUT/M1")
            self.goto()
            self.lines.append("TRACUT/NOMORE")

    def __str__(self):
        return "\n".join(["PARTNO N", *self.lines])


class Copies(ArelemCase):
    def test_a_copy_of_a_copy_is_proven(self):
        self.write("n.apt", NESTED)
        self.assertExit(0, "verify", "n.apt")

    def test_a_copy_of_a_copy_that_moved_is_refuted(self):
        self.write("n.apt", NESTED)
        self.assertExit(0, "n.apt", "-o", "n.jsonl")
        good = (self.folder / "n.jsonl").read_text().splitlines()
        places = [i for i, line in enumerate(good) if json.loads(line).get("points")]
        self.assertEqual(len(places), 10)  # FROM, four times two, and the end
        for i in places[1:-1]:
            record = json.loads(good[i])
            record["points"][0][1] += 0.01
            self.write("n.jsonl", "\n".join([*good[:i], json.dumps(record), *good[i + 1:], ""]))
            self.assertExit(5, "verify", "n.apt", "n.jsonl")

    def test_random_nests_are_proven_in_every_way(self):
        copied = 0
        for seed in range(80):
            self.write("n.apt", str(Nest(seed)))
            with self.subTest(seed=seed, program=str(Nest(seed))):
                if self.run_arelem("n.apt", "-o", "n.jsonl"):
                    self.assertRegex(self.err, "E04")  # more than three COPYs of an INDEX, or ranges too deep
                    continue
                self.assertExit(0, "n.apt", "-o", "n.cl")
                self.assertExit(0, "verify", "n.apt")
                self.assertExit(0, "verify", "n.apt", "n.jsonl")
                self.assertExit(0, "verify", "n.apt", "n.cl", "--slack", "0.001")
                copied += 1
        self.assertGreater(copied, 60)

    def test_every_example_is_proven(self):
        programs = sorted((PROJECT / "examples").glob("*.apt"))
        self.assertGreater(len(programs), 6)
        for program in programs:
            with self.subTest(program=program.name):
                self.assertExit(0, "verify", program)


if __name__ == "__main__":
    unittest.main()
