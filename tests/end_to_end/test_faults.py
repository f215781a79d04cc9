"""Bad inputs, faults of the machine, limits and signals: a message and the right exit code, never a crash."""
import os
import re
import resource
import signal
import subprocess
import time
import unittest

from arelem_run import ARELEM, ENDLESS, FAULTS, GOOD, PROJECT, ArelemCase


class Inputs(ArelemCase):
    def test_unreadable(self):
        (self.folder / "dir.apt").mkdir()
        self.assertExit(3, "missing.apt")
        self.assertIn("error[E0701]: cannot read `missing.apt`: No such file", self.err)
        self.assertExit(3, "check", "dir.apt")
        self.assertIn("it is a folder", self.err)
        self.assertExit(3, "geometry", "/dev/zero")
        self.assertIn("device", self.err)
        os.mkfifo(self.folder / "fifo.apt")
        self.assertExit(3, "fifo.apt", timeout=5)

    def test_binary_junk(self):
        for junk in (b"\0" * 100, b"\x7fELF\x02\x01\x01\0\0", bytes(range(256)) * 40, b"\xff\xfeP\0A\0", os.urandom(5000)):
            self.write("junk.apt", junk)
            self.assertExit(3, "check", "junk.apt")
            self.assertIn("junk.apt", self.err)

    def test_latin_1_comment_is_a_warning(self):
        self.write("a.apt", "PARTNO FRÄSTEIL\n".encode("latin-1") + GOOD.encode())
        self.assertExit(0, "check", "a.apt")
        self.assertIn("warning[W", self.err)

    def test_hundred_megabyte_line(self):
        with open(self.folder / "long.apt", "wb") as f:
            f.write(b"P1=POINT/1")
            for _ in range(100):
                f.write(b"1" * 1_000_000)
            f.write(b",2,3\nFINI\n")
        start = time.time()
        self.assertIn(self.run_arelem("check", "long.apt"), (1, 7))
        self.assertLess(len(self.err), 5000)
        self.assertLess(time.time() - start, 20)

    def test_file_beyond_the_limit(self):
        self.write("a.apt", GOOD)
        self.assertExit(7, "check", "a.apt", "--max-bytes", "10")
        self.assertIn("--max-bytes", self.err)

    def test_million_parentheses_and_elements(self):
        self.write("deep.apt", "A=" + "(" * 1_000_000 + "1" + ")" * 1_000_000 + "\nFINI\n")
        self.assertIn(self.run_arelem("check", "deep.apt"), (1, 7))
        self.write("wide.apt", "C=CYCLE/" + ",".join(["1"] * 1_000_000) + "\nFINI\n")
        self.assertIn(self.run_arelem("check", "wide.apt"), (1, 7))

    def test_line_ends_byte_order_mark_tabs_and_lower_case(self):
        for end in ("\n", "\r\n", "\r"):
            text = "\ufeff" + "partno t\n\tcutter/1\nfrom/0,0,0\ngoto/1,2,3\nfini\n".replace("\n", end)
            self.write("a.apt", text)
            self.assertExit(0, "a.apt", "--to", "json")
            self.assertEqual(self.out.count('"kind": "GOTO"'), 1, repr(end))

    def test_missing_fini(self):
        self.write("a.apt", "CUTTER/1\n")
        self.assertExit(1, "check", "a.apt", "--dialect=apt360")
        self.assertIn("FINI", self.err)


