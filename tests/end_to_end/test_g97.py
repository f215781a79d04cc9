#!/usr/bin/env python3
"""G97 programs of whole part programs: written, read again, compared; --compat; long paths; machine files."""
import pathlib
import re
import subprocess
import unittest

from arelem_run import ArelemCase

PROJECT = pathlib.Path(__file__).resolve().parents[2]
MACHINE = "g97_painter.machine.toml"


class G97(ArelemCase):
    def test_samples_of_the_source(self):
        for name in ("sen_plane", "sen_half_cylinder", "sen_revolved"):
            with self.subTest(name):
                program = PROJECT / "examples" / f"{name}.apt"
                self.assertExit(0, program, "-o", "a.lng")
                text = (self.folder / "a.lng").read_bytes()
                self.assertTrue(text.startswith(b"O0001\r\nN0001 P F0500M G97,N,F,0,0,0\r\n"), text[:60])
                self.assertEqual(text.count(b"PE\r\n"), 1)
                self.assertEqual(text.count(b"RON,1 "), text.count(b"ROF,1 "))
                self.assertEqual(text.count(b"RON,1 "), text.count(b" P F"))  # P between passes, L inside
                self.assertExit(0, "verify", "a.lng", "--with", program)
                self.assertIn("locations", self.err)

    def test_a_path_without_a_feed(self):
        self.write("a.apt", "UNITS/MM\nFROM/0,0,0\nGOTO/9,0,0\nGOTO/9,9,0\nFINI\n")
        self.assertExit(6, "a.apt", "-o", "a.lng")
        self.assertIn("E0640", self.err)
        self.assertIn("no FEDRAT came before it", self.err)
        self.write("a.apt", "UNITS/MM\nFEDRAT/9999999\nFROM/0,0,0\nGOTO/9,0,0\nGOTO/9,9,0\nFINI\n")
        self.assertExit(6, "a.apt", "-o", "a.lng")
        self.assertNotIn("no FEDRAT", self.err)

    def test_verify_sees_what_was_changed(self):
        program = PROJECT / "examples" / "sen_half_cylinder.apt"
        self.assertExit(0, program, "-o", "a.lng")
        text = (self.folder / "a.lng").read_bytes().decode()
        place = text.index("Q ", text.index("N0009"))
        end = text.index(" R", place)
        for old, new, code, result in ((text[place:end], "Q 3.33", "E0903", 5), ("RON,1 BE", "RON,2 BE", "E0645", 3),
                               ("Y ", "Y 1", "E0901", 5), ("N0002", "N0007", "E0645", 3)):
            with self.subTest(new):
                (self.folder / "b.lng").write_bytes(text.replace(old, new, 1).encode())
                self.assertExit(result, "verify", "b.lng", "--with", program)
                self.assertIn(code, self.err)

    def test_compat(self):
        self.write("a.apt", "UNITS/MM\nMULTAX/ON\nFROM/0,0,100,1,1,1\nFEDRAT/50,MMPS\nGOTO/10,0,100,0,0,1\nFINI\n")
        self.assertExit(0, "a.apt", "-o", "a.lng")
        self.assertIn("P -45.00 Q 35.26 R 0.00", (self.folder / "a.lng").read_text())
        self.assertExit(0, "a.apt", "-o", "b.lng", "--compat", "robopaint")
        self.assertIn("P -45.00 Q 45.00 R 0.00", (self.folder / "b.lng").read_text())
        self.assertIn("W0644", self.err)
        self.assertIn("9.74", self.err)
        self.assertExit(0, "verify", "b.lng", "--with", "a.apt", "--compat", "robopaint")
        self.assertExit(5, "verify", "b.lng", "--with", "a.apt")
        self.assertExit(2, "a.apt", "-o", "c.lng", "--compat", "other")

    def test_machine_file(self):
        self.write("m.toml", "rapid = 250\n[envelope]\nx = [0, 500]\n[g97]\nblocks = 4\nprogram = 30\n")
        self.write("a.apt", "UNITS/MM\nG1=GUN/CONE,45,STNDOF,50,SPEED,200\nR1=REGION/(50,50),(350,50),(350,350),(50,350)\n"
                            "SPRAY/R1,GUN,G1,FILM,.05\nFINI\n")
        self.assertExit(0, "a.apt", "-o", "a.lng", "--machine", "m.toml")
        self.assertIn("W0640", self.err)
        self.assertIn("O0030\n", (self.folder / "a.lng").read_text())
        self.assertIn("F0250M", (self.folder / "a.lng").read_text())
        self.assertExit(0, "verify", "a.lng", "--with", "a.apt", "--machine", "m.toml")
        self.write("far.toml", "[envelope]\nx = [0, 300]\n")
        self.assertEqual(self.run_arelem("a.apt", "-o", "far.lng", "--machine", "far.toml"), 6)
        self.assertIn("E0667", self.err)
        self.assertFalse((self.folder / "far.lng").exists())
        self.write("bad.toml", "[g97]\nwrist = \"X\"\n")
        self.assertExit(3, "a.apt", "-o", "bad.lng", "--machine", "bad.toml")
        self.assertIn("E0652", self.err)

    def test_a_pass_too_long_writes_nothing(self):
        self.write("m.toml", "[g97]\nblocks = 2\n")
        self.write("a.apt", "UNITS/MM\nFROM/0,0,0\nFEDRAT/50,MMPS\nSPRAY/ON\nGOTO/1,0,0\nGOTO/2,0,0\nGOTO/3,0,0\nSPRAY/OFF\nFINI\n")
        self.assertEqual(self.run_arelem("a.apt", "-o", "a.lng", "--machine", "m.toml"), 6)
        self.assertIn("E0643", self.err)
        self.assertFalse((self.folder / "a.lng").exists())

    def test_passes_without_rapid_are_divided(self):
        passes = "".join(f"GOTO/0,{i},0\nSPRAY/ON\n" + "".join(f"GOTO/{j},{i},0\n" for j in range(1, 700)) +
                         "SPRAY/OFF\n" for i in range(1, 31))
        self.write("a.apt", f"UNITS/MM\nFROM/0,0,0\nFEDRAT/50,MMPS\n{passes}FINI\n")
        self.assertExit(0, "a.apt", "-o", "a.lng")
        text = (self.folder / "a.lng").read_bytes().decode()
        self.assertIn("W0640", self.err)
        programs = re.split(r"^(?=O\d{4}\r)", text, flags=re.M)[1:]
        self.assertEqual(len(programs), 3)  # 14 passes of 700 blocks each fit into one
        for program in programs:
            self.assertEqual(program.count("RON,1"), program.count("ROF,1"))
            self.assertTrue(program.endswith("ROF,1 PE\r\n"))
        self.assertExit(0, "verify", "a.lng", "--with", "a.apt")
        # The block that begins the second program must lead to where the first one ended.
        second = text.index("O0002")
        place = text.index("X ", second)
        (self.folder / "b.lng").write_bytes((text[:place] + "X 1" + text[place + 2:]).encode())
        self.assertExit(5, "verify", "b.lng", "--with", "a.apt")

    def test_divided_with_a_code_in_front(self):
        self.write("m.toml", "[g97]\nblocks = 5\ns63 = \"S63,1,1,1\"\n")
        moves = "".join(f"GOTO/{i},0,0\n" for i in range(1, 12)) + "RAPID\nGOTO/0,5,0\nGOTO/3,5,0\n"
        self.write("a.apt", f"UNITS/MM\nFROM/0,0,0\nFEDRAT/50,MMPS\n{moves}FINI\n")
        self.assertExit(0, "a.apt", "-o", "a.lng", "--machine", "m.toml")
        self.assertExit(0, "verify", "a.lng", "--with", "a.apt", "--machine", "m.toml")
        text = (self.folder / "a.lng").read_bytes().decode()
        self.assertEqual(text.count("S63,1,1,1 BE"), text.count("PE\r\n"))
        (self.folder / "b.lng").write_bytes(text.replace("S63,1,1,1 ", "", 1).encode())
        self.assertExit(3, "verify", "b.lng", "--with", "a.apt", "--machine", "m.toml")
        self.assertIn("E0645", self.err)

    def test_verify_sees_speeds_and_kinds_of_moves(self):
        self.write("a.apt", "UNITS/MM\nFROM/0,0,0\nFEDRAT/50,MMPS\nGOTO/10,0,0\nGOTO/20,0,0\nRAPID\nGOTO/20,9,0\n"
                            "FEDRAT/7.5,MMPS\nGOTO/0,9,0\nFINI\n")
        self.assertExit(0, "a.apt", "-o", "a.lng")
        self.assertExit(0, "verify", "a.lng", "--with", "a.apt")
        text = (self.folder / "a.lng").read_bytes().decode()
        for old, new, code in (("L F0050M", "L F0051M", "E0922"), ("N0003 L", "N0003 P", "E0925"),
                               ("N0004 P", "N0004 L", "E0925"), ("P F0500M", "P F0300M", "E0922"),
                               ("F0008M", "F0007M", "E0922")):
            with self.subTest(old):
                self.assertIn(old, text)
                (self.folder / "b.lng").write_bytes(text.replace(old, new, 1).encode())
                self.assertExit(5, "verify", "b.lng", "--with", "a.apt")
                self.assertIn(code, self.err)

    def test_more_blocks_than_a_program_takes(self):
        # 5 by 9000 mm with passes of 1.65 mm: 5455 passes of two blocks.
        self.write("a.apt", "UNITS/MM\nG1=GUN/ELLIPS,1,1,SPEED,200,FLOW,1\nR1=REGION/(0,0),(5,0),(5,9000),(0,9000)\n"
                            "SPRAY/R1,GUN,G1,FILM,.05,OVRLAP,.175\nFINI\n")
        self.assertExit(0, "a.apt", "-o", "a.lng")
        text = (self.folder / "a.lng").read_bytes().decode()
        blocks = len(re.findall(r"^N\d{4} ", text, re.M))
        self.assertGreater(blocks, 9999)
        self.assertIn(f"{blocks} blocks are more than the 9999 of one program: the output has 2 programs, numbers 1 to 2", self.err)
        self.assertExit(0, "verify", "a.lng", "--with", "a.apt")
        # As the manual says: one file for each program. The gun is off at the end of each, and nothing is lost.
        subprocess.run(["csplit", "-s", "-z", "-f", "part", "a.lng", "/^O/", "{*}"], cwd=self.folder, check=True)
        parts = sorted(self.folder.glob("part*"))
        self.assertEqual(len(parts), 2)
        self.assertEqual("".join(p.read_bytes().decode() for p in parts), text)
        for number, part in enumerate((p.read_bytes().decode() for p in parts), 1):
            self.assertTrue(part.startswith(f"O{number:04}\r\nN0001 P "))
            self.assertTrue(part.endswith("ROF,1 PE\r\n"))
            self.assertEqual(part.count("RON,1"), part.count("ROF,1"))
            self.assertEqual(part.count("PE\r\n"), 1)
            self.assertLessEqual(part.count("\nN"), 9999)

    def test_a_program_without_motion(self):
        self.write("a.apt", "PARTNO A\nUNITS/MM\nFINI\n")
        self.assertExit(6, "a.apt", "-o", "a.lng")
        self.assertIn("E0647", self.err)
        self.assertFalse((self.folder / "a.lng").exists())

    def test_program_numbers_end(self):
        self.write("m.toml", "[g97]\nblocks = 2\nprogram = 9999\n")
        self.write("a.apt", "UNITS/MM\nFROM/0,0,0\nRAPID\nGOTO/1,0,0\nRAPID\nGOTO/2,0,0\nFINI\n")
        self.assertExit(6, "a.apt", "-o", "a.lng", "--machine", "m.toml")
        self.assertIn("E0646", self.err)
        self.assertFalse((self.folder / "a.lng").exists())

    def test_the_example_machine_file(self):
        sprayed = [p for p in sorted((PROJECT / "examples").glob("*.apt")) if "\nSPRAY/" in p.read_text()]
        self.assertGreaterEqual(len(sprayed), 5)
        for program in sprayed:
            with self.subTest(program.name):
                self.assertExit(0, program, "-o", "a.lng", "--machine", MACHINE)
                self.assertExit(0, "verify", "a.lng", "--with", program, "--machine", MACHINE)


if __name__ == "__main__":
    unittest.main()
