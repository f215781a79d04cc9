"""What may be wrong with a motion: each fault has its own diagnostic, with the number of the old system, the measured
values and the statement."""
import json
import math
import re
import unittest

from arelem_run import ArelemCase


class BadMotion(ArelemCase):
    def fault(self, *lines, exit_code=4):
        """The one error of a program, at its last statement."""
        self.write("bad.apt", "\n".join(["PARTNO BAD", *lines, "FINI", ""]))
        self.assertExit(exit_code, "compile", "bad.apt", "--to", "json", "-o", "-", "--diagnostics", "json")
        errors = [json.loads(l) for l in self.err.splitlines() if l.startswith("{") and '"error"' in l]
        self.assertEqual(len(errors), 1, self.err)
        self.assertEqual(errors[0]["range"]["start"]["line"], len(lines) + 1)
        self.assertEqual(self.out, "")
        return errors[0]

    def assertFault(self, fault, code, legacy, *values):
        """Its number, the old one, and the numbers of its message, each expected to 1e-4."""
        self.assertEqual((fault["code"], fault["legacy"]), (code, legacy))
        numbers = [float(x) for x in re.findall(r"(?<![\w`])-?\d+(?:\.\d+)?(?:e-?\d+)?", fault["message"])]
        for value in values:
            self.assertTrue(any(abs(n - value) <= 1e-4 for n in numbers), f"{value} is not in {fault['message']}")

    LINES = ("CUTTER/1", "L1=LINE/0,0,1,0", "L2=LINE/5,0,5,1")

    def test_check_surface_never_met(self):
        # A sphere of radius 2 at y = 4 passed by a cutter whose far side is at y = 0: 2 away, at x = 5.
        start = ("CUTTER/1", "L1=LINE/0,0,1,0", "S1=SPHERE/5,4,0,2", "FROM/0,-3,0", "GO/TO,L1", "TLRGT,GORGT/L1,TO,S1")
        for mode in ((), ("3DCALC",)):
            self.assertFault(self.fault(*mode, *start), "E0508", "724", 2, 5, -0.5)

    def test_check_surface_beside_a_closed_path(self):
        # Once round a circle of radius 3 with a cutter of radius 0.5: the line x = 9 stays 5 away, but for the band.
        fault = self.fault("3DCALC", "CUTTER/1", "C1=CYLNDR/0,0,0,0,0,1,3", "L1=LINE/9,0,9,1", "PS1=PLANE/0,0,1,0",
                           "FROM/0,-9,0", "INDIRV/0,1,0", "GO/TO,C1,TO,PS1", "TLLFT,GORGT/C1,TO,L1")
        self.assertEqual((fault["code"], fault["legacy"]), ("E0508", "724"))
        self.assertAlmostEqual(float(re.search(r"approach ([\d.]+)", fault["message"])[1]), 5, delta=0.0006)

    def test_cut_vectors_run_out(self):
        fault = self.fault("3DCALC", "CUTTER/1", "NUMPTS/20", "C1=CYLNDR/0,0,0,0,0,1,3", "L1=LINE/9,0,9,1",
                           "PS1=PLANE/0,0,1,0", "FROM/0,-9,0", "INDIRV/0,1,0", "GO/TO,C1,TO,PS1", "TLLFT,GORGT/C1,TO,L1",
                           exit_code=7)
        self.assertFault(fault, "E0513", "803", 20)
        self.assertIn("nearest to `L1`", fault["message"])

    def test_cutter_larger_than_a_hollow(self):
        # A hole of radius 0.9, as cylinder and as quadric, and a cutter of radius 1: it would gouge by 0.1.
        for hole in ("CYLNDR/0,0,0,0,0,1,.9", "QADRIC/1,1,0,0,0,0,0,0,0,-.81"):
            fault = self.fault("3DCALC", "CUTTER/2", f"DS1={hole}", "PS1=PLANE/0,0,1,0", "Y0=PLANE/0,1,0,0",
                               "FROM/.01,0,0", "INDIRV/1,0,0", "GO/TO,DS1,TO,PS1,ON,Y0")
            self.assertFault(fault, "E0521", "705", 1, 0.9, 0.1)

    def test_parallel_surfaces(self):
        planes = ("CUTTER/1", "PL1=PLANE/0,0,1,2", "PL2=PLANE/0,0,1,0")
        self.assertFault(self.fault(*planes, "FROM/0,0,9", "GO/TO,PL1,TO,PL2"), "E0544", "902")
        self.assertFault(self.fault(*planes, "X9=PLANE/1,0,0,9", "PSIS/PL2", "FROM/0,0,0", "INDIRV/1,0,0",
                                    "TLON,GOFWD/(PLANE/0,0,1,0),ON,X9"), "E0544", "902")

    def test_contact_lost_beyond_the_edge_of_a_mesh(self):
        # A mesh of one triangle ends at x = 1; the ball runs off it and reaches no check surface.
        self.write("m.stl", "solid m\nfacet normal 0 0 1\nouter loop\nvertex -9 -9 0\nvertex 1 0 0\nvertex -9 9 0\n"
                            "endloop\nendfacet\nendsolid m\n")
        fault = self.fault("CUTTER/1,.5", "OUTTOL/.001", "M1=MESH/STL,'m.stl'", "DS1=PLANE/0,1,0,0",
                           "XM=PLANE/1,0,0,-5", "X9=PLANE/1,0,0,9", "FROM/-5,0,4", "GO/ON,DS1,TO,M1,ON,XM", "INDIRV/1,0,0",
                           "TLON,GOFWD/DS1,ON,X9")
        self.assertIn((fault["code"], fault["legacy"]), (("E0512", "902"), ("E0508", "724")))

    def test_contact_lost_behind_the_end_of_a_tabcyl(self):
        # The curve is the x axis from 0 to 8 and goes on straight for 80 more; the line y = 9 is never met: the tool of
        # radius 0.5 runs below the curve, 9 away from it.
        curve = ("CUTTER/1", "T1=TABCYL/NOZ,SPLINE,(POINT/0,0,0),(POINT/4,0,0),(POINT/8,0,0)", "LN=LINE/0,9,5,9")
        for first, word in (("-2", "GOFWD"), ("9", "GOBACK")):
            fault = self.fault(*curve, f"FROM/{first},-3,0", "GO/TO,T1", "INDIRV/1,0,0", f"TLRGT,{word}/T1,TO,LN")
            self.assertEqual((fault["code"], fault["legacy"]), ("E0545", "902"))
            x = float(re.search(r"near \((-?[\d.]+),", fault["message"])[1])
            self.assertTrue(80 <= abs(x) <= 100, fault["message"])
            self.assertIn("is 80 long", fault["message"])
            self.assertAlmostEqual(float(re.search(r"was ([\d.]+) from `LN`", fault["message"])[1]), 9, delta=0.001)
            # What the straight ends are for.
        self.write("ends.apt", "\n".join(["PARTNO ENDS", *curve, "L9=LINE/50,0,50,5", "FROM/-2,-3,0", "GO/TO,T1", "INDIRV/1,0,0",
                                          "TLRGT,GOFWD/T1,TO,L9", "FINI", ""]))
        self.assertExit(0, "compile", "ends.apt", "--to", "json", "-o", "-")
        last = [json.loads(l) for l in self.out.splitlines() if '"points"' in l][-1]["points"][-1]
        self.assertAlmostEqual(last[0], 49.5, delta=1e-9)

    def test_direction_word_square_to_the_path(self):
        fault = self.fault(*self.LINES, "FROM/0,-3,0", "INDIRV/0,1,0", "GO/TO,L1", "TLRGT,GOFWD/L1,TO,L2")
        self.assertFault(fault, "E0507", "505", 90)

    def test_no_direction_known(self):
        fault = self.fault(*self.LINES, "FROM/0,-.5,0", "TLRGT,GOFWD/L1,TO,L2")
        self.assertFault(fault, "E0506", "504")

    def test_tool_on_the_other_side_is_a_warning(self):
        self.write("side.apt", "\n".join(["PARTNO SIDE", *self.LINES, "FROM/0,-3,0", "GO/TO,L1", "TLLFT,GORGT/L1,TO,L2",
                                          "FINI", ""]))
        self.assertExit(0, "compile", "side.apt", "--to", "json", "-o", "-", "--diagnostics", "json")
        warning = json.loads(next(l for l in self.err.splitlines() if "W0501" in l))
        self.assertEqual(warning["legacy"], "-1601")

    def test_start_outside_of_the_tolerance(self):
        off = self.fault(*self.LINES, "FROM/0,-3,0", "INDIRV/1,0,0", "TLRGT,GOFWD/L1,TO,L2")
        self.assertFault(off, "E0505", "503", 2.5, 0.0005)
        low = self.fault(*self.LINES, "PS1=PLANE/0,0,1,-3", "FROM/0,-.5,0", "PSIS/PS1", "INDIRV/1,0,0",
                         "TLRGT,GOFWD/L1,TO,L2")
        self.assertFault(low, "E0504", "502", 3, 0.0005)

    def test_check_surface_behind_the_start(self):
        fault = self.fault(*self.LINES, "FROM/9,-.5,0", "INDIRV/1,0,0", "TLRGT,GOFWD/L1,TO,L2")
        self.assertFault(fault, "E0508", "724", 3.5, 9, -0.5)
        self.assertEqual(fault["help"], "the tool moves away from it from the start on")

    def test_cutter_higher_than_the_hollow_that_only_its_end_lies_in(self):
        # A fillet of radius 1.5 beside a floor: the ball lies in it, the shank, 5 high as no height is given, in its other side.
        scene = ["PS1=PLANE/0,0,1,0", "CY1=CYLNDR/5,0,1.5,0,1,0,1.5", "DS1=PLANE/0,1,0,0", "FROM/0,0,4",
                 "GO/ON,DS1,TO,PS1", "INDIRV/1,0,0", "TLON,GOFWD/DS1,PSTAN,CY1"]
        fault = self.fault("CUTTER/.5,.25", *scene)
        self.assertEqual((fault["code"], fault["legacy"]), ("E0509", "721"))
        self.assertEqual(fault["help"], "the cutter is 5 high, the hollow `CY1` 3: if only its lower end lies in it, give "
                         "the height that cuts, the seventh number of CUTTER")
        self.write("low.apt", "\n".join(["PARTNO LOW", "CUTTER/.5,.25,0,.25,0,0,1", *scene, "PSIS/CY1", "GOFWD/DS1,ON,(PLANE/1,0,0,6)",
                                         "FINI", ""]))
        self.assertExit(0, "verify", "low.apt")

    def test_check_surface_beside_the_way(self):
        # The tool end runs along y = -.5, its far side along y = 0: the line y = 3 is 3 away from the start to no end.
        fault = self.fault("CUTTER/1", "L1=LINE/0,0,1,0", "L2=LINE/0,3,1,3", "FROM/0,-.5,0", "INDIRV/1,0,0",
                           "TLRGT,GOFWD/L1,TO,L2")
        self.assertFault(fault, "E0508", "724", 3, 0, -0.5)
        self.assertEqual(fault["help"], "it is parallel to the way: the tool stays as far from it as it is")

    def test_start_in_the_tolerance_of_the_other_word(self):
        for at, word, help in (("FROM/0,0,0", "TLRGT", "the tool end is on it: TLON keeps it so"),
                               ("FROM/0,-.5,0", "TLON", "the cutter touches it: TLLFT and TLRGT keep it so")):
            fault = self.fault(*self.LINES, at, "INDIRV/1,0,0", f"{word},GOFWD/L1,TO,L2")
            self.assertFault(fault, "E0505", "503")
            self.assertIn(help, fault["help"])
        # A ball that stands with its end on a plane leaning by 1 in 1, in which it is sunk, and one that touches it.
        ball = ("CUTTER/2,1", "P=PLANE/1,0,1,0", "PSIS/P", "L2=LINE/0,5,1,5", "D=LINE/0,0,0,1")
        for at, word, help in (("FROM/0,0,0", "TLOFPS", "the tool end is on it: TLONPS keeps it so"),
                               (f"FROM/0,0,{math.sqrt(2) - 1}", "TLONPS", "the cutter touches it: TLOFPS keeps it so")):
            fault = self.fault(*ball, at, "INDIRV/0,1,0", f"TLON,{word},GOFWD/D,ON,L2")
            self.assertFault(fault, "E0504", "502")
            self.assertIn(help, fault["help"])
            self.assertIn("`P` defined here", [r["message"] for r in fault["related"]])
        fault = self.fault(*self.LINES, "FROM/0,-3,0", "INDIRV/1,0,0", "TLRGT,GOFWD/L1,TO,L2")
        self.assertNotIn("help", {k for k, v in fault.items() if v})

    def test_negative_thick_deeper_than_the_tool(self):
        # With a radius of .5 and THICK -.6 the tool overlaps one side or the other wherever it is.
        fault = self.fault(*self.LINES, "THICK/0,0,-.6", "FROM/0,-.5,0", "INDIRV/1,0,0", "TLRGT,GOFWD/L1,TO,L2")
        self.assertFault(fault, "E0508", "724", 0.1, 5)
        self.assertIn("deeper than the radius of the tool", fault["help"])

    def test_fewer_positions_than_counted(self):
        # The line through the center crosses the circle ON at 17 and 23.
        circle = ("CUTTER/2", "L1=LINE/0,0,1,0", "C1=CIRCLE/20,0,3", "FROM/0,0,0", "INDIRV/1,0,0")
        for mode in ((), ("3DCALC",)):
            fault = self.fault(*mode, *circle, "TLON,GOFWD/L1,ON,3,INTOF,C1")
            self.assertEqual((fault["code"], fault["legacy"]), ("E0546", "724"))
            self.assertTrue(fault["message"].startswith("only 2 of 3 positions ON check surface `C1`"), fault["message"])
            self.assertAlmostEqual(float(re.search(r"at \(([\d.]+),", fault["message"])[1]), 23, delta=0.001)

    def test_a_tool_that_stands_there_already(self):
        # TO x = 5 twice: from x = 4.5 on the only position is PAST, at 5.5, and the message says why.
        fault = self.fault(*self.LINES, "FROM/0,-3,0", "GO/TO,L1", "TLRGT,GORGT/L1,TO,L2", "GOFWD/L1,TO,L2")
        self.assertFault(fault, "E0508", "724", 0, 5.5, -0.5, 0)
        self.assertIn("stands at it at the start", json.dumps(fault))

    def test_words_that_go_along_a_path_square_to_the_one_given(self):
        fault = self.fault(*self.LINES, "FROM/3,-3,0", "INDIRV/0,1,0", "GO/TO,L1", "TLRGT,GOFWD/L1,TO,L2")
        self.assertFault(fault, "E0507", "505", 3, -0.5, 0, 90)
        self.assertIn("GOLFT and GORGT go along the path", json.dumps(fault))

    def test_check_surface_along_the_path(self):
        fault = self.fault(*self.LINES, "FROM/0,-.5,0", "INDIRV/1,0,0", "TLRGT,GOFWD/L1,TO,L1")
        self.assertFault(fault, "E0547", "724", 0.0005)

    def test_start_in_a_hole_narrower_than_the_cutter(self):
        # A motion that begins there, not a startup.
        fault = self.fault("CUTTER/2", "OUTTOL/.001", "C1=CIRCLE/0,0,.9", "FROM/0,.1,0", "INDIRV/1,0,0",
                           "TLLFT,GOFWD/C1,ON,(LINE/0,0,0,1)")
        self.assertFault(fault, "E0521", "705", 1, 0.9, 0.1)

    def test_faults_of_offset(self):
        # A circle of radius 2 passed along y = 9: 7 away at x = 5. A plane that leans by 45 degrees left by 4 sin 45.
        misses = self.fault("CUTTER/1", "C1=CIRCLE/5,0,2", "FROM/0,9,0", "INDIRV/1,0,0", "OFFSET/TO,C1")
        self.assertFault(misses, "E0548", "34", 7, 5, 9)
        away = self.fault("CUTTER/1", "C1=CIRCLE/5,0,2", "FROM/0,1,0", "INDIRV/-1,0,0", "OFFSET/TO,C1")
        self.assertFault(away, "E0548", "34", math.hypot(5, 1) - 2, 0, 1)
        leaves = self.fault("CUTTER/0", "DS=PLANE/1,0,1,8", "FROM/0,0,4", "INDIRV/1,0,0",
                            "OFFSET/TO,DS,TO,(PLANE/0,0,1,0)")
        self.assertEqual((leaves["code"], leaves["legacy"]), ("E0549", "37"))

    def test_startup_tells_where_it_comes_nearest(self):
        # TO the line y = 4 from above the tool is at y = 5, TO the circle of radius 3 it is 4 from the center: halfway
        # between, at y = 4.5, both are missed by 0.5.
        fault = self.fault("CUTTER/2", "C1=CIRCLE/10,0,3", "PS=PLANE/0,0,1,0", "L1=LINE/0,4,1,4", "FROM/11,9,5",
                           "GO/TO,C1,TO,PS,TO,L1")
        self.assertFault(fault, "E0510", "602", 10, 4.5, 0, 0.5)

    def test_one_failed_startup_is_one_error(self):
        lines = ["PARTNO BAD", "CUTTER/1", "C1=CIRCLE/5,0,2", "FROM/0,9,0", "INDIRV/1,0,0", "GO/TO,C1",
                 "TLLFT,GOLFT/C1,ON,(LINE/5,0,5,1)", "FINI", ""]
        self.write("bad.apt", "\n".join(lines))
        for command in (("compile", "bad.apt", "--to", "json", "-o", "-"), ("verify", "bad.apt")):
            self.assertExit(4, *command, "--diagnostics", "json")
            found = [(d["code"], d["range"]["start"]["line"]) for d in map(json.loads, self.err.splitlines()) if "code" in d]
            self.assertEqual(found, [("E0510", 6), ("W0506", 7)])

    AXIS = ("MULTAX", "CUTTER/1,.5", "PS=CYLNDR/0,0,-10,0,1,0,10", "DS=PLANE/0,1,0,0", "X0=PLANE/1,0,0,-4", "FROM/-4,0,5")

    def test_axes_that_there_are_not(self):
        # At x = -4 under a ball of radius 0.5 on a cylinder of radius 10 the normal leans asin(4 / 10.5) towards -x.
        for rule, reason, value in (("1,2,CUTANG,3", "the lead of", 3), ("1,2,CUTANG,-3", "the lag of", 3),
                                    ("1,10,(VECTOR/1,0,0)", "out of the plane", math.degrees(math.asin(4 / 10.5)))):
            fault = self.fault(*self.AXIS, f"TLAXIS/ATANGL,{rule}", "GO/ON,DS,TO,PS,ON,X0")
            self.assertEqual((fault["code"], fault["legacy"]), ("E0540", "904"))
            self.assertIn(reason, fault["message"])
            self.assertAlmostEqual(float(re.search(r"([\d.]+) degrees (?:is more|out)", fault["message"])[1]), value,
                                   delta=0.01)

    def test_lines_are_never_tangent(self):
        fault = self.fault(*self.LINES, "FROM/0,-3,0", "GO/TO,L1", "TLRGT,GORGT/L1,TANTO,L2")
        self.assertFault(fault, "E0522", "720")

    def test_surfaces_that_do_not_touch(self):
        # The tool of radius 0.5 at y = -0.5 passes the circle, which begins at y = 1.
        fault = self.fault("CUTTER/1", "L1=LINE/0,0,1,0", "C1=CIRCLE/9,4,3", "FROM/0,-3,0", "GO/TO,L1",
                           "TLRGT,GORGT/L1,TANTO,C1")
        self.assertFault(fault, "E0509", "721", 1, 0.0005)

    def test_tool_on_the_surface_to_which_it_goes(self):
        fault = self.fault("CUTTER/1", "L1=LINE/0,0,1,0", "FROM/0,0,0", "GO/TO,L1")
        self.assertFault(fault, "E0511", "40", 0)

    def test_directed_startup_beside_its_surface(self):
        # Along +x from (0, 9): the circle of radius 2 is passed at a distance of 9 - 2 - 0.5 and never met.
        fault = self.fault("CUTTER/1", "C1=CIRCLE/5,0,2", "FROM/0,9,0", "NOPS", "INDIRV/1,0,0", "GO/TO,C1")
        self.assertEqual((fault["code"], fault["legacy"]), ("E0510", "602"))

    def test_statements_without_what_they_need(self):
        self.assertFault(self.fault("L1=LINE/0,0,1,0", "FROM/0,-3,0", "GO/TO,L1"), "E0502", "312")
        self.assertFault(self.fault("CUTTER/1", "L1=LINE/0,0,1,0", "FROM/0,-3,0", "OFFSET/TO,L1"), "E0519", "33")
        self.assertFault(self.fault(*self.LINES, "FROM/0,-3,0", "NOPS", "GO/TO,L1,TO,L2"), "E0518", "601", 2)
        none = self.fault(*self.LINES, "OUTTOL/0", "FROM/0,-3,0", "GO/TO,L1", "TLRGT,GORGT/L1,TO,L2")
        self.assertFault(none, "E0516", None, 0)


if __name__ == "__main__":
    unittest.main()
