"""The README's first program is the example, and its picture is what arelem draws."""
import re
import unittest

from arelem_run import PROJECT, ArelemCase


class Readme(ArelemCase):
    def test_program_and_picture_are_current(self):
        readme = (PROJECT / "README.md").read_text()
        program = re.search(r"```\n(.*?)```", readme, re.S).group(1)
        self.assertEqual(program, (PROJECT / "examples" / "six_lines.apt").read_text())
        self.assertEqual(len(program.splitlines()), 6)
        self.write("six_lines.apt", program)
        self.assertExit(0, "six_lines.apt", "-o", "six_lines.svg")
        self.assertEqual((self.folder / "six_lines.svg").read_text(),
                         (PROJECT / "docs" / "pictures" / "six_lines.svg").read_text(),
                         "make it again: build/arelem examples/six_lines.apt -o docs/pictures/six_lines.svg")

    def test_every_link_of_the_readme_leads_somewhere(self):
        for target in re.findall(r"\]\(([^)#]+)\)", (PROJECT / "README.md").read_text()):
            self.assertTrue((PROJECT / target).exists(), target)


if __name__ == "__main__":
    unittest.main()
