#!/usr/bin/env python3
"""G97 programs with one thing changed: `verify` must notice every number, word, line, block and program of them."""
import os
import random
import re
import unittest

from arelem_run import ArelemCase

BLOCK = 4  # lines
DAMAGES = int(os.environ.get("ARELEM_DAMAGES", "8"))  # of each kind and set-up
ROUND = ("UNITS/MM\nG1=GUN/CONE,14,STNDOF,200,SPEED,600,EFFIC,.5\nR1=REGION/(0,0),(300,0),(300,200),(0,200)\n"
         "SPRAY/R1,GUN,G1,FILM,.04\nFINI\n")
FAN = ROUND.replace("GUN/CONE,14,", "GUN/FAN,60,")
LEANING = ("UNITS/MM\nG1=GUN/CONE,8,STNDOF,150,SPEED,600,EFFIC,.5\nC1=CYLNDR/400,0,0,.2,.9797958971,0,150\n"
           "SPRAY/C1,GUN,G1,FILM,.02,ULINES,LIMITS,20,160,0,60,CHORD,2\nFINI\n")
INCHES = "UNITS/INCHES\nFROM/0,0,5\nFEDRAT/60,IPM\nSPRAY/ON,2\nGOTO/3,0,5\nGOTO/3,4,5\nSPRAY/OFF,2\nRAPID\nGOTO/0,0,5\nFINI\n"
WORDS = ("UNITS/MM\nMULTAX/ON\nFROM/0,0,100,.1,.2,.9\nDELAY/2\nFEDRAT/50,MMPS\nSPRAY/ON,1\nSPRAY/ON,2\nGOTO/10,0,100,.3,.1,.9\n"
         "DELAY/3\nSPRAY/OFF,1\nGOTO/20,0,100,.1,.2,.9\nSPRAY/OFF,2\nFEDRAT/70,MMPS\nGOTO/30,0,100,0,.2,.9\n"
         "RAPID\nGOTO/30,0,150,0,.2,.9\nGOTO/20,0,100,0,.2,.9\nGOTO/10,0,100,0,.2,.9\nFINI\n")
BASE = "[frame]\nshift = [700, 400, 1000]\nangles = [-90, 10, 20]\n"
SETUPS = {
    "round gun": (ROUND, "", ()),
    "fan": (FAN, "", ()),
    "leaning": (LEANING, "", ()),
    "fixed axes": (LEANING, '[g97]\nangles = "fixed"\n', ()),
    "upright roll": (LEANING, '[g97]\nroll = "upright"\n', ()),
    "source's formulas": (LEANING, "", ("--compat", "robopaint")),
    "at the base, with a tool": (LEANING, BASE + '[g97]\ncoordinates = "base"\ntool = [10, 0, -80]\n', ()),
    "another configuration": (LEANING, '[g97]\nwrist = "F"\narm = "B"\nturns = [1, 0, -1]\nprogram = 30\n', ()),
    "outputs": (INCHES, "[g97]\noutputs = [3, 7]\n", ()),
    "several programs": (LEANING, "rapid = 250\n[g97]\nblocks = 30\n", ()),
    "no numbers": (LEANING, "[g97]\nblocks = 30\nprogram_line = false\n", ()),
    "codes": (WORDS, '[g97]\nblocks = 6\ns63 = "S63,1,1,1"\n[g97.words]\nDELAY = "DLY,{1}"\n', ()),
}


def renumbered(lines):
    """N counts from 1 again: what only a comparison of contents finds."""
    count = 0
    for line in lines:
        count = 0 if line.startswith("O") else count
        if re.match(r"N\d{4} ", line):
            count += 1
            line = f"N{count:04}{line[5:]}"
        yield line


def words_changed(lines):
    """Each word of each line: its number, its letter, without it, twice."""
    for i, line in enumerate(lines):
        for found in re.finditer(r"[^ ,]+", line):
            word, begin, end = found.group(), found.start(), found.end()

            def put(new):
                return [*lines[:i], line[:begin] + new + line[end:], *lines[i + 1:]]
            yield f"line {i + 1}: {word} left out", put("")
            yield f"line {i + 1}: {word} twice", put(f"{word} {word}")
            for at, letter in enumerate(word):
                if letter.isdigit():
                    for new in str((int(letter) + 1) % 10), str((int(letter) + 9) % 10):
                        yield f"line {i + 1}: {word} with {new}", put(word[:at] + new + word[at + 1:])
                elif letter.isalpha():
                    for new in set("LPNFBRO") - {letter}:
                        yield f"line {i + 1}: {word} with {new}", put(word[:at] + new + word[at + 1:])
            if re.fullmatch(r"-?\d+\.\d\d", word):
                for step in -0.01, 0.01:
                    yield f"line {i + 1}: {word} by {step}", put(f"{float(word) + step:.2f}".replace("-0.00", "0.00"))
                yield f"line {i + 1}: - {word}", put(word[1:] if word[0] == "-" else "-" + word)


