"""verify of V+ programs: not only places, but all that the program does, in its order."""
import unittest

from arelem_run import ArelemCase

STOP = "PARTNO STOP\nUNITS/MM\nSTENCL/'STOP',HEIGHT,500,FAN,63.5,SPEED,600,TILT,QUADR\nFINI\n"
MACHINE = ("--machine", "stencil_robot.machine.toml")


class Events(ArelemCase):
    def damaged(self, name, lines):
        self.write("m.v2", "\r\n".join(lines))
        with self.subTest(name):
            code = self.run_arelem("verify", "m.v2", "--with", "stop.apt", *MACHINE)
            self.assertIn(code, (3, 5, 6), name)
            self.assertRegex(self.err, r"error\[E0(926|927|630|634|922|921)\]")

    def setUp(self):
        super().setUp()
        self.write("stop.apt", STOP)
        self.assertExit(0, "stop.apt", "-o", "stop.v2", *MACHINE)
        self.lines = (self.folder / "stop.v2").read_bytes().decode().split("\r\n")

    def at(self, word, number=0):
        return [i for i, line in enumerate(self.lines) if line.split()[:1] == [word]][number]

    def test_what_is_put_in(self):
        where = self.at("MOVES", 5)
        place = self.lines[where].split("MOVES ")[1]
        for more in (["RETURN"], ["STOP"], ["PAUSE"], ["DEPARTS 500"], [f"APPROS {place}, 50"], ["DURATION 1000 ALWAYS"], ["DURATION 9"],
                     ["SPEED 1 MONITOR"], ["SPEED 500 MONITOR"], ["SIGNAL -1", "SIGNAL 1"], ["SIGNAL 33"], ["SIGNAL -gun"], ["ACCEL -5, -5"],
                     ["ACCEL 5, 5"], ["COARSE -5"], ["COARSE 500 ALWAYS"], ["BITS 1, 8 = 0"], ["DISABLE CP"], ["LEFTY"], ["CPOFF ALWAYS"],
                     ["BREAK"], ["FINE 1"], ["NONULL"], ["PARAMETER HAND.TIME = 9"], ["BELOW"], ["FLIP"]):
            self.damaged(more, self.lines[:where] + more + self.lines[where:])

    def test_what_is_changed(self):
        self.damaged("MOVE", [line.replace("MOVES", "MOVE") for line in self.lines])
        one = list(self.lines)
        one[self.at("MOVES", 5)] = one[self.at("MOVES", 5)].replace("MOVES", "MOVE")
        self.damaged("one MOVE", one)
        self.damaged("rotation 0", [line.replace(", 100 MMPS", ", 0 MMPS") for line in self.lines])
        self.damaged("rotation 1", [line.replace(", 100 MMPS", ", 1 MMPS") for line in self.lines])
        on = self.at("SIGNAL")
        early = list(self.lines)
        early.insert(self.at("MOVE"), early.pop(on))
        self.damaged("SIGNAL before the first MOVE", early)
        self.damaged("no BREAK before SIGNAL", self.lines[:on - 1] + self.lines[on:])
        self.damaged("twice", self.lines + self.lines)
        self.damaged("a second program", self.lines + [".PROGRAM more()", ".END", ""])

    def test_how_it_is_spelled_does_not_count(self):
        speed = self.at("SPEED", 3)
        given = float(self.lines[speed].split()[1].rstrip(","))
        same = [line.lower() for line in self.lines]
        same[speed] = f"  speed ({given / 25.4:.9f}), 100 ips always ; the same"
        same.insert(speed, "  x = FALSE")
        same = [line for line in same if line.strip() != "return"]  # .END returns too
        self.write("m.v2", "\n".join(same))
        self.assertExit(0, "verify", "m.v2", "--with", "stop.apt", *MACHINE)
        self.assertNotIn("W0632", self.err)

    def test_lines_of_the_source_are_compared(self):
        self.write("s.apt", "P=POINT/400,-900,0\nSTENCL/'S',HEIGHT,1800,FAN,63.5,509.3,0.878715,SPEED,600,ORIGIN,P,COMPAT\nFINI\n")
        machine = ("--machine", "path_s.machine.toml")
        self.assertExit(0, "s.apt", "-o", "s.v2", *machine)
        self.assertExit(0, "verify", "s.v2", "--with", "s.apt", *machine)
        text = (self.folder / "s.v2").read_text().splitlines()
        text[7] += "1"
        self.write("s.v2", "\n".join(text) + "\n")
        self.assertExit(5, "verify", "s.v2", "--with", "s.apt", *machine)
        self.assertIn("line 8", self.err)

    def test_the_two_files_the_wrong_way_round(self):
        self.assertExit(2, "verify", "stop.apt", "--with", "stop.v2", *MACHINE)
        self.assertIn("verify stop.v2 --with stop.apt", self.err)

    def test_slow_speeds(self):
        for feed, code, text in ((".1,MMPM", 0, "SPEED 0.001667,"), (".0001,MMPS", 6, "")):
            self.write("f.apt", f"UNITS/MM\nFROM/0,0,5\nFEDRAT/{feed}\nGOTO/1,0,5\nFINI\n")
            (self.folder / "f.v2").unlink(missing_ok=True)
            self.assertExit(code, "f.apt", "-o", "f.v2")
            self.assertEqual(code != 0, "E0626" in self.err)
            if text:
                self.assertIn(text, (self.folder / "f.v2").read_text())
                self.assertExit(0, "verify", "f.v2", "--with", "f.apt")
            else:
                self.assertFalse((self.folder / "f.v2").exists())


if __name__ == "__main__":
    unittest.main()
