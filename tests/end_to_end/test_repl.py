"""`arelem repl` without a terminal."""
import re
import subprocess
import unittest

from arelem_run import ARELEM, ArelemCase

SCENE = "UNITS/MM\nP1=POINT/0,0\nL1=LINE/P1,(POINT/100,0)\nL2=LINE/(POINT/0,50),(POINT/100,50)\n"


class Piped(ArelemCase):
    def session(self, text, *words, code=0):
        self.assertExit(code, "repl", *words, stdin=text.encode())
        return self.out

    def test_canonical_forms(self):
        out = self.session("C1=CIRCLE/1,2,3\nA=1/3\n")
        self.assertIn("C1 = CIRCLE  center (1, 2)  radius 3\n   exactly 1 2 0 0 0 1 3\n", out)
        self.assertIn("A = 0.333333   exactly 0.3333333333333333\n", out)
        self.assertNotIn(">", out)  # no prompt

    def test_unnamed_results(self):
        out = self.session("3*SINF(90)\nCIRCLE/0,0,ANS\nANS\nP1=POINT/CENTER,ANS\n7*7\n:save -\n")
        self.assertIn("ANS1 = 3\n", out)
        self.assertIn("ANS2 = CIRCLE  center (0, 0)  radius 3\n", out)
        # P1 uses the second, which uses the first; nothing uses the third.
        self.assertTrue(out.endswith("\nANS1=3*SINF(90)\nANS2=CIRCLE/0,0,ANS1\nP1=POINT/CENTER,ANS2\nFINI\n"), out)

    def test_errors_end_nothing(self):
        out = self.session("P1=POINT/Q,1\nP1=POINT/1,1\nP1=POINT/2,2\nP2=POINT/3,3\n:nonsense\nP3=POINT/4,4\n", code=1)
        self.assertIn("E0201", self.err)
        self.assertIn("no command `:nonsense`", self.err)
        self.assertIn("P3 = POINT  (4, 4, 0)", out)
        self.assertIn("P1 = POINT  (1, 1, 0)", out)
        self.assertNotIn("P1 = POINT  (2, 2, 0)", out)

    def test_exit_code_tells_the_worst(self):
        self.session(":nonsense\n", code=2)
        self.session("X=NOPE\n:nonsense\n", code=1)        # a wrong command is the least of all
        self.session(":nonsense\nX=NOPE\n", code=1)
        self.session("X=1\n:save no/such/folder/a\n", code=6)
        self.assertIn("arelem: error[E0610]: cannot write", self.err)
        self.session(":load nothere\n", code=3)
        self.assertIn("arelem: error[E0701]: cannot read", self.err)
        self.session("X=1\n", "nothere", code=3)
        self.session("X=NOPE\n:load nothere\n:nonsense\n", code=3)

    def test_statements_are_shown_whole(self):
        out = self.session("L1=LINE/0,0,$\n1,1\n:show L1\n:why L1\n")
        self.assertIn("   line 1: L1=LINE/0,0,$\n           1,1\n", out)
        self.assertIn("   session:1  L1=LINE/0,0,$\n              1,1\n", out)

    def test_all_statements_that_assign_a_scalar_are_shown(self):
        out = self.session("X=0\nLOOPST\nA) X=X+1\nIF (X-5) A,B,B\nB) Y=1\nLOOPND\n:show X\n")
        self.assertTrue(out.endswith("X = 5\n   line 1: X=0\n   line 3: A) X=X+1\n"), out)

    def test_open_statements(self):
        out = self.session("C1=CIRCLE/1,$\n2,$ more\n3\nLOOPST\nI=0\nA) I=I+1\nIF(I-3)A,B,B\nB) Z=I\nLOOPND\n"
                           "M=MACRO/Q\nP1=POINT/Q,Q\nTERMAC\nCALL/M,Q=7\nIF (Z .EQ. 3) THEN\nW=8\nENDIF\n")
        self.assertIn("C1 = CIRCLE  center (1, 2)  radius 3", out)
        self.assertIn("Z = 3\n", out)
        self.assertIn("P1 = POINT  (7, 7, 0)", out)
        self.assertIn("W = 8\n", out)

    def test_a_wrong_line_in_an_open_macro(self):
        out = self.session("M=MACRO/Q\nP1=POINT/1.2.3,Q\nP1=POINT/1,Q\nTERMAC\nCALL/M,Q=7\n", code=1)
        self.assertIn("this line is not taken", out)
        self.assertIn("P1 = POINT  (1, 7, 0)", out)

        # Brackets that do not match are wrong whatever stands around them; that the macro is not yet ended is no error.
        out = self.session("M=MACRO/Q\n)) ((\nP1=POINT/2,Q\nTERMAC\nCALL/M,Q=7\n", code=1)
        self.assertIn("this line is not taken: `)) ((`", out)
        self.assertIn("P1 = POINT  (2, 7, 0)", out)
        self.assertNotIn("E0230", self.err)

    def test_blocks_that_are_wrong_as_a_whole(self):
        out = self.session("M=MACRO/Q\nP1=POINT/QQ,Q\nTERMAC\nCALL/M,Q=7\n", code=1)
        self.assertNotIn("history", out)  # there is none without a terminal

    def test_answers_before_any_result(self):
        self.session("ANS\n3+ANS\nC1=CIRCLE/0,0,ANS\n", code=1)
        self.assertEqual(self.err.count("ANS is the last unnamed result, and there is none yet"), 3)
        self.assertNotIn("E0", self.err)
        out = self.session("PARTNO ANS\n3+4\nPARTNO ANS\nX=2*ANS\n:save -\nANS=5\nANS\n")
        self.assertEqual(out.count("PARTNO ANS\n"), 2)  # a text is a text
        self.assertIn("X = 14\n", out)
        self.assertIn("ANS = 5\n", out)

    def test_a_motion_that_waits_is_not_saved(self):
        out = self.session("CUTTER/2\nL1=LINE/0,0,1,0\nFROM/0,9\nGO/TO,L1\nGORGT/L1\nP1=POINT/1,2\n:save s.apt\n:save -\n")
        self.assertIn("`GORGT/L1` is left out: it waits for the next motion", out)
        self.assertEqual((self.folder / "s.apt").read_text(), "CUTTER/2\nL1=LINE/0,0,1,0\nFROM/0,9\nGO/TO,L1\nP1=POINT/1,2\nFINI\n")
        self.assertExit(0, "check", "s.apt")
        self.session("CUTTER/2\nL1=LINE/0,0,1,0\nL2=LINE/5,0,5,1\nFROM/0,9\nGO/TO,L1\nGOLFT/L1\nGOLFT/L2,PAST,(LINE/0,7,1,7)\n:save t.apt\n")
        self.assertIn("GOLFT/L1\nGOLFT/L2", (self.folder / "t.apt").read_text())

    def test_why_of_a_place_on_a_spline(self):
        out = self.session("B=BSPLIN/(-4,9),(-4,6),(-4,3),(-4,0),(-4,-3),(4,-3),(4,0),(4,3),(4,6),(4,9)\nQ=POINT/B,(POINT/1,4)\n:why Q\n")
        self.assertIn("candidates: 2, the places where the distance is least", out)
        self.assertIn("- (-4, 4, 0)  lost: it is the one next to (-4, 4, 0); 5 from the near point, the chosen one 3", out)

    def test_topics(self):
        out = self.session(":help topics\n:help roadway_alphabet\n")
        self.assertNotIn("<!--", out)
        self.assertRegex(out, r"roadway_alphabet +The roadway alphabet\n")

    def test_input_that_ends_too_early(self):
        self.session("M=MACRO/Q\n", code=1)
        self.assertIn("the input ended within", self.err)

    def test_why_shows_the_losers(self):
        out = self.session("L1=LINE/(POINT/0,0),(POINT/1,0)\nC1=CIRCLE/0,0,5\nP1=POINT/XLARGE,INTOF,L1,C1\n:why P1\n")
        # The line through the center meets the circle at x = 5 and x = -5.
        self.assertIn("+ (5, 0, 0)  chosen", out)
        self.assertIn("- (-5, 0, 0)  lost: it is the one with XSMALL for XLARGE in place 1; "
                      "x is -5 there and 5 here; XLARGE takes the larger", out)
        self.assertIn("form PT_04", out)

    def test_distance(self):
        out = self.session(SCENE + "C1=CIRCLE/0,80,10\nS1=SPHERE/0,0,30,10\nPL=PLANE/0,0,1,0\nT1=TORUS/0,0,0,0,0,1,50,5\n"
                           "V1=VECTOR/1,0,0\n:distance L1,L2\n:distance P1,C1\n:distance C1,L2\n:distance S1,PL\n"
                           ":distance T1,P1\n:distance V1,P1\n", code=4)
        # 50 between the lines; 80 - 10; 80 - 50 - 10; 30 - 10; the tube is 45 from its center.
        found = re.findall(r"^(\d[\d.]*)(?:  \(.*\))?$", out, re.M)
        self.assertEqual([float(x) for x in found], [50, 70, 20, 20, 45])
        self.assertIn("E0341", self.err)

    def test_curve(self):
        # Bezier points (0,0) (10,0) (10,10) (0,10): at t = 1/2 the place is (7.5, 5), the first derivative 3/4 (P3 + P2 - P1
        # - P0) = (0, 15), the second 3 (P0 - P1 - P2 + P3) = (-60, 0), the curvature 60/15^2 = 4/15, the circle's center 3.75
        # to the left.
        out = self.session("B1=BSPLIN/0,0,0, 10,0,0, 10,10,0, 0,10,0\nP1=POINT/10,5,0\n:curve B1\n:curve B1,.5\n"
                           ":curve B1,P1\n:distance P1,B1\n:curve B1,2\n:curve P1\n", code=2)
        self.assertIn("open, 4 control points, t from 0 to 1", out)
        self.assertIn("piece 1  t from 0 to 1  Bezier points (0, 0, 0) (10, 0, 0) (10, 10, 0) (0, 10, 0)", out)
        at = "t 0.5  point (7.5, 5, 0)\n   derivatives (0, 15, 0), (-60, 0, 0), (0, -120, 0)\n" \
             "   direction (0, 1, 0)  curvature 0.266667  radius 3.75  center (3.75, 5, 0)"
        self.assertEqual(out.count(at), 2)
        self.assertIn("next to P1, 2.5 away", out)
        self.assertRegex(out, r"(?m)^2\.5$")
        self.assertIn("the parameter 2 is outside of 0 to 1", self.err)
        self.assertIn("`P1` is no BSPLIN", self.err)

    def test_undo_redo_save_load(self):
        out = self.session("P1=POINT/1,1\nP2=POINT/2,2\n:undo\n:list\n:redo\n:save s.apt\nP1=POINT/Q,1\n:undo 5\n:load s.apt\n"
                           ":show P2\n:redo 3\n", code=1)
        self.assertEqual((self.folder / "s.apt").read_text(), "P1=POINT/1,1\nP2=POINT/2,2\nFINI\n")
        self.assertIn("2 entries taken back", out)
        self.assertIn("there is nothing to bring again", out)
        self.assertEqual(out.count("P2 = POINT  (2, 2, 0)"), 2)

    def test_motion(self):
        out = self.session("UNITS/MM\nCUTTER/10\nINTOL/0\nOUTTOL/.01\nFEDRAT/6000\nL1=LINE/(POINT/0,0),(POINT/100,0)\n"
                           "L2=LINE/(POINT/100,0),(POINT/100,50)\nFROM/0,-50,0\nGO/TO,L1\nTLRGT,GORGT/L1\nGOLFT/L2,PAST,(LINE/0,40,1,40)\n"
                           ":step 2\n:step\n:time\n:set velocity 50\n:time\n:step reset\n:step\n", code=0)
        self.assertIn("waits for the next motion", out)
        self.assertIn("GO  1 cut vector, 45 mm", out)
        self.assertRegex(out, r"session:10  TLRGT,GORGT/L1\n   GORGT  1 cut vector, 105 mm.*\n   to \(105, -5, 0\)")
        times = [float(t) for t in re.findall(r"([\d.]+) s  in all", out)]
        self.assertEqual(len(times), 2)
        self.assertGreater(times[1], times[0])  # 50 mm/s instead of 100

    def test_files_and_pictures(self):
        self.write("p.apt", SCENE + "C1=CIRCLE/QQ,1,1\nP9=POINT/9,9\nFROM/0,0,0\nGOTO/10,0,0\nFINI\n")
        out = self.session(":show P9\n:plot p.svg\n:view p.html\n:plot no/such/folder.svg\n", "p.apt", code=1)
        self.assertIn("E0201", self.err)
        self.assertIn("without the statements that have errors", out)
        self.assertIn("P9 = POINT  (9, 9, 0)", out)
        self.assertIn("<svg", (self.folder / "p.svg").read_text())
        self.assertIn("<html", (self.folder / "p.html").read_text())
        self.assertIn("no/such", self.err)

    def test_help(self):
        out = self.session(":help\n:help CIRCLE\n:help gofwd\n:help E0201\n:help :why\n:help CIRCEL\n", code=2)
        for text in (":distance A,B", "CI-03", "CENTER, point, RADIUS, r", "follows the drive surface", "# E0201"):
            self.assertIn(text, out)
        self.assertIn("did you mean `CIRCLE`?", self.err)
        # A modifier, a word of machines, pages of the manual, a command.
        out = self.session(":help THETAR\n:help ZERO\n:help topics\n:help smoothing\n:help cli.md\n:help targets\n:help language\n"
                           ":help spray\n")
        for text in ("POINT/ {RTHETA, {XYPLAN", "post-processor word 13", "smoothing     ", "# The command line|# ", "METHOD, n",
                     "output formats", "definition forms and statements", ":help spray.md"):
            self.assertRegex(out, text if "|" in text else re.escape(text))

    def test_why_at_a_curve(self):
        # v = t - t*t/2 is .375 at .5 and 1.5; behind the curve it goes on with slope 1: 4.375.
        out = self.session("T1=TABCYL/NOZ,PTSLOP,0,0,1,2,0,-1,4,0,1\nL1=LINE/0,.375,1,.375\nP1=POINT/INTOF,L1,T1,(POINT/0,0)\n:why P1\n")
        self.assertIn("T1 = TABCYL  curve of 2 cubic pieces from (0, 0, 0) to (4, 0, 0), swept along (0, 0, 1)", out)
        self.assertIn("+ (0.5, 0.375, 0)  chosen", out)
        self.assertRegex(out, r"- \(1\.5, 0\.375, 0\)  lost: it is the one next to .*from the near point, the chosen one 0\.625")
        self.assertIn("- (4.375, 0.375, 0)  lost", out)

    def test_names_and_texts_are_safe_to_print(self):
        self.session("P1=POINT/1,\x1b[2J2\nPARTNO <b>\x07bell</b>\n:show \x1b[31m\n:\x1b[2J\n", code=3)
        self.assertNotIn("\x1b", self.out + self.err)
        self.assertNotIn("\x07", self.out + self.err)

    def test_a_full_disk_behind_standard_output(self):
        for words in (["repl"], ["explain", "E0310"]):
            with open("/dev/full", "wb") as full:
                done = subprocess.run([ARELEM, *words], input=b"A=1\n", stdout=full, stderr=subprocess.PIPE, cwd=self.folder)
            self.assertEqual(done.returncode, 6)
            self.assertIn(b"standard output cannot be written", done.stderr)
        # A reader that has seen enough is no fault.
        reader = subprocess.Popen(["head", "-1"], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL)
        done = subprocess.run([ARELEM, "repl"], input=b":help CIRCLE\n" * 3000, stdout=reader.stdin, stderr=subprocess.PIPE)
        reader.communicate()
        self.assertEqual((done.returncode, done.stderr), (0, b""))

    def test_nothing_at_all(self):
        self.assertEqual(self.session(""), "")
        self.assertEqual(self.session("\n\n   \n$$ only a comment\n"), "")
        self.session(":step\n:time\n:undo\n:distance A\n:why\n:show\n:plot e.svg\n", code=2)


if __name__ == "__main__":
    unittest.main()
