"""Every command: what it prints, on which stream, and how wrong use is told."""
import json
import unittest

from arelem_run import BAD, GOOD, ArelemCase


class Help(ArelemCase):
    def test_help_goes_to_stdout(self):
        for words in (["--help"], ["-h"]):
            self.assertExit(0, *words)
            self.assertIn("usage:", self.out)
            self.assertIn("exit codes:", self.out)
            self.assertEqual(self.err, "")

    def test_every_command_has_help_with_its_options(self):
        for command in ("compile", "check", "geometry", "dump", "explain", "targets"):
            self.assertExit(0, command, "--help")
            self.assertIn("Usage:", self.out)

    def test_nothing_to_do_is_wrong_use(self):
        self.assertExit(2)
        self.assertEqual(self.out, "")
        self.assertIn("usage:", self.err)

    def test_version_is_one_line(self):
        self.assertExit(0, "--version")
        self.assertRegex(self.out, r"^arelem \d+\.\d+\.\d+( \([0-9a-f]+\))?\n$")


class WrongUse(ArelemCase):
    def test_unknown_option_suggests_the_nearest(self):
        self.write("a.apt", GOOD)
        self.assertExit(2, "check", "a.apt", "--dialct=apt360")
        self.assertIn("did you mean `--dialect`?", self.err)
        self.assertEqual(self.out, "")

    def test_repeated_single_value_option(self):
        self.write("a.apt", GOOD)
        self.assertExit(2, "compile", "a.apt", "--dialect", "cl", "--dialect", "apt4")
        self.assertIn("--dialect", self.err)

    def test_missing_file_argument(self):
        self.assertExit(2, "check")
        self.assertExit(2, "compile", "-q")

    def test_bad_values(self):
        self.write("a.apt", GOOD)
        for words in (["--dialect=fortran"], ["--max-stepps=5"], ["--max-steps=many"], ["--max-steps=-1"], ["--max-steps=5", "--max-steps=6"], ["-D", "X"], ["-D", "X=y"], ["-D", "X=nan"], ["-D", "X=inf"],
                      ["-D", "X=1", "-D", "x=2"], ["--color=blue"], ["--max-errors=-1"], ["--diagnostics=xml"]):
            self.assertExit(2, "check", "a.apt", *words)
            self.assertEqual(self.out, "")
            self.assertTrue(self.err)

    def test_flags_may_stand_before_the_command(self):
        self.write("a.apt", GOOD)
        self.assertExit(0, "check", "-q", "a.apt")
        quiet = (self.out, self.err)
        self.assertExit(0, "-q", "check", "a.apt")
        self.assertEqual((self.out, self.err), quiet)
        self.assertExit(0, "--color=never", "--quiet", "geometry", "a.apt", "--json")
        json.loads(self.out)
        self.assertExit(0, "-q", "a.apt")  # no command: compiled
        self.assertIn("FINI", self.out)
        # What follows an option that has a value may be that value.
        self.assertExit(2, "--dialect", "check", "a.apt")

    def test_mistyped_command_is_taken_for_a_file(self):
        self.assertExit(3, "chekc")
        self.assertIn("neither a file nor a command `chekc`; did you mean `check`?", self.err)
        self.assertExit(3, "compil", "a.apt")
        self.assertIn("did you mean `compile`?", self.err)
        self.assertExit(3, "b.apt")
        self.assertIn("cannot read `b.apt`", self.err)
        self.write("chekc", GOOD)
        self.assertExit(0, "chekc")
        self.assertIn("FINI", self.out)

    def test_help_without_dashes(self):
        self.assertExit(0, "help")
        self.assertIn("usage: arelem FILE...", self.out)
        self.assertExit(0, "check", "--help")
        expected = self.out
        self.assertExit(0, "help", "check")
        self.assertEqual(self.out, expected)