class LimitsAndFaults(ArelemCase):
    def test_endless_loop_reaches_the_step_limit(self):
        self.write("a.apt", ENDLESS)
        self.write("o.cls", "old")
        self.assertExit(7, "a.apt", "-o", "o.cls", "--max-steps=100000")
        self.assertIn("--max-steps", self.err)
        self.assertEqual((self.folder / "o.cls").read_text(), "old")
        self.assertEqual(self.files(), ["a.apt", "o.cls"])

    def test_every_limit_has_a_flag_and_its_default_in_the_manual(self):
        self.assertExit(0, "check", "--help")
        flags = re.findall(r"^ +--(max-[a-z-]+) N +(?:[\s]*)(.*) \((\d+)\)$", self.out, re.M)
        told = {(name, default) for name, _, default in flags if name != "max-errors"}
        manual = (PROJECT / "docs" / "manual" / "language" / "limits.md").read_text()
        written = set(re.findall(r"^\| `--(max-[a-z-]+) N` \| (\d+) \|", manual, re.M))
        self.assertEqual(told, written)
        self.assertGreaterEqual(len(told), 11)

    def test_each_limit_stops_what_it_bounds(self):
        self.write("loop.apt", ENDLESS)
        self.write("call.apt", "AA=MACRO/X\nY=X\nTERMAC\nBB=MACRO/Z\nCALL/AA,X=Z\nTERMAC\nCALL/BB,Z=1\nFINI\n")
        self.write("nest.apt", "A=((((1))))\nFINI\n")
        self.write("wide.apt", "C=CYCLE/1,2,3,4,5,6,7,8,9\nFINI\n")
        self.write("array.apt", "RESERV/A,100\nFINI\n")
        self.write("moves.apt", GOOD + "".join(f"GOTO/{i},0,0\n" for i in range(20)) + "FINI\n")
        self.write("arc.apt", "CUTTER/2\nOUTTOL/.0001\nFROM/20,-5,0\nGO/TO,(C=CIRCLE/0,0,0,10)\nTLLFT,GOLFT/C,ON,2,"
                   "INTOF,(LINE/0,0,0,20)\nFINI\n")
        for flag, program in (("steps=50", "loop"), ("depth=1", "call"), ("nesting=2", "nest"), ("elements=5", "wide"),
                              ("array=10", "array"), ("records=4", "moves"), ("line=10", "wide"), ("bytes=10", "wide"),
                              ("points=2", "arc")):
            with self.subTest(flag=flag):
                self.write("o.cls", "old")
                self.assertExit(7, f"{program}.apt", "-o", "o.cls", "--max-" + flag)
                self.assertIn("--max-" + flag.split("=")[0], self.err)
                self.assertEqual((self.folder / "o.cls").read_text(), "old")

    def test_out_of_memory(self):
        self.write("a.apt", "RESERV/P,5000000\nLOOPST\nI=0\nA)I=I+1\nP(I)=POINT/I,0,0\nJUMPTO/A\nLOOPND\nFINI\n")
        limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (300 << 20, 300 << 20))
        self.assertExit(7, "a.apt", preexec=limit)
        self.assertIn("out of memory", self.err)

    def preload(self, fault):
        return {"LD_PRELOAD": FAULTS, "ARELEM_FAULT": fault}

    def test_unexpected_exception_is_an_internal_error(self):
        self.write("a.apt", GOOD)
        self.assertExit(70, "a.apt", env=self.preload("read-throws"))
        self.assertIn("internal error", self.err)
        self.assertEqual(self.out, "")

    def test_disk_full_is_no_change_of_a_formatted_file(self):
        text = "p1=point/1,2\nfini\n"
        self.write("p.apt", text)
        self.assertExit(6, "fmt", "p.apt", env=self.preload("disk-full:4"))
        self.assertIn("arelem: 1 file, 0 changed, 1 failed\n", self.err)
        self.assertEqual((self.folder / "p.apt").read_text(), text)

    def test_disk_full_after_n_bytes_keeps_the_old_output(self):
        self.write("a.apt", "".join(f"GOTO/{i},0,0\n" for i in range(5000)) + "FINI\n")
        self.write("o.cls", "old")
        for size in (0, 1, 4096, 70000):
            self.assertExit(6, "a.apt", "-o", "o.cls", env=self.preload(f"disk-full:{size}"))
            self.assertIn("No space left", self.err)
            self.assertEqual(self.files(), ["a.apt", "o.cls"])
            self.assertEqual((self.folder / "o.cls").read_text(), "old")

    def test_failing_fsync_and_rename_keep_the_old_output(self):
        self.write("a.apt", GOOD)
        self.write("o.cls", "old")
        for fault in ("fsync", "rename"):
            self.assertExit(6, "a.apt", "-o", "o.cls", env=self.preload(fault))
            self.assertEqual(self.files(), ["a.apt", "o.cls"])
            self.assertEqual((self.folder / "o.cls").read_text(), "old")

    def test_failing_allocations_never_crash(self):
        self.write("a.apt", GOOD)
        self.write("o.cls", "old")
        codes = set()
        for n in [*range(1, 40), *range(40, 4000, 97)]:
            codes.add(self.run_arelem("a.apt", "-o", "o.cls", env=self.preload(f"malloc:{n}")))
            self.assertIn((self.folder / "o.cls").read_text()[:3], ("old", "PAR", "$$-", "CUT"))
            self.assertEqual(self.files(), ["a.apt", "o.cls"], n)
        self.assertTrue(codes <= {0, 7}, codes)
        self.assertIn(7, codes)


class Signals(ArelemCase):
    def interrupt(self, number):
        self.write("a.apt", ENDLESS)
        self.write("o.cls", "old")
        process = subprocess.Popen([ARELEM, "a.apt", "-o", "o.cls", "--max-steps=1000000000000"], cwd=self.folder,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        time.sleep(0.3)
        start = time.time()
        process.send_signal(number)
        process.communicate(timeout=5)
        self.assertLess(time.time() - start, 0.2 + 0.1)  # 200 ms, and what the test itself needs
        self.assertEqual(self.files(), ["a.apt", "o.cls"])
        self.assertEqual((self.folder / "o.cls").read_text(), "old")
        return process.returncode

    def test_interrupt_and_terminate(self):
        self.assertEqual(self.interrupt(signal.SIGINT), 130)
        self.assertEqual(self.interrupt(signal.SIGTERM), 143)

    def test_interrupt_in_the_middle_of_motion(self):
        self.write("a.apt", "CUTTER/10,5\nINTOL/1E-9\nOUTTOL/1E-9\n".replace("1E", "1.E")
                   + "NUMPTS/10000000\nMAXDP/.00002\nPS1=SPHERE/0,0,-50,50\nFROM/-40,0,10\n"
                     "A=PLANE/1,0,0,-30\nB=PLANE/1,0,0,30\nD=PLANE/0,1,0,0\nGO/ON,D,TO,PS1,ON,A\nINDIRV/1,0,0\n"
                     "TLON,GOFWD/D,ON,B\nFINI\n")
        process = subprocess.Popen([ARELEM, "a.apt", "-o", "o.cls"], cwd=self.folder, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE)
        time.sleep(0.15)
        start = time.time()
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=5)
        self.assertLess(time.time() - start, 0.3)
        self.assertEqual(process.returncode, 130)  # three million cut vectors are not done in 0.15 s
        self.assertEqual(self.files(), ["a.apt"])


if __name__ == "__main__":
    unittest.main()
