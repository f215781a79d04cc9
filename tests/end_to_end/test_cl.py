#!/usr/bin/env python3
"""CL files of CAM systems: arcs, splines, axes, frames and comments reach the outputs as they are meant."""
import json
import os
import pathlib
import unittest

from arelem_run import PROJECT, ArelemCase

SHARED = pathlib.Path(os.environ.get("ARELEM_SHARED", PROJECT.parent / "shared"))
QUARTER = "FROM/1,0,0\nCIRCLE/0,0,0,0,0,1,1\nGOTO/0,1,0\nFINI\n"


class Cl(ArelemCase):
    def cl(self, text, *words, code=0):
        self.write("a.cls", text)
        self.assertExit(code, "compile", "a.cls", *words)
        return [line.strip() for line in self.out.splitlines()]

    def records(self, text):
        self.write("a.cls", text)
        self.assertExit(0, "compile", "a.cls", "--to", "json")
        return [json.loads(line) for line in self.out.splitlines()]

    def test_every_spelling_of_an_arc_is_one(self):
        spellings = {
            "Creo": "CIRCLE / 0, 0, 0, $\n 0, 0, 1, 1\nGOTO / 0,1,0",
            "NX": "CIRCLE/0,0,0,0,0,1,1,0.06,0.5,40,1\nGOTO/0,1,0",
            "SolidWorks": "CIRCLE/0,0,0,0,0,1.\nGOTO/0,1,0",
            "CAMWorks": "CIRCLE/ 0,0,0,0,0,1,1,COUNTERCLOCKWISE \nGOTO/0,1,0",
            "CAMWorks clockwise": "CIRCLE/ 0,0,0,0,0,-1,1,CLOCKWISE \nGOTO/0,1,0",
            "Fusion": "MOVARC/0,0,5,0,0,1,1,ANGLE,90\nGOTO/0,1,0",
            "CATIA": "INDIRV/0,1,0\nTLON,GOFWD/ (CIRCLE/ 0,0,0,$\n 1),ON,(LINE/ 0,0,0,$\n 0,1,0)",
        }
        for system, text in spellings.items():
            records = [r for r in self.records(f"$$ISO\nGOTO/1,0,0\n{text}\nFINI\n") if r["kind"] in ("GOTO", "SURFACE")]
            with self.subTest(system):
                self.assertEqual(records[-1]["points"], [[0, 1, 0]])
                self.assertEqual(records[-1]["way"], "CCLW")
                self.assertEqual(records[-2]["canon"], [0, 0, 0, 0, 0, 1, 1])

    def test_arcs_go_round_through_text_and_tape(self):
        first = self.cl(QUARTER)
        self.assertIn("CIRCLE / 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0", first)
        self.assertExit(0, "compile", "a.cls", "-o", "a.cltape")
        self.assertExit(0, "compile", "a.cltape", "-o", "b.cltape")
        self.assertEqual((self.folder / "a.cltape").read_bytes(), (self.folder / "b.cltape").read_bytes())
        self.assertExit(0, "compile", "b.cltape", "--to", "cl")
        self.assertEqual([line.strip() for line in self.out.splitlines()], first)
        self.assertExit(0, "diff", "a.cls", "b.cltape")
        self.assertExit(0, "compile", "a.cls", "-o", "a.jsonl")
        self.assertExit(0, "diff", "a.cls", "a.jsonl")

    def test_a_mirrored_arc_turns_the_other_way(self):
        text = "M1=MATRIX/-1,0,0,0,0,1,0,0,0,0,1,0\nTRACUT/M1\n" + QUARTER
        self.write("m.apt", text)
        self.assertExit(0, "compile", "m.apt")
        self.assertIn("-1.0, 1.0", [line for line in self.out.splitlines() if line.startswith("CIRCLE")][0])

    def test_chords_of_an_arc_lie_on_it(self):
        self.write("a.cls", QUARTER)
        self.assertExit(0, "compile", "a.cls", "--to", "svg")
        self.write("s.cls", "SMOOTH/0.01\n" + QUARTER.replace("FINI", "SMOOTH/NOMORE\nFINI"))
        self.assertExit(0, "compile", "s.cls", "--to", "json")

    def test_rs274_has_the_arc(self):
        self.write("a.cls", "UNITS/MM\nFROM/10,0,0\nFEDRAT/100,MMPM\nCIRCLE/0,0,0,0,0,1,10\nGOTO/0,10,0\nFINI\n")
        self.assertExit(0, "compile", "a.cls", "--to", "ngc")
        arcs = [line for line in self.out.splitlines() if "G3" in line]
        self.assertEqual(len(arcs), 1, self.out)
        self.assertIn("X0", arcs[0])
        self.assertIn("Y10", arcs[0])

    def test_helix_with_turns(self):
        goto = [r for r in self.records("$$ISO\nGOTO/1,0,9\nCIRCLE/0,0,0,0,0,-1,1,.06,.5,40,1,TIMES,2\nGOTO/0,-1,0\nFINI\n") if r["kind"] == "GOTO"]
        self.assertEqual(len(goto), 4)
        for record, z in zip(goto, (9, 5, 1, 0)):
            self.assertAlmostEqual(record["points"][0][2], z)

    def test_tool_axes_are_not_lost(self):
        lines = self.cl("$$ISO\nGOTO/0,0,1,0,0,1\nGOTO/0,0,2,0,0,-1\nGOTO/0,0,3\nFINI\n")
        self.assertEqual(lines[0], "GOTO / 0.0, 0.0, 1.0")
        self.assertEqual(lines[1], "MULTAX / ON")
        self.assertEqual(lines[3], "GOTO / 0.0, 0.0, 3.0, 0.0, 0.0, -1.0", "NX keeps the last axis")

    def test_frame_of_solidworks_gives_the_axis(self):
        lines = self.cl("TRNTYP/WORLD,0,0,0\nCSYS/0,0,1.,0,1.,0,0,0,0,1.,0,0\nRAPID/\nGOTO/1,2,3\n"
                        "CSYS/1.,0,0,0,0,1.,0,0,0,0,1.,0\nGOTO/1,2,4\nFINI\n")
        self.assertIn("GOTO / 1.0, 2.0, 3.0, 1.0, 0.0, 0.0", lines)
        self.assertIn("GOTO / 1.0, 2.0, 4.0, 0.0, 0.0, 1.0", lines)

    def test_axis_of_zeros_is_none(self):
        self.cl("$$ISO\nGOTO/0,0,1,0,0,0\nFINI\n")
        self.assertIn("W0474", self.err)

    def test_structured_comments(self):
        lines = self.cl("$$-> MFGNO / A\n$$-> CUTTER / 0.5\n$$-> CSYS / 1, 0, 0, 0,  $\n   0, 1, 0, 0, $\n   0, 0, 1, 0\n"
                        "$$-> NOTE / 1,  $\n  2, 3\nGOTO/1,2,3\nFINI\n")
        self.assertEqual(lines, ["CUTTER / 0.5", "CSYS / 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0", "GOTO / 1.0, 2.0, 3.0", "FINI"])

    def test_lexical_traps(self):
        lines = self.cl("UNITS/ MM \nBOX/ 1,2\nCUTTER/ 6.,0.,3.,0.,0.,0.,10.,\nRAPID/ \n"
                        "CYCLE/ DRILL,G98,12.3,PECKING,5.0,2.0,MMPM,187.1,3.0,46.9 46.9 DWELL,0.0 \n"
                        "LOCAL_ORIGIN, 0., 130., 0.\nSWITCH/9\nCUTCOM/LEFT\nLOAD/TOOL,5.2\nGOTO/1,2,3\nFINI\n", "--dialect", "cl")
        self.assertEqual(self.err, "")
        self.assertIn("CUTTER / 6.0, 0.0, 3.0, 0.0, 0.0, 0.0, 10.0", lines)
        self.assertIn("SWITCH / 9", lines)
        self.assertTrue(any(line.endswith("3, 46.9, 46.9, $") for line in lines), lines)

    def test_comment_behind_a_continuation(self):
        lines = self.cl("$$ISO\nGOTO/8.198,0,0\nCIRCLE / 8., 0., 0., $ $$ 1ST ORBIT\n0., 0., 1., .198\nGOTO/8.198,0,.04\nFINI\n")
        self.assertEqual(sum(line.startswith("CIRCLE") for line in lines), 1)

    def test_spline_ends_in_its_last_control_point(self):
        text = "$$ISO\nGOTO/0,0,0\nNURBS/\nKNOT/0.5,1\nCNTRL/1,0,0\nCNTRL/2,1,0\nCNTRL/3,1,0\nCNTRL/4,1,0\nGOTO/5,1,0\nFINI\n"
        ways = [(r.get("way"), r["points"]) for r in self.records(text) if r["kind"] == "GOTO"]
        self.assertEqual(ways, [(None, [[0, 0, 0]]), ("SPLINE", [[4, 1, 0]]), (None, [[5, 1, 0]])])
        lines = self.cl(text)
        self.assertIn("CNTRL / 4, 1, 0", lines)
        self.assertExit(0, "compile", "a.cls", "-o", "a.cltape")
        self.assertExit(0, "diff", "a.cls", "a.cltape")

    def test_mixed_units(self):
        self.cl("UNITS/INCHES\nFEDRAT/35.,MMPM\nGOTO/1,2,3\nFINI\n")
        self.assertIn("W0579", self.err)

    def test_words(self):
        self.write("a.cls", "$$ISO\nPAINT/PATH\nPAINT/COLOR,3\nGOTO/1,2,3,0,0\nGOTO/1,2,3\nFEDRAT/MMPM,10\nFINI\n")
        self.assertExit(0, "check", "a.cls", "--words")
        counts = [line.split(None, 2) for line in self.out.splitlines()]
        for row in (["PAINT", "2", "passed on"], ["GOTO", "1", "understood"], ["GOTO", "1", "reported"],
                    ["FEDRAT", "1", "understood"], ["$$", "1", "comments, not in the CL data"]):
            self.assertIn(row, counts)

    def test_diff_tells_first_and_largest(self):
        self.write("a.cls", "GOTO/1,0,0\nGOTO/2,0,0\nGOTO/3,0,0\nRAPID\nGOTO/4,0,0\nFINI\n")
        self.write("b.cls", "GOTO/1,0,0\nGOTO/2,0,.5\nGOTO/3,0,2\nRAPID\nGOTO/4,0,0\nFINI\n")
        self.assertExit(5, "diff", "a.cls", "b.cls")
        self.assertRegex(self.out, r"first difference: move 2 \(a.cls:2\).*0.5 apart")
        self.assertRegex(self.out, r"largest difference: move 3 .*2 apart")
        self.assertExit(0, "diff", "a.cls", "b.cls", "--tolerance", "2")
        self.write("c.cls", "GOTO/1,0,0\nGOTO/9,9,9\nGOTO/2,0,0\nGOTO/3,0,0\nGOTO/4,0,0\nFINI\n")
        self.assertExit(5, "diff", "a.cls", "c.cls")
        self.assertIn("1 differ, 0 only in the first, 1 only in the second", self.out)
        self.assertIn("at rapid and straight", self.out)

    def test_diff_of_inches_and_millimeters(self):
        self.write("a.cls", "UNITS/MM\nGOTO/25.4,0,0\nFINI\n")
        self.write("b.cls", "UNITS/INCHES\nGOTO/1,0,0\nFINI\n")
        self.assertExit(0, "diff", "a.cls", "b.cls")


