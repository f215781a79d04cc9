"""STENCL and V+ through the whole command: the letters of 1996 byte for byte, read back, limits, nothing written on errors."""
import json
import math
import pathlib
import re
import shutil
import unittest

from arelem_run import ArelemCase

PROJECT = pathlib.Path(__file__).resolve().parents[2]
DATA = PROJECT / "tests" / "data" / "stencil"
S = ("P=POINT/400,-900,0\nSTENCL/'S',HEIGHT,1800,FAN,63.5,509.3,0.878715,SPEED,600,ORIGIN,P,COMPAT\nFINI\n")
# Half of one over the tangent of 31.75 degrees: the height of B by the angle of the fan, moved up.
B = ("P=POINT/400,-950,0\nC=0.5/TANF(31.75)\n"
     "STENCL/'B',HEIGHT,1900,FAN,63.5,507.317,C,SPEED,(43200/76),ORIGIN,P,COMPAT\nFINI\n")
STOP = "PARTNO STOP\nUNITS/MM\nSTENCL/'STOP',HEIGHT,500,FAN,63.5,SPEED,600,TILT,QUADR\nFINI\n"


class Robots(ArelemCase):
    def test_letters_of_1996(self):
        for letter, program in (("S", S), ("B", B)):
            self.write("l.apt", program)
            self.assertExit(0, "l.apt", "-o", "l.v2", "--machine", f"path_{letter.lower()}.machine.toml")
            made = (self.folder / "l.v2").read_bytes()
            self.assertEqual(made, (DATA / f"letter{letter}_vplus.txt").read_bytes(), letter)
            cases = {case["id"]: case for case in json.loads((DATA / "cases_blank.json").read_text())}
            self.assertEqual(made.decode().splitlines(), cases[f"BLANK-{letter}-vplus"]["expected"]["lines"])
            self.assertEqual(self.err.count("W0620"), 2)  # these lines have nothing for RAPID and SPRAY

    def test_program_is_read_back(self):
        self.write("stop.apt", STOP)
        self.assertExit(0, "stop.apt", "-o", "stop.v2")
        self.assertExit(0, "verify", "stop.v2", "--with", "stop.apt")
        text = (self.folder / "stop.v2").read_text()
        line = [one for one in text.splitlines() if "MOVES" in one][5]
        first = line.split("(")[1].split(",")[0]
        self.write("stop.v2", text.replace(line, line.replace(first, str(float(first) + 0.5), 1)))
        self.assertExit(5, "verify", "stop.v2", "--with", "stop.apt")
        self.assertIn("E0901", self.err)

    def test_files_in_wrong_places(self):
        self.write("stop.apt", STOP)
        self.assertExit(0, "stop.apt", "-o", "stop.v2")
        for words in (("stop.apt", "--with", "stop.v2"), ("stop.apt", "stop.v2")):
            self.assertExit(2, "verify", *words)
            self.assertIn("`arelem verify stop.v2 --with stop.apt`", self.err)

    def test_inches_are_read_back(self):
        self.write("i.apt", STOP.replace("MM", "INCHES").replace("500", "20"))
        self.assertExit(0, "i.apt", "-o", "i.v2")
        self.assertExit(0, "verify", "i.v2", "--with", "i.apt")

    def test_milling_goes_the_same_way(self):
        self.write("m.apt", "PARTNO M\nUNITS/MM\nFROM/0,0,50\nRAPID\nGOTO/10,0,5\nFEDRAT/600\nGOTO/10,20,5\nFINI\n")
        self.assertExit(0, "m.apt", "-o", "m.v2")
        text = (self.folder / "m.v2").read_text()
        self.assertIn("MOVES f:TRANS(10.000, 20.000, 5.000, 0.000, 180.000, 0.000)", text)
        self.assertExit(0, "verify", "m.v2", "--with", "m.apt")

    def test_another_frame_and_stray_moves_are_seen(self):
        self.write("m.apt", "UNITS/MM\nFROM/0,0,50\nFEDRAT/600\nGOTO/10,20,5\nFINI\n")
        self.assertExit(0, "m.apt", "-o", "m.v2")
        text = (self.folder / "m.v2").read_text()
        for old, new, code in (("f = TRANS(0.000", "f = TRANS(900.000", "E0635"),
                               ("  RETURN", "  MOVES HERE\n  RETURN", "E0634"),
                               ("  RETURN", "  APPROS f:TRANS(900, 900), 5\n  RETURN", "E0634")):
            self.assertIn(old, text)
            self.write("m.v2", text.replace(old, new, 1))
            self.assertExit(6, "verify", "m.v2", "--with", "m.apt")
            self.assertIn(code, self.err)

    DRILLS = ("UNITS/MM\nSPINDL/1000,CLW\nFROM/0,0,50\nRAPID\nGOTO/0,0,20\nCYCLE/DRILL,8,MMPM,90,2\nGOTO/10,0,0\nGOTO/20,5,-3\n"
              "CYCLE/OFF\nCYCLE/DRILL,4,MMPM,80,2,DWELL,.5\nGOTO/30,0,0\nCYCLE/OFF\nCYCLE/DEEP,9,MMPR,.1,2,STEP,4\nGOTO/40,0,0\n"
              "DELAY/1\nCYCLE/OFF\nCYCLE/BRKCHP,9,MMPM,60,2,STEP,4\nGOTO/50,0,0\nCYCLE/OFF\nCYCLE/BORE,6,MMPM,50,2\nGOTO/60,0,0\n"
              "CYCLE/OFF\nCYCLE/DRILL,6,MMPM,50,2,RTRCTO,12\nGOTO/70,0,0\nGOTO/80,0,0\nCYCLE/OFF\nRAPID\nGOTO/0,0,50\nFINI\n")

    def test_holes_are_drilled_and_compared(self):
        self.write("d.apt", self.DRILLS)
        self.assertExit(0, "d.apt", "-o", "d.v2")
        self.assertNotIn("nothing for CYCLE", self.err)
        self.assertExit(0, "verify", "d.v2", "--with", "d.apt")
        self.assertIn("the 11 locations", self.err)
        text = (self.folder / "d.v2").read_bytes().decode()
        bottom = "  MOVES f:TRANS(10.000, 0.000, -8.000, 0.000, 180.000, 0.000)\r\n"
        for old, new in ((bottom, ""),  # not drilled at all
                         (bottom, bottom.replace("-8", "-7")), (bottom, bottom.replace("-8", "-9")), (bottom, bottom.replace("10", "11")),
                         ("SPEED 1.500, 100 MMPS ALWAYS\r\n" + bottom, "SPEED 15, 100 MMPS ALWAYS\r\n" + bottom),
                         ("DELAY 0.500", "DELAY 0.100"),
                         ("MOVES f:TRANS(40.000, 0.000, -4.000,", "MOVES f:TRANS(40.000, 0.000, -5.000,"),  # a peck of 5
                         ("f:TRANS(30.000, 0.000, 2.000,", "f:TRANS(30.000, 0.000, 1.000,")):  # below the clearance
            with self.subTest(new=new):
                self.assertIn(old, text)
                self.write("d.v2", text.replace(old, new))
                self.assertExit(5, "verify", "d.v2", "--with", "d.apt")
                self.assertIn("E0923", self.err)

    def test_arcs_and_a_hole_behind_rapid(self):
        # Half a circle of radius 20 within 0.001 of its chords, then a hole that RAPID goes to.
        self.write("a.cls", "UNITS/MM\nOUTTOL/.001\nFEDRAT/MMPM,600\nGOTO/20,0,0\nCIRCLE/0,0,0,0,0,1,20\nGOTO/-20,0,0\nRAPID\nGOTO/-20,0,9\n"
                   "RAPID\nCYCLE/DRILL,4,MMPM,90,2\nGOTO/0,0,0\nCYCLE/OFF\nFINI\n")
        self.assertExit(0, "a.cls", "--dialect", "cl", "-o", "a.v2")
        self.assertExit(0, "verify", "a.v2", "--with", "a.cls", "--dialect", "cl")
        places = re.findall(r"TRANS\((-?[\d.]+), (-?[\d.]+), 0.000, 0.000, 180", (self.folder / "a.v2").read_text())
        arc = [(float(x), float(y)) for x, y in places]
        self.assertGreater(len(arc), 100)
        for a, b in zip(arc, arc[1:]):
            self.assertAlmostEqual(math.hypot(*b), 20, 2)
            self.assertLess(20 - math.hypot((a[0] + b[0]) / 2, (a[1] + b[1]) / 2), 0.0025)

    def test_holes_that_cannot_be_written(self):
        for program, name, options in ((self.DRILLS.replace("BORE", "TAP"), "d.v2", ()),
                                       (self.DRILLS, "d.joints.csv", ("--machine", "stencil_robot.machine.toml")),
                                       (self.DRILLS, "d.v2", ("--machine", "path_s.machine.toml")), (self.DRILLS, "d.lng", ())):
            self.write("d.apt", program)
            self.assertExit(6, "d.apt", "-o", name, *options)
            self.assertIn("E0673", self.err)
            self.assertFalse((self.folder / name).exists())

    def test_speeds_waits_outputs_tool_and_base_are_compared(self):
        self.write("m.apt", "UNITS/MM\nFROM/0,0,50\nFEDRAT/600\nGOTO/10,20,5\nSPRAY/ON,3\nGOTO/90,20,5\nSPRAY/OFF,3\nDELAY/2\nFINI\n")
        for signal in ("stop", "fly"):
            self.write("tool.toml", f"[vplus]\nsignal = '{signal}'\ntool = [0, 0, 180, 0, 0, 0]\n")
            self.assertExit(0, "m.apt", "-o", "m.v2", "--machine", "tool.toml")
            self.assertExit(0, "verify", "m.v2", "--with", "m.apt", "--machine", "tool.toml")
            text = (self.folder / "m.v2").read_bytes().decode()
            for old, new, code, result in (("SPEED 10.000", "SPEED 20.000", "E0922", 5), ("DELAY 2.000", "DELAY 3.000", "E0924", 5),
                                           ("  SIGNAL 3\r\n", "", "E0921", 5), ("SIGNAL -3", "SIGNAL -4", "E0921", 5),
                                           ("TOOL TRANS(0.000, 0.000, 180", "TOOL TRANS(0.000, 0.000, 170", "E0636", 6),
                                           ("  ACCEL", "  BASE 0, 0, 10\r\n  ACCEL", "E0637", 6)):
                with self.subTest(new=new, signal=signal):
                    self.assertIn(old, text)
                    self.write("m.v2", text.replace(old, new, 1))
                    self.assertExit(result, "verify", "m.v2", "--with", "m.apt", "--machine", "tool.toml")
                    self.assertIn(code, self.err)
            self.write("m.v2", text)
            self.assertExit(6, "verify", "m.v2", "--with", "m.apt")
            self.assertIn("E0636", self.err)

    def test_waits_without_an_end(self):
        self.write("w.apt", "UNITS/MM\nFEDRAT/900,MMPS\nGOTO/1000,0,400\nDELAY/3,REV\nGOTO/2000,0,400\nFINI\n")
        for name in ("w.v2", "w.joints.csv"):
            self.assertExit(6, "w.apt", "-o", name, "--machine", "stencil_robot.machine.toml")
            self.assertIn("E0625", self.err)
            self.assertFalse((self.folder / name).exists())

    def test_out_of_reach_writes_nothing(self):
        self.write("stop.apt", STOP.replace("500", "2440"))
        self.assertExit(6, "stop.apt", "-o", "far.v2", "--machine", "adept_three.machine.toml")
        self.assertEqual(self.err.count("error[E0660]"), 1)
        self.assertEqual(self.err.count("error[E0661]"), 1)
        self.assertRegex(self.err, r"\d+ of \d+ locations are so")
        self.assertFalse((self.folder / "far.v2").exists())

    def test_a_program_that_is_none_is_unreadable_input(self):
        self.write("m.apt", "UNITS/MM\nFROM/0,0,50\nFEDRAT/10,MMPS\nGOTO/10,0,5\nFINI\n")
        self.assertExit(0, "m.apt", "-o", "m.v2")
        self.write("bad.v2", (self.folder / "m.v2").read_text().replace("MOVES", "MUVES"))
        self.assertExit(3, "verify", "bad.v2", "--with", "m.apt")
        self.assertIn("E0630", self.err)

    def test_factors_do(self):
        def planned(speed, name, *machine):
            self.write("f.apt", f"UNITS/MM\nSTENCL/'I',HEIGHT,2440,FAN,63.5,SPEED,{speed}\nFINI\n")
            return self.run_arelem("f.apt", "-o", name, *machine)
        def toml(rapid, acceleration, turn):
            text = (PROJECT / "stdlib/machines/stencil_robot.machine.toml").read_text()
            for old, new in (("rapid = 1500", f"rapid = {rapid}"), ("acceleration = 2000", f"acceleration = {acceleration}"),
                             ("speed = [400, 90]", f"speed = [40, {turn}]"), ("acceleration = [1200, 400]", "acceleration = [100, 60]")):
                self.assertIn(old, text)
                text = text.replace(old, new)
            self.write("slow.toml", text)
        # The tool point of a V+ program: 1200 mm/s of 3243 are 0.36996, not 0.37.
        self.write("v.toml", "speed = 1200\n")
        self.assertEqual(planned(3243.57, "f.v2", "--machine", "v.toml"), 6)
        factor = float(re.search(r"([\d.]+) times as much", self.err)[1])
        self.assertEqual(planned(3243.57 * factor, "f.v2", "--machine", "v.toml"), 0, self.err)
        # Joints: the speeds, with the rapid ones.
        toml(1500, 2000, 8)
        self.assertEqual(planned(600, "f.joints.csv", "--machine", "slow.toml"), 6)
        told = re.search(r"among them, ([\d.]+) times as large would do(?:, or ([\d.]+) times with acceleration = ([\d.]+))?", self.err)
        choices = [(float(told[1]), 2000)] + ([(float(told[2]), told[3])] if told[2] else [])
        for factor, acceleration in choices:
            toml(1500 * factor, acceleration, 8)
            self.assertEqual(planned(600 * factor, "f.joints.csv", "--machine", "slow.toml"), 0, self.err)

    def test_a_slow_arm_makes_a_thick_film(self):
        # 2440 mm at 2200 mm/s with 2000 mm/s2 from rest to rest: 2 sqrt(2440 / 2000) = 2.21 s and the window, not 1.11 s.
        self.write("i.apt", "UNITS/MM\nGOTO/0,0,0\nFEDRAT/2200,MMPS\nSPRAY/ON,1\nGOTO/0,2440,0\nSPRAY/OFF,1\nFINI\n")
        self.assertExit(0, "i.apt", "-o", "i.joints.csv", "--machine", "stencil_robot.machine.toml")
        told = re.search(r"open for ([\d.]+) s, ([\d.]+) s at the speeds of the program: the film becomes ([\d.]+)", self.err)
        self.assertIn("W0684", self.err)
        self.assertAlmostEqual(float(told[1]), 2 * math.sqrt(2440 / 2000) + 0.192, 2)
        self.assertAlmostEqual(float(told[2]), 2440 / 2200, 2)
        self.assertAlmostEqual(float(told[3]), float(told[1]) / float(told[2]), delta=0.01)

    def test_side_of_the_arm(self):
        self.write("a.apt", "UNITS/MM\nFROM/600,0,600\nFEDRAT/100,MMPS\nGOTO/600,100,600\nFINI\n")
        arm = "[scara]\nheight = [500, 805]\nlefty = {}\n"
        for lefty, word in (("false", "RIGHTY"), ("true", "LEFTY")):
            self.write("arm.toml", arm.format(lefty))
            self.assertExit(0, "a.apt", "-o", "a.v2", "--machine", "arm.toml")
            self.assertIn(f"  {word}\r\n", (self.folder / "a.v2").read_bytes().decode())
            self.assertExit(0, "verify", "a.v2", "--with", "a.apt", "--machine", "arm.toml")

    def test_approaches_stay_in_the_reach(self):
        for height, code in ((600, "E0663"), (790, "E0661")):  # straight over the base; 50 over the place is beyond the quill
            self.write("a.apt", f"UNITS/MM\nFROM/600,-100,{height}\nFEDRAT/100,MMPS\nRAPID\nGOTO/{-600 if height == 600 else 500},100,{height}\nFINI\n")
            self.write("arm.toml", "[scara]\nheight = [500, 805]\n[vplus]\napproach = 50\n")
            self.assertExit(6, "a.apt", "-o", "a.v2", "--machine", "arm.toml")
            self.assertIn(code, self.err)

    def test_output_within_the_word_of_the_tilt(self):
        self.write("o.apt", STOP.replace("TILT", "OUTPUT,35,TILT"))
        self.assertExit(6, "o.apt", "-o", "o.v2", "--machine", "stencil_robot.machine.toml")
        self.assertIn("E0627", self.err)
        self.assertFalse((self.folder / "o.v2").exists())

    def test_outside_the_envelope_writes_nothing(self):
        self.write("stop.apt", STOP)
        self.write("cell.toml", "[envelope]\nz = [100, 900]\n")
        self.write("arm.toml", "[envelope]\nz = [100, 900]\n[elbow]\n")
        self.write("upright.apt", STOP.replace("QUADR", "OFF"))
        for name, machine, program in (("s.v2", "cell.toml", "stop.apt"), ("s.joints.csv", "arm.toml", "upright.apt")):
            with self.subTest(name):
                self.assertExit(6, program, "-o", name, "--machine", machine)
                self.assertIn("E0667", self.err)
                self.assertFalse((self.folder / name).exists())

    def test_letter_for_the_adept_three(self):
        # The letter P stands in the reach of the arm, as in figure 2.24 of the source.
        self.write("p.apt", "UNITS/MM\nO=POINT/550,-300,0\nSTENCL/'P',HEIGHT,600,FAN,63.5,509.3,.878715,SPEED,300,ORIGIN,O,TILT,QUADR\nFINI\n")
        self.assertExit(0, "p.apt", "-o", "p.v2", "--machine", "adept_three.machine.toml")
        self.assertIn("BITS 33, 8 = ", (self.folder / "p.v2").read_text())
        self.assertExit(0, "verify", "p.v2", "--with", "p.apt", "--machine", "adept_three.machine.toml")

    def test_tall_letter_of_the_manual(self):
        manual = (PROJECT / "docs" / "manual" / "vplus.md").read_text()
        program = re.search(r"```\n(PARTNO ADEPT S\n.*?)```", manual, re.S).group(1)
        self.write("s.apt", program)
        self.assertExit(0, "s.apt", "-o", "s.v2", "--machine", "adept_three.machine.toml")
        self.assertExit(0, "verify", "s.v2", "--with", "s.apt", "--machine", "adept_three.machine.toml")

    def test_two_lines_of_words_by_a_driving_arm(self):
        # Beyond the reach of one place of the truck; TRACUT says how far it drives.
        shutil.copy(PROJECT / "examples" / "school_xing.apt", self.folder / "x.apt")
        self.assertExit(0, "x.apt", "-o", "x.joints.csv", "--machine", "stencil_robot.machine.toml")
        text = (self.folder / "x.apt").read_text()
        self.write("y.apt", "\n".join(line for line in text.splitlines() if not line.startswith("TRACUT")) + "\n")
        self.assertExit(6, "y.apt", "-o", "y.joints.csv", "--machine", "stencil_robot.machine.toml")
        self.assertIn("E0681", self.err)
        self.assertFalse((self.folder / "y.joints.csv").exists())

    def test_joints_too_fast(self):
        self.write("f.apt", "UNITS/MM\nFEDRAT/9000,MMPS\nGOTO/1000,0,400\nGOTO/2000,0,400\nFINI\n")
        self.write("f.joints.csv", "as it was\n")
        self.assertExit(6, "f.apt", "-o", "f.joints.csv", "--machine", "stencil_robot.machine.toml")
        self.assertIn("9000 mm/s; the robot's largest speed is 3000, 0.3333 times", self.err)
        self.assertEqual((self.folder / "f.joints.csv").read_text(), "as it was\n")

    def test_joints_of_the_stencil_robot(self):
        self.write("stop.apt", STOP.replace("500", "2440"))
        self.assertExit(0, "stop.apt", "-o", "s.joints.csv", "-o", "s.joints.svg", "--machine", "stencil_robot.machine.toml")
        rows = [line.split(",") for line in (self.folder / "s.joints.csv").read_text().splitlines()]
        head, rows = rows[0], [[float(cell) for cell in row] for row in rows[1:]]
        at = {name: i for i, name in enumerate(head)}
        for i, row in enumerate(rows):
            self.assertEqual(row[0], i)
            self.assertAlmostEqual(row[at["time_s"]], 0.032 * i, 5)
            radius = math.hypot(row[at["x_mm"]], row[at["y_mm"]])
            self.assertAlmostEqual(row[at["actuator_mm"]] * 25 / 3, radius, 2)
            self.assertAlmostEqual(math.degrees(math.atan2(row[at["y_mm"]], row[at["x_mm"]])), row[at["turn_deg"]], 3)
        for i in range(1, len(rows) - 1):
            # Places follow from speeds: within what the acceleration changes in an interval.
            for place, speed, most in (("actuator_mm", "actuator_mm_s", 1200), ("turn_deg", "turn_deg_s", 400)):
                mean = (rows[i + 1][at[place]] - rows[i - 1][at[place]]) / 0.064
                self.assertLess(abs(mean - rows[i][at[speed]]), most * 0.032)
        self.assertEqual({row[at["gun"]] for row in rows}, {0, 1})
        self.assertIn("</svg>", (self.folder / "s.joints.svg").read_text())

    def test_joints_of_the_elbow(self):
        self.write("stop.apt", STOP.replace("500", "2440"))
        self.assertExit(0, "stop.apt", "-o", "s.joints.csv", "--machine", "elbow_robot.machine.toml")
        rows = [line.split(",") for line in (self.folder / "s.joints.csv").read_text().splitlines()]
        at = {name: i for i, name in enumerate(rows[0])}
        for row in rows[1:]:
            radius = math.hypot(float(row[at["x_mm"]]), float(row[at["y_mm"]]))
            counts = math.acos(radius / 5588) * 44000 / math.pi
            self.assertLess(abs(int(row[at["elbow_counts"]]) - counts), 0.6)
        self.assertExit(6, "stop.apt", "-o", "no.joints.csv")
        self.assertIn("E0680", self.err)
        self.assertFalse((self.folder / "no.joints.csv").exists())

    def test_damaged_files_are_named(self):
        self.write("x.alphabet", "GRID 4 25\nSYMBOL A\nSTROKE 9\n")
        self.write("a.apt", "STENCL/'A',HEIGHT,500,FAN,60,SPEED,100,ALPHAB,'x.alphabet'\nFINI\n")
        self.assertExit(3, "a.apt", "-o", "a.cls")
        self.assertIn("`x.alphabet`, line 3, column 8", self.err)
        self.assertFalse((self.folder / "a.cls").exists())
        self.write("m.toml", "speed = 3\nspede = 4\n")
        self.write("a.apt", "GOTO/1,2,3\nFINI\n")
        self.assertExit(3, "a.apt", "-o", "a.v2", "--machine", "m.toml")
        self.assertIn("`m.toml`, line 2: there is no key `spede`", self.err)
        self.assertFalse((self.folder / "a.v2").exists())

    def test_own_symbols_need_no_compiler(self):
        self.write("plus.alphabet", "GRID 4 25\nSYMBOL +\nSTROKE 5 1.5,6 2.5,6 TO 1.5,19 2.5,19\n")
        self.write("a.apt", "UNITS/MM\nSTENCL/'+',HEIGHT,2500,FAN,60,SPEED,100,ALPHAB,'plus.alphabet'\nFINI\n")
        self.assertExit(0, "a.apt", "-o", "a.cls")
        self.assertIn("GOTO / 200.0, 600.0,", (self.folder / "a.cls").read_text())


if __name__ == "__main__":
    unittest.main()