class Check(ArelemCase):
    def test_good_and_bad_with_summary(self):
        self.write("good.apt", GOOD)
        self.write("bad.apt", BAD)
        self.assertExit(0, "check", "good.apt")
        self.assertIn("1 file checked, 0 with errors: 0 errors", self.err)
        self.assertExit(1, "check", "good.apt", "bad.apt")
        self.assertIn("2 files checked, 1 with errors: 2 errors", self.err)
        self.assertIn("bad.apt:2:9: error[E0201]: `P1` is not defined", self.err)
        self.assertEqual(self.out, "")

    def test_standard_input(self):
        self.assertExit(1, "check", "-", stdin=BAD.encode())
        self.assertIn("<stdin>:2:9: error[E0201]", self.err)

    def test_quiet_says_nothing_about_a_good_program(self):
        self.write("good.apt", GOOD)
        self.assertExit(0, "check", "-q", "good.apt")
        self.assertEqual((self.out, self.err), ("", ""))

    def test_max_errors_limits_what_is_shown(self):
        self.write("many.apt", "".join(f"L{i}=LINE/P{i},Q{i}\n" for i in range(50)) + "FINI\n")
        self.assertExit(1, "check", "many.apt", "--diagnostics=gnu", "--max-errors", "3")
        self.assertEqual(self.err.count("error[E0201]"), 3)
        self.assertIn("100 errors in all, the first 3 shown", self.err)


class Messages(ArelemCase):
    def test_json_is_one_object_a_line(self):
        self.write("bad.apt", BAD)
        self.assertExit(1, "check", "bad.apt", "--diagnostics=json")
        first, second = [json.loads(line) for line in self.err.splitlines()]
        self.assertEqual((first["code"], first["legacy"], first["severity"]), ("E0201", "101", "error"))
        self.assertEqual(first["range"]["start"], {"line": 2, "column": 9, "byte": 17, "utf16": 8})
        self.assertEqual(second["range"]["start"]["column"], 12)

    def test_color_obeys_option_and_environment(self):
        self.write("bad.apt", BAD)
        self.run_arelem("check", "bad.apt")
        self.assertNotIn("\033", self.err)
        self.run_arelem("check", "bad.apt", "--color=always")
        self.assertIn("\033[", self.err)
        self.run_arelem("check", "bad.apt", env={"CLICOLOR_FORCE": "1"})
        self.assertIn("\033[", self.err)
        self.run_arelem("check", "bad.apt", env={"CLICOLOR_FORCE": "1", "NO_COLOR": "1"})
        self.assertNotIn("\033", self.err)


    def test_no_minus_zero(self):
        self.write("off.apt", "CUTTER/2\nFROM/0,5,0\nTLLFT,INDIRV/1,0,0\nGOFWD/(LINE/XAXIS),TO,(LINE/20,0,20,5)\nFINI\n")
        self.assertExit(4, "off.apt")
        self.assertIn("outside its tolerance 0 to 0.0005", self.err)