@unittest.skipUnless((SHARED / "corpus").is_dir(), f"the corpus is not at {SHARED}")
class Corpus(ArelemCase):
    """Every CL file of the collection compiles; its tape and its text have the same moves."""

    def test_cl_files(self):
        folders = ("aamorim-aptpost", "alexandrums-catia", "hofft-creopost", "humman-clsf", "jmr1-bcpost", "karlo-catia",
                   "kuka-fdm", "s2538-creo", "steptools-stepnode", "web")
        paths = [p for f in folders for p in sorted((SHARED / "corpus" / f).iterdir()) if p.suffix not in (".csv",)]
        self.assertGreater(len(paths), 50)
        for path in paths:
            with self.subTest(path.name):
                self.assertExit(0, "compile", path, "-o", "x.cls", "-o", "x.cltape", "-o", "x.svg")
                self.assertExit(0, "diff", path, "x.cltape")
                self.assertExit(0, "diff", path, "x.cls", "--tolerance", "2e-3")


class JsonIsRead(ArelemCase):
    def test_words_survive(self):
        self.write("w.apt", "PARTNO WORDS\nUNITS/MM\nCUTTER/6,1\nINTOL/.01\nLOADTL/2\nSPINDL/1200,CCLW\nCOOLNT/MIST\nFROM/0,0,50\n"
                   "RAPID\nGOTO/10,0,5\nFEDRAT/120,MMPM\nGOTO/10,0,0\nPPRINT HELLO\nDELAY/1.5\nMULTAX\nGOTO/20,0,0,0,0,1\n"
                   "END\nFINI\n")
        self.assertExit(0, "compile", "w.apt", "--dialect", "cl", "-o", "a.cls", "-o", "a.ngc", "-o", "a.jsonl")
        self.assertExit(0, "compile", "a.jsonl", "-o", "b.cls", "-o", "b.ngc")
        for suffix in ("cls", "ngc"):
            self.assertEqual((self.folder / f"a.{suffix}").read_text(), (self.folder / f"b.{suffix}").read_text())


if __name__ == "__main__":
    unittest.main()
