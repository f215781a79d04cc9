"""Where results go, and that an output is complete or absent."""
import os
import pty
import unittest

from arelem_run import BAD, GOOD, ArelemCase


class Formats(ArelemCase):
    def test_plain_file_is_compiled_to_standard_output(self):
        self.write("a.apt", GOOD)
        self.assertExit(0, "a.apt")
        self.assertIn("GOTO", self.out)
        self.assertEqual(self.err, "")
        self.assertExit(0, "compile", "a.apt")

    def test_standard_input_to_standard_output(self):
        self.assertExit(0, "-", "-o", "-", "--to", "json", stdin=GOOD.encode())
        self.assertIn('"kind": "GOTO"', self.out)

    def test_suffix_decides_and_to_overrules(self):
        self.write("a.apt", GOOD)
        self.assertExit(0, "a.apt", "-o", "a.cls", "-o", "a.cltape", "-o", "a.jsonl")
        self.assertEqual(self.files(), ["a.apt", "a.cls", "a.cltape", "a.jsonl"])
        self.assertTrue((self.folder / "a.cltape").read_bytes().startswith(b"\x01\0\0\0"))
        self.assertExit(0, "a.apt", "-o", "b.txt", "--to", "json")
        self.assertIn('"kind"', (self.folder / "b.txt").read_text())
        self.assertExit(2, "a.apt", "-o", "c.unknown")
        self.assertIn("give one with --to", self.err)
        self.assertExit(2, "a.apt", "-o", "c.png")
        self.assertIn("`arelem view` writes it", self.err)
        self.assertExit(2, "a.apt", "--to", "jsn")
        self.assertIn("did you mean `json`?", self.err)

    def test_folder_for_several_inputs_and_formats(self):
        self.write("a.apt", GOOD)
        self.write("b.apt", GOOD)
        self.assertExit(0, "a.apt", "b.apt", "--out-dir", "out/x", "--to", "cl", "--to", "cltape")
        self.assertEqual(self.files(), ["a.apt", "b.apt", "out", "out/x", "out/x/a.cls", "out/x/a.cltape",
                                        "out/x/b.cls", "out/x/b.cltape"])
        self.assertExit(2, "a.apt", "b.apt")
        self.assertExit(2, "a.apt", "--to", "cl", "--to", "json")
        self.assertExit(2, "a.apt", "-o", "x.cls", "--out-dir", "out")

    def test_same_input_same_bytes(self):
        self.write("a.apt", GOOD)
        for suffix in ("cls", "cltape", "jsonl"):
            self.assertExit(0, "a.apt", "-o", "1." + suffix)
            self.assertExit(0, "a.apt", "-o", "2." + suffix)
            self.assertEqual((self.folder / ("1." + suffix)).read_bytes(), (self.folder / ("2." + suffix)).read_bytes())

    def test_summary_on_request(self):
        self.write("a.apt", GOOD)
        self.assertExit(0, "a.apt", "-v", "-o", "a.cls")
        self.assertIn("5 statements", self.err)
        self.assertIn("a.cls (", self.err)
        self.assertEqual(self.out, "")


