#!/usr/bin/env python3
"""Words of jobs and CL files as a user meets them: arcs and their ends, cycles between holes, tools, parameters, REFUSE."""
import json
import math
import unittest

from arelem_run import ArelemCase


class Words(ArelemCase):
    def compile(self, text, *options, target="cl", code=0):
        self.write("a.apt", text)
        self.assertExit(code, "compile", "a.apt", "--to", target, *options)
        return self.out.splitlines()

    def ngc(self, text):
        """The blocks between the head and the end."""
        lines = self.compile("UNITS/MM\nFEDRAT/100\n" + text + "FINI\n", target="ngc")
        return lines[lines.index("G61") + 1 if "G61" in lines else next(i for i, x in enumerate(lines) if x.startswith("G64")) + 1:-2]

    def arcs(self, points):
        """The CL text of an arc of radius 10 about 0 from (10, 0) with GOTOs at these angles behind it."""
        places = "".join(f"GOTO/{10 * math.cos(math.radians(a)):.9f},{10 * math.sin(math.radians(a)):.9f},0\n" for a in points)
        return self.compile(f"$$-> FEATNO / 5\nUNITS/MM\nFROM/10,0,0\nCIRCLE/0,0,0,0,0,1,10\n{places}FINI\n", "--dialect", "cl")

    def test_points_on_an_arc_stay_on_it(self):
        lines = self.arcs((7, 14, 21))
        self.assertEqual([x.split("/")[0].strip() for x in lines if x[:2] in ("CI", "GO")], ["CIRCLE", "GOTO"] * 3)

    def test_flats_behind_an_arc_stay_straight(self):
        for points in ((90, 120, 150), (7, 90), (90, 97), (7, 14, 7)):
            lines = self.arcs(points)
            straight = [x for x in lines if x.startswith("GOTO")]
            self.assertEqual(len(straight), len(points))
            self.assertLess(len([x for x in lines if x.startswith("CIRCLE")]), len(points))
            self.assertEqual("W0585" in self.err, points[-1] > points[-2], self.err)

    def test_points_never_go_round_twice(self):
        lines = self.arcs(range(5, 400, 5))
        self.assertEqual(len([x for x in lines if x.startswith("CIRCLE")]), 72)

    def test_arcs_that_are_not_cut_are_told(self):
        for text, code, reason in (("FROM/1,0,0\nCIRCLE/0,0,0,0,0,1,1\n", "W0578", "no GOTO follows"),
                                   ("CIRCLE/0,0,0,0,0,1,1\nGOTO/0,1,0\n", "W0582", "where it starts"),
                                   ("FROM/1,0,0\nCIRCLE/0,0,0,0,0,1,1\nGODLTA/1\n", "W0582", "another motion"),
                                   ("FROM/1,0,0\nCIRCLE/0,0,0,0,0,1,1\nCIRCLE/0,0,0,0,0,1,1\nGOTO/0,1,0\n", "W0582", "another arc")):
            self.compile(text + "FINI\n")
            self.assertIn(f"[{code}]", self.err)
            self.assertIn(reason, self.err)
            self.assertIn("CIRCLE/", self.err, "at the arc")

    def test_a_moved_arc_begins_where_the_matrix_brings_it(self):
        arc = "FROM/10,0,0\nTRACUT/M\nCIRCLE/0,0,0,0,0,1,10\nGOTO/0,10,0\nTRACUT/NOMORE\n"
        lines = self.ngc("M=MATRIX/MIRROR,YZPLAN\n" + arc)
        self.assertEqual([x for x in lines if x[0] in "XG" and x != "G1"][-2:],
                         ["G1 X-10.0000 Y0.0000 Z0.0000 F100.0000", "G2 X0.0000 Y10.0000 I10.0000 J0.0000"])
        copy = "FROM/10,0,0\nINDEX/1\nCIRCLE/0,0,0,0,0,1,10\nGOTO/0,10,0\nCOPY/1,XYROT,180,1\n"
        lines = [x for x in self.compile("UNITS/MM\n" + copy + "FINI\n") if x.startswith("GOTO")]
        self.assertEqual(lines[-2:], ["GOTO / -10.0, 0.0, 0.0", "GOTO / 0.0, -10.0, 0.0"])

    def test_cycles_return_to_where_they_began(self):
        holes = "FROM/0,0,50\nSPINDL/1000,CLW\n{}\nGOTO/10,0,0\nGOTO/20,0,5\nCYCLE/OFF\n"
        for cycle in ("CYCLE/DRILL,RAPTO,3.0,FEDTO,-33.0,RTRCTO,AUTO,MMPM,250.", "CYCLE/DRILL,DEPTH,33,MMPM,250,CLEAR,3,RETURN,0"):
            self.write("a.apt", "UNITS/MM\nFEDRAT/100\n" + holes.format(cycle) + "FINI\n")
            self.assertExit(0, "compile", "a.apt", "--dialect", "cl", "--to", "ngc")
            drilled = [x for x in self.out.splitlines() if "G81" in x or x.startswith("G98")]
            self.assertEqual(len([x for x in drilled if "G98" in x]), 2, self.out)
            self.assertNotIn("G99", self.out)
            self.assertIn("Z50.0000", self.out)
        self.write("a.apt", "UNITS/MM\nFEDRAT/100\n" + holes.format("CYCLE/DRILL,RAPTO,3.,FEDTO,-33.,RTRCTO,4.,MANUAL,MMPM,250.") + "FINI\n")
        self.assertExit(0, "compile", "a.apt", "--dialect", "cl", "--to", "ngc")
        self.assertNotIn("Z50.0000\nG98", self.out)

    def test_a_lift_of_a_pattern_takes_up_only_a_cycle_that_was_on(self):
        head = "SPINDL/1000,CLW\nR1=PATERN/LINEAR,(POINT/0,0,0),(POINT/60,0,0),4\nFROM/0,0,50\n"
        lines = self.ngc(head + "GOTO/R1,AVOID,10,2\n")
        self.assertFalse([x for x in lines if "G8" in x or "G9" in x], lines)
        drill = "CYCLE/DRILL,5,MMPM,100,2\nGOTO/-20,0,0\nCYCLE/OFF\n"
        lines = self.ngc(head + drill + "GOTO/R1,AVOID,10,2\n")
        self.assertEqual(len([x for x in lines if "G81" in x]), 1, lines)
        lines = self.ngc(head + drill.replace("CYCLE/OFF\n", "") + "GOTO/R1,AVOID,10,2\n")
        self.assertEqual(len([x for x in lines if "G81" in x or x.startswith("G80")]), 6, lines)

    def test_the_tool_of_the_next_change(self):
        lines = self.ngc("FROM/0,0,0\nTOOLNO/4,MILL,1,0\nLOADTL/4\nSELCTL/7\nGOTO/1,0,0\n")
        self.assertEqual([x for x in lines if x.startswith("T")], ["T4", "T4 M6", "T7"])

    def test_words_of_cycles_that_stand_alone(self):
        for cycle in ("CYCLE/DRILL,THRU,DEPTH,5,MMPM,100,CLEAR,2", "CYCLE/BORE,DRAG,RAPTO,3,FEDTO,-5,MMPM,100"):
            lines = self.ngc(f"FROM/0,0,9\nSPINDL/500,CLW\n{cycle}\nGOTO/1,0,0\nCYCLE/OFF\n")
            self.assertTrue([x for x in lines if "G81" in x or "G85" in x], lines)
        self.compile("UNITS/MM\nFEDRAT/9\nFROM/0,0,9\nCYCLE/BORE,NODRAG,RAPTO,3,FEDTO,-5,MMPM,100\nGOTO/1,0,0\nFINI\n", target="ngc", code=6)
        self.assertIn("NODRAG", self.err)

    def test_codes_of_motion_are_no_prefun(self):
        for code in (0, 1, 2, 3, 38.2, 81):
            self.compile(f"UNITS/MM\nFEDRAT/9\nFROM/0,0,9\nPREFUN/{code}\nGOTO/1,0,0\nFINI\n", target="ngc", code=6)
            self.assertIn("E0670", self.err)
        self.assertIn("G64", self.ngc("FROM/0,0,0\nPREFUN/64\nGOTO/1,0,0\n"))

    def test_parameters_are_checked_by_one_table(self):
        for statement, codes in (("SPINDL/1000,RPM,CLW", ""), ("COOLNT/FLOOD", ""), ("LOADTL/3,ADJUST,3", ""), ("TURRET/1,SETOOL,0,0,0", ""),
                                 ("CYCLE/DRILL,5,MMPM,100,2", ""), ("CUTCOM/LEFT,XYPLAN", ""), ("AUXFUN/8", ""), ("SEQNO/10,INCR,5", ""),
                                 ("CLEARP/XYPLAN,5", ""), ("ROTABL/ATANGL,90", ""), ("REVERS/LEFT,XAXIS", ""), ("OPSKIP/ON", ""),
                                 ("SPINDL/FLOOD", "W0583"), ("LOADTL/ON", "W0584"), ("COOLNT/1,2,3", "W0584"), ("DELAY/ON", "W0584"),
                                 ("OPSKIP/FLOOD", "W0583"), ("PREFUN/ON", "W0584"), ("MAXDPM/1,2", "W0584"), ("SAFETY/CLW", "W0583"),
                                 ("AIR/LEFT", "W0583"), ("COOLNT/-7", "W0583"), ("LOADTL/-7", "W0583"), ("DELAY/-7", "W0583"),
                                 ("CYCLE/FLOOD", "W0583"), ("FEDRAT", "W0584"), ("SPINDL", "W0584"), ("FEDRAT/ON", "W0583 W0584"),
                                 ("SEQNO/FLOOD", "W0583"), ("TOOLNO/CLW", "W0584"), ("HEAD/IPM", "W0583"), ("INDEX/1,2", "E0470")):
            self.write("a.apt", f"FROM/0,0,0\n{statement}\nGOTO/1,2,3\nFINI\n")
            self.run_arelem("compile", "a.apt", "--to", "cl", "--diagnostics", "gnu")
            self.assertEqual([w for w in ("W0583", "W0584", "E0470") if w in self.err], codes.split(), (statement, self.err))
        self.compile("FROM/0,0,0\nRAPID/5\nGOTO/1,2,3\nFINI\n")
        self.assertEqual(self.err.count("warning["), 1, self.err)

    def test_language_tells_of_every_word(self):
        for word, shown in (("LETTER", "LETTER/ x, y, size"), ("rapid", "rapid traverse"), ("SPINDL", "SPINDL/"), ("CLW", "PATERN/ ARC, circle, start, {CLW | CCLW}")):
            self.assertExit(0, "language", word)
            self.assertIn(shown, self.out)
        for word, shown, hidden in (("DO", "ENDDO", "DOTF"), ("then", "ENDIF", "label1"), ("ON", "PRINT/ {ON", "CANON, n")):
            self.assertExit(0, "language", word)
            self.assertIn(shown, self.out)
            self.assertNotIn(hidden, self.out)
        self.assertExit(2, "language", "LETTERR")
        self.assertIn("did you mean `LETTER`", self.err)

    def test_a_macro_refuses_at_its_call(self):
        macro = "M=MACRO/D\nIF (D .LE. 0) THEN\nREFUSE/'D must be above 0',D,(D+1)\nENDIF\nGOTO/D,0,0\nTERMAC\n"
        self.write("a.apt", macro + "FROM/0,0,0\nCALL/M,D=-2\nCALL/M,D=-3\nFINI\n")
        self.assertExit(1, "compile", "a.apt", "--to", "cl", "--diagnostics", "json")
        messages = [json.loads(line) for line in self.err.splitlines()]
        self.assertEqual([(m["code"], m["message"]) for m in messages], [("E0496", "D must be above 0 (-2, -1)")])
        self.assertIn("8:1", self.err_of_text())
        self.assertIn("GOTO / 5.0", "\n".join(self.compile(macro + "FROM/0,0,0\nCALL/M,D=5\nFINI\n")))
        self.compile("REFUSE=3\nFROM/0,0,0\nGOTO/REFUSE,0,0\nFINI\n")

    def err_of_text(self):
        self.run_arelem("compile", "a.apt", "--to", "cl")
        return self.err


if __name__ == "__main__":
    unittest.main()
