"""An installed binary finds its library, wherever the folder is moved to, and explains without any file."""
import os
import pathlib
import shutil
import subprocess
import unittest

import arelem_run
from arelem_run import ArelemCase

BUILD = pathlib.Path(arelem_run.ARELEM).parent


@unittest.skipUnless((BUILD / "cmake_install.cmake").exists() and shutil.which("cmake"), "not a build folder")
class Install(ArelemCase):
    def test_moved_installation_works(self):
        prefix = self.folder / "first"
        subprocess.run(["cmake", "--install", BUILD, "--prefix", prefix], check=True, capture_output=True)
        moved = self.folder / "second place"
        os.rename(prefix, moved)
        binary = moved / "bin" / "arelem"
        self.assertTrue((moved / "share" / "doc" / "arelem" / "manual" / "cli.md").exists())
        program = self.write("a.apt", "LIBRY/TLEND\nFROM/0,0,0\nGOTO/1,2,3\nCALL/TLEND\nFINI\n")
        done = subprocess.run([binary, "check", program], capture_output=True, text=True, cwd=self.folder)
        self.assertNotIn("E0242", done.stderr)
        moved_far = self.write("b.apt", "UNITS/MM\nFROM/0,0,500\nRAPID\nGOTO/1,0,500\nFINI\n")
        painted = subprocess.run([binary, moved_far, "-o", "a.lng", "--machine", "g97_painter.machine.toml"],
                                 capture_output=True, text=True, cwd=self.folder)
        self.assertEqual(painted.returncode, 0, painted.stderr)
        explained = subprocess.run([binary, "explain", "E0201"], capture_output=True, text=True, cwd="/")
        self.assertIn("# E0201", explained.stdout)


if __name__ == "__main__":
    unittest.main()
