"""The interpreter of LinuxCNC as a judge of RS-274 outputs.

Its two Debian packages are unpacked into a folder of the build tree; nothing is installed. Where they cannot be had, the
tests that need them are skipped, and say so; with ARELEM_REQUIRE_RS274, which CI sets, they fail.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

REQUIRED = "ARELEM_REQUIRE_RS274"

PACKAGE = "linuxcnc-uspace"
CALL = re.compile(r"^\s*\d+ \S+\s+([A-Z_0-9]+)\((.*)\)\s*$")


class Unavailable(Exception):
    """Why there is no interpreter."""


def _packages():
    """The package and the library of it that a small system lacks, whose name has a version."""
    told = subprocess.run(["apt-cache", "depends", PACKAGE], capture_output=True, text=True, timeout=120).stdout
    return [PACKAGE, *sorted(set(re.findall(r"Depends: (libboost-python[\d.]+)", told)))]


def _download(folder):
    """The error text, "" when all is there."""
    packages = _packages()
    done = subprocess.run(["apt-get", "download", *packages], cwd=folder, capture_output=True, text=True, timeout=600)
    complete = done.returncode == 0 and len(packages) > 1 and len(list(folder.glob("*.deb"))) >= len(packages)
    return "" if complete else f"apt-get download {' '.join(packages)} failed: {done.stderr.strip()[-200:]}"


def _unpack(folder):
    marker = folder / "complete"
    if marker.exists():
        return
    folder.mkdir(parents=True, exist_ok=True)
    for tool in ("apt-get", "apt-cache", "dpkg"):
        if shutil.which(tool) is None:
            raise Unavailable(f"no {tool} here to fetch {PACKAGE}")
    trouble = _download(folder)
    if trouble and os.geteuid() == 0:  # a new system has no lists of packages yet
        subprocess.run(["apt-get", "update", "-qq"], capture_output=True, timeout=600)
        trouble = _download(folder)
    if trouble:
        raise Unavailable(trouble)
    for archive in sorted(folder.glob("*.deb")):
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
        tools.write_text("".join(f"T{n} P{n} Z0 D{3 if n < 31 else 0}\n" for n in range(1, 32)))
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


def judge(build):
    """The interpreter. Without one: unittest.SkipTest, or Unavailable where it is required."""
    try:
        return Interpreter(build)
    except Unavailable as why:
        if os.environ.get(REQUIRED):
            raise
        print(f"SKIPPED: no RS-274 interpreter: {why}", file=sys.stderr)
        raise unittest.SkipTest(str(why)) from why
