"""RS-274 outputs, judged by the interpreter of LinuxCNC: every canonical call against the CL."""
import pathlib
import re
import sys
import unittest

from arelem_run import ARELEM, PROJECT, ArelemCase

sys.path.insert(0, str(PROJECT / "tests" / "ngc"))
import path as paths  # noqa: E402
from examples import REFUSED  # noqa: E402
import rs274  # noqa: E402

RESOLUTION = 1.5e-4  # half of the last digit in each axis, of the output and of the interpreter's print
NUMBER = re.compile(r"[A-Z]-?\d+(\.\d+)?$")


class NgcCase(ArelemCase):
    @classmethod
    def setUpClass(cls):
        try:
            cls.interpreter = rs274.Interpreter(pathlib.Path(ARELEM).resolve().parent)
        except rs274.Unavailable as why:
            print(f"SKIPPED: no RS-274 interpreter: {why}", file=sys.stderr)
            raise unittest.SkipTest(str(why))

    def interpret(self, text, *options, name="part"):
        source = self.write(f"{name}.apt", text)
        self.assertExit(0, "compile", source, "--to", "ngc", "-o", f"{name}.ngc", *options)
        program = self.folder / f"{name}.ngc"
        self.check_numbers(program.read_text())
        calls, error = self.interpreter.run(program, self.folder)
        self.assertEqual(error, "", program.read_text()[:2000])
        return calls

    def check_numbers(self, text):
        for line in text.splitlines():
            self.assertLessEqual(len(line), 255)
            if line.startswith("(") or line == "%":
                continue
            for word in line.split():
                self.assertRegex(word, NUMBER)
                self.assertNotRegex(word, r"-0+(\.0*)?$")

    def records(self, text, name="part"):
        source = self.write(f"{name}.apt", text)
        self.assertExit(0, "compile", source, "--to", "json", "-o", "-")
        return paths.cl_locations(self.out)


def with_feed(text):
    """The examples are written for postprocessors that know the feed; a control needs it in the program."""
    return text if "FEDRAT" in text else text.replace("\nFROM", "\nFEDRAT/250\nFROM", 1)


class EveryExample(NgcCase):
    def test_paths_agree(self):
        files = sorted((PROJECT / "examples").glob("*.apt"))
        self.assertTrue(files)
        arcs = 0
        for file in files:
            with self.subTest(file.name):
                text = with_feed(file.read_text())
                code, why = REFUSED.get(file.name, (None, None))
                if code == "E0672":
                    self.assertExit(6, "compile", file, "--to", "ngc", "-o", "refused.ngc")
                    self.assertIn(f"error[{code}]", self.err, why)
                    self.assertFalse((self.folder / "refused.ngc").exists())
                    continue
                moves = paths.canonical_moves(self.interpret(text))
                arcs += sum(m.arc is not None for m in moves)
                self.assertEqual(paths.compare(moves, self.records(text), RESOLUTION, 0.0021), [])
        self.assertGreater(arcs, 0)


ROUND = "PARTNO ROUND\nCUTTER/0\nTOLER/.001\nFEDRAT/200\nFROM/0,0,5\nC1=CIRCLE/0,0,20\nL1=LINE/0,0,1,0\n" \
        "RAPID,GOTO/20,0,5\nGOTO/20,0,0\nINDIRV/0,1,0\nTLON,GOFWD/C1,ON,3,INTOF,L1\nFINI\n"


class Features(NgcCase):
    def test_circle_is_arcs(self):
        calls = self.interpret(ROUND)
        moves = paths.canonical_moves(calls)
        arcs = [m for m in moves if m.arc is not None]
        self.assertGreaterEqual(len(arcs), 1)
        self.assertLess(len(moves), 12)
        self.assertEqual(paths.compare(moves, self.records(ROUND), RESOLUTION, 0.0021), [])

    def test_words(self):
        text = ("PARTNO WORDS (A)\nUNITS/MM\nCUTTER/6\nLOADTL/2\nSPINDL/1200,CCLW\nCOOLNT/MIST\nFROM/0,0,50\nRAPID\n"
                "GOTO/10,0,5\nFEDRAT/120\nGOTO/10,0,0\nDELAY/1.5\nSTOP\nOPSTOP\nCOOLNT/OFF\nSPINDL/OFF\nEND\nFINI\n")
        calls = self.interpret(text)
        names = [name for name, _ in calls]
        for wanted in ("CHANGE_TOOL", "START_SPINDLE_COUNTERCLOCKWISE", "MIST_ON", "DWELL", "PROGRAM_STOP",
                       "OPTIONAL_PROGRAM_STOP", "STOP_SPINDLE_TURNING", "PROGRAM_END"):
            self.assertIn(wanted, names)
        self.assertIn(("DWELL", ["1.5000"]), calls)
        self.assertIn(("SET_SPINDLE_SPEED", ["0", "1200.0000"]), calls)
        self.assertEqual(paths.compare(paths.canonical_moves(calls), self.records(text), RESOLUTION, 0.0), [])

    def test_canned_cycles(self):
        text = ("CUTTER/6\nSPINDL/1000,CLW\nFROM/0,0,50\nRAPID\nGOTO/0,0,20\nCYCLE/DRILL,8,MMPM,90,2\nGOTO/10,0,0\n"
                "GOTO/20,5,0\nCYCLE/OFF\nCYCLE/DRILL,4,MMPM,80,2,DWELL,.5\nGOTO/30,0,0\nCYCLE/OFF\n"
                "CYCLE/DEEP,9,MMPM,70,2,STEP,4\nGOTO/40,0,0\nCYCLE/OFF\nRAPID\nGOTO/0,0,50\nFINI\n")
        calls = self.interpret(text, "--dialect", "cl")
        bottoms = [m for m in paths.canonical_moves(calls) if m.feed is not None]
        ends = [(m.end, m.feed) for m in bottoms]
        for hole in (((10, 0, -8), 90), ((20, 5, -8), 90), ((30, 0, -4), 80), ((40, 0, -4 + 2), 70), ((40, 0, -9), 70)):
            self.assertIn(hole, [(tuple(round(x, 4) for x in e), f) for e, f in ends])
        self.assertIn(("DWELL", ["0.5000"]), calls)


if __name__ == "__main__":
    unittest.main()
