"""`arelem verify`: an output is read again and compared with its program; a difference is exit 5."""
import unittest

from arelem_run import ArelemCase

PROGRAM = "PARTNO V\nCUTTER/2\nFROM/0,0,9\nRAPID\nGOTO/1,2,3\nA=1/3\nGOTO/A,(2*A),-1\nFINI\n"


class Verify(ArelemCase):
    def setUp(self):
        super().setUp()
        self.write("a.apt", PROGRAM)
        self.assertExit(0, "a.apt", "-o", "a.cls", "-o", "a.cltape")

    def test_a_format_without_a_reader_is_refused(self):
        self.assertExit(0, "a.apt", "-o", "a.svg", "-o", "a.jsonl", "-o", "a.lst")
        for name in ("a.svg", "a.jsonl", "a.lst"):
            self.assertExit(2, "verify", name, "--with", "a.apt")
            self.assertIn("is not read back", self.err)

    def test_fresh_outputs_pass(self):
        for output in ("a.cls", "a.cltape"):
            self.assertExit(0, "verify", output, "--with", "a.apt")
            self.assertIn("3 locations", self.err)

    def test_changed_number_is_found_at_its_statement(self):
        text = (self.folder / "a.cls").read_text()
        self.assertIn("0.333", text)
        self.write("a.cls", text.replace("0.333", "0.334", 1))
        self.assertExit(5, "verify", "a.cls", "--with", "a.apt")
        self.assertIn("a.apt:7:1: error[E0901]: location 3 of `a.cls` is 0.001 away", self.err)

    def test_rounded_output_needs_a_tolerance(self):
        self.assertExit(0, "a.apt", "-o", "r.cls", "--decimals", "3")
        self.assertExit(5, "verify", "r.cls", "--with", "a.apt")
        self.assertExit(0, "verify", "r.cls", "--with", "a.apt", "--tolerance", "0.001")

    def test_a_turned_gun_is_found(self):
        self.write("g.apt", "FROM/0,0,200,0,0,1,1,0,0\nGOTO/100,0,200,0,0,1,0,1,0\nFINI\n")
        self.assertExit(0, "g.apt", "-o", "g.cls")
        self.assertExit(0, "verify", "g.cls", "--with", "g.apt")
        text = (self.folder / "g.cls").read_text()
        self.write("g.cls", text.replace("0.0, 1.0, 0.0\n", "0.1, 1.0, 0.0\n", 1))
        self.assertExit(5, "verify", "g.cls", "--with", "g.apt")
        self.assertIn("E0920", self.err)
        self.assertIn("5.71 degrees", self.err)  # atan 0.1

    def test_lost_location(self):
        lines = (self.folder / "a.cls").read_text().splitlines(True)
        last = max(i for i, line in enumerate(lines) if line.startswith("GOTO"))
        self.write("a.cls", "".join(lines[:last] + lines[last + 1:]))
        self.assertExit(5, "verify", "a.cls", "--with", "a.apt")
        self.assertIn("E0902", self.err)

    def test_damaged_tape_is_unreadable_input(self):
        tape = (self.folder / "a.cltape").read_bytes()
        self.write("a.cltape", tape[: len(tape) // 2])
        self.assertExit(3, "verify", "a.cltape", "--with", "a.apt")


if __name__ == "__main__":
    unittest.main()