class Refused(ArelemCase):
    def test_what_is_no_wrong_use_does_not_lead_to_the_help(self):
        self.write("a.apt", GOOD)
        (self.folder / "folder.cls").mkdir()
        self.assertExit(6, "a.apt", "-o", "folder.cls")
        self.assertEqual(self.err, "arelem: error: the output `folder.cls` is a folder\n")
        self.assertExit(6, "a.apt", "--out-dir", "a.apt")
        self.assertNotIn("--help", self.err)

    def test_a_slash_before_the_part_name_is_written_once(self):
        self.write("a.apt", GOOD.replace("PARTNO T", "PARTNO / PLATE"))
        self.assertExit(0, "a.apt")
        self.assertTrue(self.out.startswith("PARTNO / PLATE\n"), self.out)

    """Before any work: exit 2 or 6, nothing written."""

    def setUp(self):
        super().setUp()
        self.write("a.apt", GOOD)

    def refused(self, code, *words):
        before = self.files()
        self.assertExit(code, *words)
        self.assertEqual(self.files(), before)
        self.assertEqual((self.folder / "a.apt").read_text(), GOOD)
        self.assertNotIn("temporary", self.err)

    def test_output_equals_input(self):
        self.refused(2, "a.apt", "-o", "a.apt", "--to", "cl")
        self.refused(2, "a.apt", "-o", f"../{self.folder.name}/./a.apt", "--to", "cl")
        os.symlink("a.apt", self.folder / "link.cls")
        self.refused(2, "a.apt", "-o", "link.cls")

    def test_same_output_twice(self):
        self.refused(2, "a.apt", "-o", "o.cls", "-o", "./o.cls")
        self.refused(2, "a.apt", "sub/a.apt", "--out-dir", ".")

    def test_output_is_a_folder_or_in_none(self):
        (self.folder / "dir.cls").mkdir()
        self.refused(6, "a.apt", "-o", "dir.cls")
        self.refused(6, "a.apt", "-o", "nowhere/o.cls")

    @unittest.skipIf(os.geteuid() == 0, "root may write everywhere")
    def test_read_only_folder(self):
        (self.folder / "ro").mkdir(mode=0o555)
        self.refused(6, "a.apt", "-o", "ro/o.cls")

    def test_binary_to_a_terminal(self):
        leader, follower = pty.openpty()
        try:
            self.assertExit(2, "a.apt", "--to", "cltape", stdout=follower)
            self.assertIn("--force", self.err)
            self.assertExit(0, "a.apt", "--to", "cl", stdout=follower)
            self.assertExit(0, "a.apt", "--to", "cltape", "--force", stdout=follower)
        finally:
            os.close(leader)
            os.close(follower)


class AllOrNothing(ArelemCase):
    def test_errors_leave_an_older_output_as_it_was(self):
        self.write("bad.apt", BAD)
        self.write("o.cls", "old")
        self.assertExit(1, "bad.apt", "-o", "o.cls")
        self.assertEqual(self.files(), ["bad.apt", "o.cls"])
        self.assertEqual((self.folder / "o.cls").read_text(), "old")

    def test_errors_send_nothing_to_standard_output(self):
        self.assertExit(1, "-", stdin=BAD.encode())
        self.assertEqual(self.out, "")

    def test_replaced_output_keeps_its_mode_and_link(self):
        self.write("a.apt", GOOD)
        real = self.write("real.cls", "old")
        real.chmod(0o640)
        os.symlink("real.cls", self.folder / "o.cls")
        self.assertExit(0, "a.apt", "-o", "o.cls")
        self.assertTrue((self.folder / "o.cls").is_symlink())
        self.assertIn("GOTO", real.read_text())
        self.assertEqual(real.stat().st_mode & 0o777, 0o640)

    def test_full_device(self):
        self.write("a.apt", GOOD)
        with open("/dev/full", "wb") as full:
            self.assertExit(6, "a.apt", stdout=full)
        self.assertIn("cannot write `standard output`: No space left on device", self.err)
        self.assertExit(6, "a.apt", "-o", "/dev/full", "--to", "cl")
        self.assertExit(0, "a.apt", "-o", "/dev/null", "--to", "cltape")

    def test_motion_error_writes_nothing_unless_asked(self):
        self.write("a.apt", "FROM/0,0,0\nGOTO/1,2,3\nL1=LINE/5,0,5,1\nGO/TO,L1\nFINI\n")  # no cutter
        self.write("o.cls", "old")
        self.assertExit(4, "a.apt", "-o", "o.cls")
        self.assertEqual(self.files(), ["a.apt", "o.cls"])
        self.assertExit(4, "a.apt", "-o", "o.cls", "--keep-going")
        self.assertEqual(self.files(), ["a.apt", "o.cls", "o.cls.partial"])
        self.assertEqual((self.folder / "o.cls").read_text(), "old")
        self.assertIn("GOTO", (self.folder / "o.cls.partial").read_text())

    def test_closed_pipe_is_silent(self):
        self.write("a.apt", "".join(f"GOTO/{i},0,0\n" for i in range(20000)) + "FINI\n")
        read, write = os.pipe()
        os.close(read)
        try:
            self.assertExit(-13, "a.apt", stdout=write)  # SIGPIPE, as every filter
        finally:
            os.close(write)
        self.assertEqual(self.err, "")


if __name__ == "__main__":
    unittest.main()
