"""What the end-to-end tests have in common: running the command in a folder of its own."""
import os
import pathlib
import subprocess
import tempfile
import unittest

PROJECT = pathlib.Path(__file__).resolve().parents[2]
ARELEM = os.environ.get("ARELEM", str(PROJECT / "build" / "arelem"))
FAULTS = os.environ.get("ARELEM_FAULTS", str(PROJECT / "build" / "libfaults.so"))

GOOD = "PARTNO T\nCUTTER/1\nFROM/0,0,0\nGOTO/1,2,3\nFINI\n"
BAD = "PARTNO T\nL1=LINE/P1,P2\nFINI\n"
ENDLESS = "LOOPST\nA)JUMPTO/A\nLOOPND\nFINI\n"


class ArelemCase(unittest.TestCase):
    """Each test has an empty current folder, removed afterwards."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    def run_arelem(self, *words, stdin=b"", env=None, preexec=None, stdout=subprocess.PIPE, timeout=60):
        clean = {k: v for k, v in os.environ.items() if k not in ("NO_COLOR", "CLICOLOR_FORCE")}
        done = subprocess.run([ARELEM, *map(str, words)], cwd=self.folder, input=stdin, stdout=stdout,
                              stderr=subprocess.PIPE, env={**clean, **(env or {})}, preexec_fn=preexec, timeout=timeout)
        self.out = (done.stdout or b"").decode(errors="replace")
        self.err = done.stderr.decode(errors="replace")
        return done.returncode

    def assertExit(self, code, *words, **how):
        self.assertEqual(self.run_arelem(*words, **how), code, f"arelem {words}\nstdout: {self.out}\nstderr: {self.err}")

    def files(self):
        return sorted(str(p.relative_to(self.folder)) for p in self.folder.rglob("*"))
