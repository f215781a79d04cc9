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

    def test_paths_of_fitted_outputs(self):
        # Steps of 2 degrees on a circle of 20 mm: their chords are 20 (1 - cos 1) = 0.003 off. Then a line in ten steps.
        arc = "".join(f"GOTO/(20*COSF({a})),(20*SINF({a})),0\n" for a in range(2, 92, 2))
        line = "".join(f"GOTO/{-2 * i},20,0\n" for i in range(1, 11))
        self.write("f.apt", "INTOL/0\nOUTTOL/.01\nFROM/20,0,0\n" + arc + line + "FINI\n")
        self.assertExit(0, "f.apt", "-o", "plain.cls")
        self.assertExit(0, "f.apt", "-o", "f.cls", "--fit", ".8")
        plain, fitted = (self.folder / n for n in ("plain.cls", "f.cls"))
        self.assertLess(fitted.read_text().count("GOTO"), 46)  # 45 on the circle, one line
        self.assertLess(fitted.stat().st_size, plain.stat().st_size)
        self.assertExit(5, "verify", "f.cls", "--with", "f.apt")
        self.assertExit(0, "verify", "f.cls", "--with", "f.apt", "--fit", ".8")
        self.assertIn("keeps to that of `f.apt`, 56 locations", self.err)
        # A location moved by more than the share, one that is lost, and a path that ends early.
        text = fitted.read_text()
        self.write("far.cls", text.replace("GOTO / -20.0, 20.0", "GOTO / -20.0, 20.02"))
        self.assertExit(5, "verify", "far.cls", "--with", "f.apt", "--fit", ".8")
        self.assertIn("E0901", self.err)
        lines = text.splitlines(True)
        goto = [i for i, one in enumerate(lines) if one.startswith("GOTO")]
        for lost, code in ((goto[10], "E0901"), (goto[-1], "E0902")):
            self.write("lost.cls", "".join(lines[:lost] + lines[lost + 1:]))
            self.assertExit(5, "verify", "lost.cls", "--with", "f.apt", "--fit", ".8")
            self.assertIn(code, self.err)

    SWARF = ("MULTAX\nL1=LINE/0,0,10,0\nP1=PLANE/0,0,1,0\nW=PLANE/0,1,0,0\nCUTTER/2\nINTOL/.01\nOUTTOL/.01\n"
             "FROM/0,-5,0\nGO/TO,W,TO,P1\nVTLAXS/ON,LEFT,0,2,0,RIGHT\n{moves}"
             "GOTO/10,-1,0\nVTLAXS/OFF,LEFT,10\nVTLAXS/ON,LEFT,10,2,0,RIGHT\n"
             "GOTO/20,-1,0\nVTLAXS/OFF,RIGHT,10\nGOTO/30,-1,5\nFINI\n")

    def test_swarf_sections_of_a_file(self):
        """The tilted tool of VTLAXS is taken back to the upright one, which the program proves."""
        self.write("p.apt", self.SWARF.format(moves=""))
        self.assertExit(0, "compile", "p.apt", "-o", "p.cls", "-o", "p.cltape", "-o", "p.jsonl")
        for name in ("p.cls", "p.cltape"):
            self.assertExit(0, "verify", "p.apt", name)
        text = (self.folder / "p.cls").read_text()
        # Another place along the wall, tilted by the same rule, is not where the program goes.
        self.write("q.apt", self.SWARF.format(moves="").replace("GOTO/20,-1,0", "GOTO/20,-1.2,0"))
        self.assertExit(0, "compile", "q.apt", "-o", "q.cls")
        self.assertExit(5, "verify", "p.apt", "q.cls")
        self.assertIn("E0912", self.err)
        # A tilt that is not the rule's: sin 10 degrees is 0.17365.
        place = text[text.index("GOTO / 10.0"):text.index("$$-> VTLAXS / OFF")]
        turned = "GOTO / 10.0, -0.984808, 0.173648, 0.0, 0.18, 0.983666\n"
        self.write("r.cls", text.replace(place, turned))
        self.assertExit(5, "verify", "p.apt", "r.cls", "--slack", "1e-5")
        self.assertIn("E0915", self.err)
        self.write("s.cls", text.replace("VTLAXS / ON, LEFT, 0, 2, 0, RIGHT", "VTLAXS / ON, 7", 1))
        self.assertExit(1, "verify", "p.apt", "s.cls")
        self.assertIn("E0495", self.err)

    def test_a_corner_of_a_swarf_section_is_refused(self):
        self.write("p.apt", self.SWARF.format(moves="GOTO/5,-1,0\nWCORN/LEFT,5,LEFT,5,10\n"))
        self.write("p.cls", "GOTO/1,2,3\nFINI\n")
        self.assertExit(5, "verify", "p.apt", "p.cls")
        self.assertIn("E0915", self.err)
        self.assertIn("WCORN", self.err)

    def test_damaged_tape_is_unreadable_input(self):
        tape = (self.folder / "a.cltape").read_bytes()
        self.write("a.cltape", tape[: len(tape) // 2])
        self.assertExit(3, "verify", "a.cltape", "--with", "a.apt")


if __name__ == "__main__":
    unittest.main()
