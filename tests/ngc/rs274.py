"""The interpreter of LinuxCNC as a judge of RS-274 outputs.

Its two Debian packages are unpacked into a folder of the build tree; nothing is installed. Where they cannot be had, the
tests that need them are skipped, and say so.
"""
import os
import pathlib
import re
import shutil
import subprocess

PACKAGES = ("linuxcnc-uspace", "libboost-python1.74.0")
CALL = re.compile(r"^\s*\d+ \S+\s+([A-Z_0-9]+)\((.*)\)\s*$")


class Unavailable(Exception):
    """Why there is no interpreter."""


def _unpack(folder):
    marker = folder / "complete"
    if marker.exists():
        return
    folder.mkdir(parents=True, exist_ok=True)
    for tool in ("apt-get", "dpkg"):
        if shutil.which(tool) is None:
            raise Unavailable(f"no {tool} here to fetch {' '.join(PACKAGES)}")
    done = subprocess.run(["apt-get", "download", *PACKAGES], cwd=folder, capture_output=True, text=True, timeout=600)
    archives = sorted(folder.glob("*.deb"))
    if done.returncode or len(archives) < len(PACKAGES):
        raise Unavailable(f"apt-get download {' '.join(PACKAGES)} failed: {done.stderr.strip()[-200:]}")
    for archive in archives:
        subprocess.run(["dpkg", "-x", archive, folder / "root"], check=True, timeout=300)
        archive.unlink()
    marker.touch()


class Interpreter:
    """Runs programs and gives their canonical calls."""

    def __init__(self, build):
        self.env = dict(os.environ)
        self.program = shutil.which("rs274")
        if self.program is None:
            folder = pathlib.Path(build) / "rs274"
            _unpack(folder)
            root = folder / "root" / "usr"
            self.program = str(root / "bin" / "rs274")
            libraries = [root / "lib", *(root / "lib").glob("*-linux-gnu")]
            self.env["LD_LIBRARY_PATH"] = ":".join(map(str, libraries))

    def run(self, program, folder):
        """(canonical calls as (name, [arguments]), error text or "")."""
        tools = pathlib.Path(folder) / "tool.tbl"
        tools.write_text("".join(f"T{n} P{n} Z0 D3\n" for n in range(1, 31)))
        done = subprocess.run([self.program, "-g", "-t", str(tools), str(program)], cwd=folder, env=self.env,
                              capture_output=True, text=True, timeout=300)
        if "error while loading" in done.stderr:
            raise Unavailable(done.stderr.strip())
        calls = []
        for line in done.stdout.splitlines():
            found = CALL.match(line)
            if found:
                calls.append((found[1], [a.strip() for a in found[2].split(",")]))
        error = "" if done.returncode == 0 else (done.stderr + done.stdout[-300:]).strip()
        return calls, error