class Geometry(ArelemCase):
    PROGRAM = "P1=POINT/1,2,3\nA=2.5\nRESERV/Q,3\nQ(2)=POINT/A,0\nL1=LINE/(POINT/0,0),P1\nFINI\n"

    def test_json_names_everything_in_order_of_definition(self):
        self.write("a.apt", self.PROGRAM)
        self.assertExit(0, "geometry", "a.apt", "--json")
        rows = json.loads(self.out)
        self.assertEqual([(r["name"], r["subscript"], r["type"], r["n"]) for r in rows],
                         [("P1", 0, "POINT", 3), ("A", 0, "SCALAR", 1), ("Q", 2, "POINT", 3), ("*NESTED*", 0, "POINT", 3), ("L1", 0, "LINE", 4)])
        self.assertEqual(rows[0]["values"], [1, 2, 3])
        self.assertEqual(rows[2]["values"], [2.5, 0, 0])

    def test_text_shows_nested_definitions_too(self):
        self.write("a.apt", self.PROGRAM)
        self.assertExit(0, "geometry", "a.apt")
        self.assertIn("*NESTED*", self.out)
        self.assertRegex(self.out, r"Q\(2\) +POINT +3 +2\.5  0  0")

    def test_a_name_defined_again_has_a_row_each_time(self):
        self.write("a.apt", "CANON/ON\nI=0\nLOOPST\nA)I=I+1\nP=POINT/(POINT/I,0),CANON\nIF(I-3)A,B,B\nB)LOOPND\nFINI\n")
        self.assertExit(0, "geometry", "a.apt", "--json")
        rows = [(r["name"], r["values"][0]) for r in json.loads(self.out)]
        self.assertEqual(rows, [("I", 3), ("*NESTED*", 1), ("P", 1), ("*NESTED*", 2), ("P", 2), ("*NESTED*", 3), ("P", 3)])

    def test_more_definitions_than_the_limit_are_told(self):
        self.write("a.apt", "CANON/ON\nI=0\nLOOPST\nA)I=I+1\nP=POINT/I,0\nIF(I-99)A,B,B\nB)LOOPND\nFINI\n")
        self.assertExit(7, "geometry", "a.apt", "--json", "--max-definitions=50")
        self.assertIn("--max-definitions", self.err)
        self.assertEqual(len(json.loads(self.out)), 50)
        self.assertExit(0, "check", "a.apt", "--max-definitions=50")

    def test_program_with_errors_still_shows_what_is_defined(self):
        self.write("a.apt", "P1=POINT/1,2,3\nL1=LINE/P1,P1\nFINI\n")
        self.assertExit(4, "geometry", "a.apt", "--json")
        self.assertEqual([r["name"] for r in json.loads(self.out)], ["P1"])


class Explain(ArelemCase):
    def test_by_code_name_and_old_number(self):
        for word in ("E0201", "e0201", "UndefinedSymbol"):
            self.assertExit(0, "explain", word)
            self.assertIn("E0201", self.out)
        self.assertExit(0, "explain", "101")
        self.assertIn("E0201", self.out)

    def test_unknown_code(self):
        self.assertExit(0, "explain", "1005")  # shared by many: a line each, not their pages
        self.assertRegex(self.out, r"(?m)^E0315  \S")
        self.assertIn("`arelem explain E03", self.out)
        self.assertNotIn("# E0315", self.out)
        self.assertExit(2, "explain", "E9999")
        self.assertExit(2, "explain")

    def test_old_numbers_in_every_spelling(self):
        for words in (("1601",), ("-1601",), ("01601",)):
            self.assertExit(0, "explain", *words)
            self.assertTrue(self.out.startswith("# W0501"), self.out)
        for number in ("724", "+724", "00724"):
            self.assertExit(0, "explain", number)
            self.assertRegex(self.out, r"(?m)^E0508  \S")

    def test_list_has_every_row_once(self):
        self.assertExit(0, "explain", "--list")
        codes = [line.split()[0] for line in self.out.splitlines()]
        self.assertEqual(len(codes), len(set(codes)))
        self.assertIn("E0301", codes)


class Language(ArelemCase):
    def test_words_within_statements_are_found(self):
        for word in ("TO", "ON", "PAST", "TANTO", "DSTAN", "PSTAN", "INTOF", "TLLFT", "TLRGT", "TLON", "TLNDON", "TLONPS", "TLOFPS",
                     "NOPS", "AUTOPS", "DNTCUT", "CUT", "NORMPS", "NORMDS", "PARLEL", "ATANGL", "CUTANG"):
            self.assertExit(0, "language", word)
            self.assertIn(word, self.out)
            self.assertNotIn("has no form of its own", self.out)
        self.assertExit(0, "language", "PSTAN")
        self.assertRegex(self.out, r"(?m)^ +GOFWD/ .*PSTAN")
        self.assertRegex(self.out, r"(?m)^motion.md: .* PSTAN where ps and cs touch")


class Targets(ArelemCase):
    def test_lists_names_and_suffixes(self):
        self.assertExit(0, "targets")
        for name in ("cl", "cltape", "json"):
            self.assertRegex(self.out, rf"(?m)^{name} +\.")


if __name__ == "__main__":
    unittest.main()