def lines_changed(lines):
    for i in range(len(lines)):
        yield f"line {i + 1} left out", lines[:i] + lines[i + 1:]
        yield f"line {i + 1} twice", [*lines[:i + 1], *lines[i:]]
        if i + 1 < len(lines):
            yield f"lines {i + 1} and {i + 2} swapped", [*lines[:i], lines[i + 1], lines[i], *lines[i + 2:]]
        if i + BLOCK < len(lines):
            yield f"lines {i + 1} and {i + 1 + BLOCK} swapped", [*lines[:i], lines[i + BLOCK], *lines[i + 1:i + BLOCK], lines[i],
                                                                  *lines[i + BLOCK + 1:]]


def blocks_changed(lines):
    """Whole blocks, numbered again: the form is right."""
    for i, line in enumerate(lines):
        if not line.startswith("N"):
            continue
        block, rest = lines[i:i + BLOCK], lines[i + BLOCK:]
        head = lines[:i]
        if block[3].endswith("BE"):
            yield f"block of line {i + 1} left out", renumbered(head + rest)
            yield f"block of line {i + 1} twice", renumbered(head + block + block + rest)
            plain = [*block[:3], "      BE"]
            yield f"block of line {i + 1} again without its code", renumbered(head + block + plain + rest)
            yield f"block of line {i + 1} before without its code", renumbered(head + plain + block + rest)
            for code in "RON,1", "ROF,1", "RON,2", "ROF,2", "DLY,2", "S63,1,1,1":
                yield f"block of line {i + 1} with {code}", [*head, *block[:3], f"      {code} BE", *rest]
            yield f"the program ends in the block of line {i + 1}", renumbered(head + block[:3] + [block[3].replace("BE", "PE")] + rest)
            new = ["O0077"] if lines[0].startswith("O") else []
            yield f"a program ends in the block of line {i + 1}", renumbered(
                head + block[:3] + [block[3].replace("BE", "PE")] + new + rest)


class Damaged(ArelemCase):
    def damages(self, lines, most):
        """A choice of each kind, the same each time; what changed nothing is no damage."""
        choose = random.Random(5)
        for kind in words_changed, lines_changed, blocks_changed:
            all_of_kind = [(name, changed) for name, changed in ((n, list(c)) for n, c in kind(lines)) if changed != lines]
            yield from choose.sample(all_of_kind, min(most, len(all_of_kind)))

    def test_each_is_noticed(self):
        for name, (program, machine, options) in SETUPS.items():
            with self.subTest(name):
                self.write("a.apt", program)
                self.write("m.toml", machine)
                with_machine = [*options, "--machine", "m.toml"] if machine else options
                self.assertExit(0, "a.apt", "-o", "a.lng", *with_machine)
                self.assertExit(0, "verify", "a.lng", "--with", "a.apt", *with_machine)
                lines = (self.folder / "a.lng").read_bytes().decode().split("\r\n")[:-1]
                for what, changed in self.damages(lines, DAMAGES):
                    (self.folder / "b.lng").write_bytes("".join(f"{line}\r\n" for line in changed).encode())
                    code = self.run_arelem("verify", "b.lng", "--with", "a.apt", *with_machine)
                    self.assertIn(code, (3, 5), f"{name}: {what}\n{self.err}")
                    self.assertRegex(self.err, r"\bE\d{4}\b")

    def test_ends_of_lines(self):
        self.write("a.apt", ROUND)
        self.assertExit(0, "a.apt", "-o", "a.lng")
        text = (self.folder / "a.lng").read_bytes()
        for changed in (text.replace(b"\r\n", b"\n"), text[:-2], text + b"\r\n", text + b"%\r\n", text + text, b"\r\n" + text,
                        text.replace(b" BE", b" BE ", 1), text.replace(b"L F", b"L  F", 1), text.lower(), b""):
            (self.folder / "b.lng").write_bytes(changed)
            self.assertExit(3, "verify", "b.lng", "--with", "a.apt")
            self.assertIn("E0645", self.err)

    def test_the_options_must_be_those_of_the_output(self):
        program, machine, _ = SETUPS["several programs"]
        self.write("a.apt", program)
        self.write("m.toml", machine)
        self.assertExit(0, "a.apt", "-o", "a.lng", "--machine", "m.toml")
        self.assertIn(self.run_arelem("verify", "a.lng", "--with", "a.apt"), (3, 5))
        for one in ("rapid = 250\n[g97]\nblocks = 60\n", "rapid = 260\n[g97]\nblocks = 30\n", "rapid = 250\n[g97]\nblocks = 20\n",
                    "rapid = 250\n[g97]\nblocks = 30\nprogram = 2\n", 'rapid = 250\n[g97]\nblocks = 30\nroll = "upright"\n',
                    "rapid = 250\n[g97]\nblocks = 30\ntool = [0, 0, 1]\n", "rapid = 250\n[g97]\nblocks = 30\noutputs = [2]\n",
                    "rapid = 250\nspeed = 5\n[g97]\nblocks = 30\n"):
            with self.subTest(one):
                self.write("n.toml", one)
                code = self.run_arelem("verify", "a.lng", "--with", "a.apt", "--machine", "n.toml")
                self.assertIn(code, (3, 5, 6), self.err)


if __name__ == "__main__":
    unittest.main()
