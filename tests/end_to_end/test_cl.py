#!/usr/bin/env python3
"""CL files of CAM systems: arcs, splines, axes, frames and comments reach the outputs as they are meant."""
import json
import math
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

    def test_an_angle_of_too_many_turns_is_refused(self):
        self.write("a.cls", "$$ISO\nGOTO/1,0,0\nMOVARC/0,0,0,0,0,1,1,ANGLE,1.E24\nGOTO/0,1,0\nFINI\n")
        self.assertExit(4, "compile", "a.cls")
        self.assertIn("E0572", self.err)

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

    def test_names_of_operations_are_kept(self):
        lines = self.cl("$$-> FEATNO / 402\n$$ OPERATION NAME : Profile Finish.1  \n$$ Start generation of : Profile Finish.1\n"
                        "$$ centerline data\nGOTO/1,2,3\nFINI\n", "--dialect", "cl")
        self.assertEqual(lines, ["PPRINT / FEATNO / 402", "PPRINT / OPERATION NAME : Profile Finish.1", "GOTO / 1.0, 2.0, 3.0", "FINI"])

    FRAME = "$$*CATIA0\n$$ Program.1\n$$  0.0 -1.0 0.0 5.0\n$$  1.0 0.0 0.0 6.0\n$$  0.0 0.0 1.0 7.0\n"

    def test_frame_in_comments_of_catia(self):
        lines = self.cl(self.FRAME + "GOTO/1,2,3\nFINI\n")
        self.assertEqual(lines, ["$$*CATIA0", "$$ Program.1", "$$ 0 -1 0 5", "$$ 1 0 0 6", "$$ 0 0 1 7", "GOTO / 1.0, 2.0, 3.0", "FINI"])
        self.assertExit(0, "compile", "a.cls", "-o", "a.cltape")
        self.assertExit(0, "compile", "a.cltape")
        self.assertEqual(self.out.splitlines(), lines)
        lines = self.cl(self.FRAME + "GOTO/1,2,3\nLOCAL_ORIGIN, 10, 0, 0\nGOTO/1,2,3\nFINI\n", "--frame", "part")
        self.assertEqual(lines[5:], ["GOTO / 3.0, 7.0, 10.0", "LOCAL_ORIGIN / 0, 0, 0", "GOTO / 3.0, 17.0, 10.0", "FINI"])
        for broken in (self.FRAME.replace("7.0", "x"), self.FRAME.replace("$$  0.0 0.0 1.0 7.0\n", "")):
            self.assertNotIn("$$*CATIA0", self.cl(broken + "GOTO/1,2,3\nFINI\n"))  # an ordinary comment

    def test_table_that_turns(self):
        turned = "TLAXIS/ 0,-1,0\nROTABL/ 1.570796,AAXIS,TABLE,CCLW\nGOTO/1,2,3\nROTABL/ -1.570796,AAXIS,TABLE,CCLW\n"
        lines = self.cl(turned + "FINI\n", "--dialect", "cl")
        self.assertEqual(lines, ["ROTABL / 1.570796, AAXIS, TABLE, CCLW", "GOTO / 1.0, 2.0, 3.0",
                                 "ROTABL / -1.570796, AAXIS, TABLE, CCLW", "FINI"])  # the tool stands along z of the turned frame
        # y of the frame is z of the part, z is -y
        lines = self.cl(turned + "FINI\n", "--dialect", "cl", "--frame", "part")
        self.assertEqual(lines[1:3], ["MULTAX / ON", "GOTO / 1.0, -3.0, 2.0, 0.0, -1.0, 0.0"])
        self.cl(turned + "GOTO/1,2,3\nFINI\n", "--dialect", "cl")
        self.assertIn("W0598", self.err)

    def test_arcs_in_a_frame(self):
        lines = self.cl("MSYS/10,0,0,0,1,0,1,0,0\nGOTO/1,0,0\nCIRCLE/0,0,0,0,0,1,1\nGOTO/0,1,0\nFINI\n", "--frame", "part")
        self.assertEqual(lines[0], "MSYS / 0, 0, 0, 1, 0, 0, 0, 1, 0")
        self.assertEqual(lines[2:5], ["GOTO / 10.0, 1.0, 0.0, 0.0, 0.0, -1.0", "CIRCLE / 10.0, 0.0, 0.0, 0.0, 0.0, -1.0, 1.0",
                                      "GOTO / 11.0, 0.0, 0.0, 0.0, 0.0, -1.0"])

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
        self.cl("$$ISO\nUNITS/MM\nFEDRAT/100,IPM\nFEDRAT/90,IPM\nGOTO/1,2,3\nUNITS/INCHES\nFEDRAT/5,MMPM\nGOTO/2,2,3\nFEDRAT/5,IPM\n"
                "GOTO/3,2,3\nFEDRAT/6,MMPR\nGOTO/4,2,3\nFINI\n")
        self.assertEqual([line.split(":")[1] for line in self.err.splitlines() if "W0579" in line], ["3", "7", "11"])

    def test_a_place_of_two_numbers_is_told(self):
        lines = self.cl("$$ISO\nGOTO/1,2,50\nGOTO/5,6\nFINI\n")
        self.assertIn("a.cls:3:1: warning[W0580]", self.err)
        self.assertIn("GOTO / 5.0, 6.0, 0.0", lines)

    def test_words_that_a_word_does_not_take(self):
        wrong = ["SPINDL/FLOOD", "FEDRAT/CLW", "LOADTL/FLOOD", "COOLNT/CLW", "CUTCOM/FLOOD", "DELAY/CLW", "TURRET/IPM", "SELCTL/MIST",
                 "COOLNT/SHOWER"]
        right = ["SPINDL/1000,RPM,CLW", "FEDRAT/MMPM,9", "LOADTL/1,LENGTH,2", "COOLNT/MIST", "CUTCOM/LEFT,XYPLAN", "DELAY/2"]
        self.write("a.cls", "\n".join(["$$ISO", *wrong, *right, "GOTO/1,2,3", "FINI", ""]))
        self.assertExit(0, "check", "a.cls", "--words")
        self.assertEqual(self.err.count("W0583"), len(wrong))
        counts = [line.split(None, 2) for line in self.out.splitlines()]
        for word in ("SPINDL", "FEDRAT", "LOADTL", "CUTCOM", "DELAY"):
            self.assertIn([word, "1", "reported"], counts)
            self.assertIn([word, "1", "understood"], counts)
        lines = self.cl("\n".join(["$$ISO", *wrong, "GOTO/1,2,3", "FINI", ""]))
        self.assertIn("SPINDL / FLOOD", lines)

    def test_words(self):
        self.write("a.cls", "$$ISO\nPAINT/PATH\nPAINT/COLOR,3\nGOTO/1,2,3,0,0\nGOTO/1,2,3\nFEDRAT/MMPM,10\nFINI\n")
        self.assertExit(0, "check", "a.cls", "--words")
        counts = [line.split(None, 2) for line in self.out.splitlines()]
        for row in (["PAINT", "2", "passed on"], ["GOTO", "1", "understood"], ["GOTO", "1", "reported"],
                    ["FEDRAT", "1", "understood"], ["$$", "1", "comments, not in the CL data"]):
            self.assertIn(row, counts)

    def test_numbers_of_words_on_tapes(self):
        self.write("a.apt", "MACHIN/MILL,1\nFEDRAT/100,MMPM\nROTABL/90,CLW\nMYWORD/1,OTHER,IPM\nGOTO/1,2,3\nFINI\n")
        self.write("c.toml", "[minor]\nMMPM=399\nOTHER=400\nGRID=73\n[major]\nMYWORD=1026\nROTABL=1500\n")
        codes = ("--codes", "c.toml")
        self.assertExit(0, "compile", "a.apt", "--dialect", "cl", "-o", "a.cltape", "-o", "a.cls", *codes)
        self.assertExit(0, "dump", "a.cltape", *codes)
        self.assertRegex(self.out, r"2000/1500 .*ROTABL / 90.0, CLW")
        self.assertRegex(self.out, r'2000/1026 .*MYWORD / 1.0, "OTHER", "IPM"')  # GRID has taken the number of IPM
        tape = (self.folder / "a.cltape").read_bytes()
        for code in (399, 400):
            self.assertIn(code.to_bytes(8, "little"), tape)
        self.assertExit(0, "compile", "a.cltape", "-o", "b.cltape", "-o", "b.cls", *codes)
        self.assertEqual((self.folder / "b.cltape").read_bytes(), tape)
        self.assertEqual((self.folder / "b.cls").read_text(), (self.folder / "a.cls").read_text())
        self.assertExit(0, "compile", "a.cltape", "-o", "c.cls")  # without the file the numbers mean other words
        self.assertIn("MYWORD", (self.folder / "a.cls").read_text())
        self.assertNotIn("MYWORD", (self.folder / "c.cls").read_text())

    def test_code_file_of_the_library(self):
        self.write("a.apt", "FEDRAT/100,MMPM\nGOTO/1,2,3\nFINI\n")
        self.assertExit(0, "compile", "a.apt", "-o", "a.cltape", "--codes", "apt4")
        self.assertIn((171).to_bytes(8, "little"), (self.folder / "a.cltape").read_bytes())
        self.assertExit(0, "compile", "a.apt", "-o", "b.cltape")
        self.assertIn((315).to_bytes(8, "little"), (self.folder / "b.cltape").read_bytes())

    def test_wrong_code_files(self):
        self.write("a.apt", "GOTO/1,2,3\nFINI\n")
        self.write("a.cltape", "old")
        for text, said in {
            "[minor]\nMMPM=0\n": "line 2: the code of MMPM must be a whole number from 1 to 32767",
            "[minor]\nA=7\nB=7\n": "A and B have the same code, 7",
            "[major]\nMYWORD=1009\n": "MYWORD takes the code 1009 of FEDRAT",
            "[words]\nA=1\n": "`words`",
            "[minor]\nlower=1\n": "`lower` is no word",
            "[minor\n": "line 1",
        }.items():
            self.write("c.toml", text)
            with self.subTest(text):
                self.assertExit(3, "compile", "a.apt", "-o", "a.cltape", "--codes", "c.toml")
                self.assertIn("E0605", self.err)
                self.assertIn(said, self.err)
                self.assertEqual((self.folder / "a.cltape").read_text(), "old")
        self.assertExit(3, "compile", "a.apt", "--codes", "none.toml")

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

    def test_diff_of_an_arc_and_its_chords(self):
        head = "FEDRAT/100\nGOTO/10,0,0\n"
        self.write("a.cls", head + "CIRCLE/0,0,0,0,0,1,10\nGOTO/0,10,3\nGOTO/0,10,5\nFINI\n")
        # 32 chords of a quarter turn: the sagitta is 10 * (1 - cos(90/64 degrees)) = 0.0030.
        chords = "".join(f"GOTO/{10 * math.cos(i * math.pi / 64):.9f},{10 * math.sin(i * math.pi / 64):.9f},{3 * i / 32:.9f}\n"
                         for i in range(1, 33))
        self.write("b.cls", head + chords + "GOTO/0,10,5\nFINI\n")
        self.assertExit(5, "diff", "a.cls", "b.cls")
        self.assertExit(5, "diff", "a.cls", "b.cls", "--chords", "0.0029")
        for pair in (("a.cls", "b.cls"), ("b.cls", "a.cls")):
            self.assertExit(0, "diff", *pair, "--chords", "0.0031")
            self.assertIn("1 arc of one file is straight moves of the other", self.out)
        self.write("b.cls", head + chords.replace("GOTO/0.000000000,10.", "GOTO/0.000000000,10.1") + "GOTO/0,10,5\nFINI\n")
        self.assertExit(5, "diff", "a.cls", "b.cls", "--chords", "0.0031")

    def test_diff_of_words_and_as_json(self):
        self.write("a.cls", "SPINDL/100,CLW\nGOTO/1,0,0\nCOOLNT/ON\nGOTO/2,0,0\nSTOP\nFINI\n")
        self.write("b.cls", "SPINDL/100,CLW\nGOTO/1,0,0\nCOOLNT/OFF\nGOTO/2,0,0\nFINI\n")
        self.assertExit(0, "diff", "a.cls", "b.cls")
        self.assertExit(5, "diff", "a.cls", "b.cls", "--words")
        self.assertIn("move 2 (a.cls:4)", self.out)
        self.assertIn("words before it `COOLNT/ON` and `COOLNT/OFF`", self.out)
        self.assertIn("words behind the last move: `STOP` and none", self.out)
        self.assertExit(5, "diff", "a.cls", "b.cls", "--words", "--json")
        told = json.loads(self.out)
        self.assertEqual((told["same"], told["differing"], told["a"]["moves"]), (False, 2, 2))
        self.assertEqual((told["first"]["a"]["line"], told["first"]["distance"]), (4, 0.0))
        self.assertExit(0, "diff", "a.cls", "b.cls", "--json")
        self.assertIs(json.loads(self.out)["same"], True)

    def test_diff_of_a_unit_that_changes(self):
        self.write("a.cls", "UNITS/MM\nGOTO/25.4,0,0\nGOTO/50.8,0,0\nFINI\n")
        self.write("b.cls", "UNITS/INCHES\nGOTO/1,0,0\nUNITS/MM\nGOTO/50.8,0,0\nFINI\n")
        self.assertExit(0, "diff", "a.cls", "b.cls")

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


    def points(self, path, *words):
        self.assertExit(0, "compile", SHARED / "corpus" / path, "--to", "json", *words)
        rows = [json.loads(line) for line in self.out.splitlines()]
        return [p for r in rows if r["kind"] == "GOTO" for p in r["points"]]

    def assertNear(self, a, b):
        for x, y in zip(a, b, strict=True):
            self.assertAlmostEqual(x, y, 6)

    def test_solidworks_writes_places_in_the_world(self):
        # Nested parts, each with a CSYS of its own: as they stand, all paths lie on the sheet of 465.4 by 243.9, off it by no more
        # than the cutter's diameter. Moved by their CSYS, the third part would lie upon the second.
        sheet = (465.40922, 243.942457)
        for p in self.points("aamorim-aptpost/manufacture3-bottom.apt"):
            for value, size in zip(p, sheet):
                self.assertTrue(-6 < value < size + 6, p)

    def test_creo_writes_places_in_the_machine_frame(self):
        # The same job with another CSYS of its first sequence: the places are the same.
        plain, turned = (SHARED / "corpus" / f"s2538-creo/{name}.ncl.1" for name in ("op010", "op010-axis_change"))
        self.assertExit(0, "diff", plain, turned)
        self.assertExit(0, "diff", plain, turned, "--frame", "part")

    def test_nx_writes_places_in_msys(self):
        name = "humman-clsf/_1_KONTUR_NAR_40_N2.cls"  # MSYS/393,-297.5,3, x along y and y along x
        self.assertNear(self.points(name)[0], [738.7532, 39.94, 478])
        self.assertNear(self.points(name, "--frame", "part")[0], [393 + 39.94, 738.7532 - 297.5, 3 - 478, 0, 0, -1])

    def test_camworks_turns_the_table(self):
        name = "aamorim-aptpost/Interface-glue.clt"  # TLAXIS/0,-1,0 and a table turned by 90 degrees about x
        written, part = self.points(name), self.points(name, "--frame", "part")
        self.assertNear(written[0], [67.5, 120.5, 25])
        self.assertNear(part[0], [67.5, -25, 120.5, 0, -1, 0])
        self.assertEqual({len(p) for p in written}, {3})
        self.assertEqual({tuple(round(x, 9) + 0.0 for x in p[3:]) for p in part}, {(0, -1, 0)})
        # Its third operation does not turn the table back; OPFEATEND does.
        # BOX/0,76.4,0,115,20,115: the holes of the first operation begin on its face y = 20, within the depth of the spot drill
        self.assertTrue(all(abs(p[1] - 21.927686) < 1e-9 for p in part[1:7]))

    def test_catia_writes_places_in_its_axis_system(self):
        name = "karlo-catia/DEMO2.txt"  # $$*CATIA0 with a shift of 60 along z
        for a, b in zip(self.points(name), self.points(name, "--frame", "part"), strict=True):
            self.assertNear([a[0], a[1], a[2] + 60], b)


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
