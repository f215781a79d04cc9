"""`arelem repl` at a terminal: the editor in a pseudo terminal."""
import fcntl
import os
import pty
import re
import resource
import select
import signal
import struct
import termios
import time
import unittest

from arelem_run import ARELEM, ArelemCase


class Terminal(ArelemCase):
    """The editor in a pseudo terminal."""

    pid = 0
    tty = -1

    def start(self, columns=80, env=None, limit=None, words=()):
        self.end()
        pid, self.tty = pty.fork()
        if pid == 0:
            os.chdir(self.folder)
            clean = {"PATH": os.environ["PATH"], "TERM": "xterm", "HOME": str(self.folder), "NO_COLOR": "1"}
            if limit is not None:
                signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
                resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
            os.execve(ARELEM, ["arelem", "repl", *words], {**clean, **(env or {})})
        fcntl.ioctl(self.tty, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
        self.pid = pid
        self.seen = ""
        self.addCleanup(self.end)

    def end(self):
        if self.pid:  # 0 would be this process and its family
            os.kill(self.pid, signal.SIGKILL)
            os.waitpid(self.pid, 0)
            self.pid = 0
        if self.tty >= 0:
            os.close(self.tty)
            self.tty = -1

    def shown(self, text):
        return text

    def send(self, text):
        os.write(self.tty, text.encode())

    def expect(self, pattern, seconds=20):
        end = time.monotonic() + seconds
        while not re.search(pattern, self.seen):
            ready, _, _ = select.select([self.tty], [], [], max(0, end - time.monotonic()))
            if not ready:
                self.fail(f"no {pattern!r} in {self.seen!r}")
            try:
                got = os.read(self.tty, 65536)
            except OSError:
                got = b""
            if not got:
                self.fail(f"ended before {pattern!r}: {self.seen!r}")
            self.seen = self.shown(self.seen + got.decode(errors="replace"))
        at = re.search(pattern, self.seen)
        text, self.seen = self.seen[:at.end()], self.seen[at.end():]
        return text

    def comes(self, pattern, seconds):
        """Whether it is seen within a time; it stays to be expected."""
        end = time.monotonic() + seconds
        while not re.search(pattern, self.seen) and time.monotonic() < end:
            if select.select([self.tty], [], [], max(0, end - time.monotonic()))[0]:
                self.seen = self.shown(self.seen + os.read(self.tty, 65536).decode(errors="replace"))
        return re.search(pattern, self.seen) is not None

    def tell(self, line, pattern, prompt=r"> "):
        """Types a line, and waits for an answer and the next prompt."""
        self.send(line + "\r")
        text = self.expect(pattern)
        self.expect(prompt)
        return text

    def exit_code(self):
        """Ends it as a user does. To be called at a prompt: while the terminal is not the editor's,
        an end of input is the terminal's own affair and the editor never sees it."""
        asked, deadline = 0.0, time.monotonic() + 30
        while time.monotonic() < deadline:
            if time.monotonic() > asked + 2:  # one that came between two prompts is lost
                asked = time.monotonic()
                try:
                    self.send("\x04")
                except OSError:
                    pass
            done, status = os.waitpid(self.pid, os.WNOHANG)
            if done:
                self.pid = 0
                return os.waitstatus_to_exitcode(status)
            ready, _, _ = select.select([self.tty], [], [], 0.05)
            try:
                self.seen += os.read(self.tty, 65536).decode(errors="replace") if ready else ""
            except OSError:
                pass
        self.fail("it does not end")

    def test_prompt_answer_and_end(self):
        self.start()
        self.expect(r"apt\(units\)> ")
        self.send("UNITS/MM\r")
        self.expect(r"apt\(mm\)> ")
        self.send("P1=POINT/1,2\r")
        self.expect(r"P1 = POINT  \(1, 2, 0\)")
        self.send("M=MACRO/A\r")
        self.expect(r"\.\.\. ")
        self.assertEqual(self.exit_code(), 0)

    def test_completion_offers_only_what_may_follow(self):
        self.start()
        self.expect(r"> ")
        self.send("P1=POINT/1,2\rP2=POINT/3,4\r")
        self.expect(r"P2 = POINT  ")
        self.expect(r"> ")
        self.send("C1=CIRCLE/CENTER,P1,RAD\t5\r")   # RADIUS is the only word
        self.expect(r"RADIUS")
        self.send("\x15C1=CIRCLE/CENTER,P1,RADIUS,5\r")
        self.expect(r"C1 = CIRCLE  center \(1, 2\)  radius 5")
        self.expect(r"> ")
        self.send("L1=LINE/P1,\t\t")                # LEFT and RIGHT with TANTO, points, ...; but never CENTER
        listed = self.expect(r"TANTO|SLOPE")
        self.assertNotIn("CENTER", listed)
        self.send("\x15GO\t\t")
        self.expect(r"GOFWD/")
        self.send("\x15:dis\tP1,P2\r")              # the command is complete, and a blank with it
        self.expect(r"2\.82842")
        self.expect(r"> ")
        self.send(":help verif\t\r")              # pages and commands too, in small letters
        self.expect(r"The certificate of a path")
        self.expect(r"> ")
        self.send(":list po\t\t")                 # types, not every word of the language
        self.assertNotIn("POSTN", self.expect(r"POLCON"))
        self.send("\x15A1=SQ\t16)\r")             # SQRTF( without a blank
        self.expect(r"A1=SQRTF\(16\)")
        self.expect(r"A1 = 4\b")

    def test_interrupt_cancels_the_line_and_the_computation(self):
        self.start()
        self.expect(r"> ")
        self.send("P1=POINT/1,")
        self.expect(r"P1=POINT/1,")
        self.send("\x03")
        self.expect(r"> ")
        self.send("A=5\r")
        self.expect(r"A = 5")
        self.expect(r"> ")
        self.send("LOOPST\rB) X=1\rJUMPTO/B\rLOOPND\r")
        self.expect(r"LOOPND\r*\n")
        # When the computation has begun is not seen: a signal between the line and it counts for neither.
        for _ in range(100):
            os.kill(self.pid, signal.SIGINT)
            if self.comes(r"interrupted", 0.2):
                break
        self.expect(r"interrupted")
        self.expect(r"> ")
        for _ in range(20):  # a signal too many may still be under way, and would cancel the line
            self.send("A+1\r")
            if self.comes(r"ANS\d+ = 6", 1):
                break
        self.expect(r"ANS\d+ = 6")
        self.expect(r"> ")
        self.assertEqual(self.exit_code(), 0)

    def test_many_candidates_are_listed_without_a_question(self):
        self.start()
        self.expect(r"> ")
        self.send("\t\t")                     # more than a screen of words
        seen = self.expect(r"TRACUT[\s\S]*> ")  # a late one of them, then the line again
        self.assertNotIn("Display all", seen)
        self.assertNotIn("More", seen)
        self.send("\x03")
        self.expect(r"> ")
        self.send("A=41+1\r")
        self.expect(r"A = 42")

    def test_end_of_input_in_an_open_macro_drops_the_macro(self):
        self.start()
        self.expect(r"> ")
        self.tell("A=5", r"A = 5")
        self.send("M=MACRO/Q\r")
        self.expect(r"\.\.\. ")
        self.send("\x04")
        self.expect(r"the open statements are dropped")
        self.expect(r"> ")
        self.tell("A+1", r"ANS1 = 6")
        self.assertEqual(self.exit_code(), 0)

    def test_history_is_kept(self):
        self.start()
        self.expect(r"> ")
        self.send("P1=POINT/7,8\r")
        self.expect(r"P1 = POINT")
        self.expect(r"> ")
        self.assertEqual(self.exit_code(), 0)
        history = self.folder / ".local/state/arelem/history"
        self.assertEqual(history.read_text(), "P1=POINT/7,8\n")
        self.start()
        self.expect(r"> ")
        self.send("\x1b[A\r")  # arrow up
        self.expect(r"P1 = POINT  \(7, 8, 0\)")

    def test_history_on_a_full_disk(self):
        self.start(limit=4)
        self.expect(r"> ")
        self.send("P1=POINT/7,8\rP2=POINT/9,9\r")
        self.expect(r"P2 = POINT")
        self.expect(r"> ")
        self.send("\x04")
        self.expect(r"history file .* cannot be kept: .*goes on without it")

    def test_history_in_a_place_that_is_a_file(self):
        self.write("state", "a file")
        self.start(env={"XDG_STATE_HOME": str(self.folder / "state")})
        self.expect(r"cannot be kept")
        self.expect(r"> ")
        self.send("A=1\r")
        self.expect(r"A = 1")

    def test_one_column(self):
        self.start(columns=1)
        self.expect(r">")
        self.send("A=41+1\r")
        self.expect(r"A = 42")
        self.expect(r">")
        self.assertEqual(self.exit_code(), 0)

    def test_dumb_terminal(self):
        self.start(env={"TERM": "dumb"})
        self.expect(r"> ")
        self.send("A=41+1\r")
        seen = self.expect(r"A = 42")
        self.assertNotIn("\x1b[", seen)
        self.expect(r"> ")
        self.send(":plot a.png\r")
        self.expect(r"writes .svg only")

    def test_termination(self):
        self.start()
        self.expect(r"> ")
        os.kill(self.pid, signal.SIGTERM)
        _, status = os.waitpid(self.pid, 0)
        self.pid = 0
        self.assertEqual(os.waitstatus_to_exitcode(status), 143)

    def test_every_command_at_a_terminal(self):
        self.write("p.apt", "UNITS/MM\nCUTTER/2\nFEDRAT/60\nP1=POINT/1,1\nFROM/P1\nGOTO/31,1\nGOTO/31,41\nFINI\n")
        self.start()
        self.expect(r"> ")
        self.tell(":load p.apt", r"p\.apt: 1 name, 3 motions", r"apt\(mm\)> ")
        self.tell(":list", r"P1 = POINT")
        self.tell(":show P1", r"line 4: P1=POINT/1,1")
        self.tell("P2=POINT/4,5", r"P2 = POINT  \(4, 5, 0\)")
        self.tell(":distance P1,P2", r"(?m)\b5\b")
        self.tell(":why P2", r"the form has no choice")
        self.tell(":step", r"GOTO|FROM")
        self.tell(":step 2", r"to \(31, 41, 0\)")
        self.tell(":step", r"that was the last motion")
        self.tell(":step reset", r"before the first motion")
        self.tell(":time", r"in all: cutting 70\.\d+")         # 30 and 40 mm at 60 mm/min
        self.tell(":set digits 3", r"digits 3")
        self.tell("1/3", r"ANS1 = 0\.333\b")
        self.tell(":set", r"velocity      400")
        self.tell(":undo 2", r"2 entries taken back")
        self.tell("P2", r"E0\d+")                              # it is gone
        self.tell(":redo", r"1 entry brought again")
        self.tell("P2", r"P2 = POINT  \(4, 5, 0\)")
        self.tell(":plot a.svg", r"a\.svg  \d+ bytes")
        self.tell(":view a.html", r"a\.html")
        self.tell(":save b.apt", r"saved as b\.apt")
        self.assertIn("GOTO/31,41\nP2=POINT/4,5\nFINI\n", (self.folder / "b.apt").read_text())
        self.assertIn("<svg", (self.folder / "a.svg").read_text())
        self.assertIn("<html", (self.folder / "a.html").read_text())
        self.tell(":help topics", r"smoothing")
        self.tell(":load b.apt", r"b\.apt: 2 names, 3 motions")
        self.send(":quit\r")
        _, status = os.waitpid(self.pid, 0)
        self.pid = 0
        self.assertEqual(os.waitstatus_to_exitcode(status), 0)

    def test_a_long_line_is_edited_like_a_short_one(self):
        self.start(columns=40, env={"NO_COLOR": "", "CLICOLOR_FORCE": "1"})
        self.expect(r"> ")
        self.send("P1=POINT/1,2,3+4+5+6+7+8+9+10+11+12+13+14+15\x01\x1b[C\x7fQ\r")  # P becomes Q, at the beginning
        self.expect(r"Q1.*POINT.*\(1, 2, 117\)")                                     # 3 + ... + 15
        self.expect(r"> ")
        self.send("A=7\r")
        self.expect(r"A.* = 7")

    def test_the_typed_line_has_colors(self):
        self.start(env={"NO_COLOR": "", "CLICOLOR_FORCE": "1"})
        self.expect(r"> ")
        self.send("L1=LINE/0,0,1,0\r")
        self.expect(r"L1=\x1b\[1;34mLINE\x1b\[0m/\x1b\[33m0\x1b\[0m")
        self.expect(r"L1.* = ")
        self.send("P1=POINT/XLARGE,INTOF,L1,(CIRCLE/0,0,2) $$ right\r")
        typed = self.expect(r"P1\S* = ")
        self.assertIn("\x1b[34mXLARGE\x1b[0m,\x1b[34mINTOF\x1b[0m,\x1b[36mL1\x1b[0m", typed)  # L1 is known
        self.assertIn("\x1b[2m$$ right\x1b[0m", typed)
        self.expect(r"> ")
        self.send(":set color off\r")
        self.expect(r"color off")
        self.send("L1\r")
        self.assertNotIn("\x1b[36m", self.expect(r"L1 = LINE"))
        self.expect(r"> ")
        self.assertEqual(self.exit_code(), 0)

    def test_colors(self):
        self.start(env={"NO_COLOR": "", "CLICOLOR_FORCE": "1"})
        self.expect(r"\x1b\[1;32m")
        self.send("P1=POINT/7,8\r")
        self.expect(r"\x1b\[1;36mP1\x1b\[0m = \x1b\[35mPOINT")


class Colored(Terminal):
    """The same with the line that is drawn in colors. What is seen is looked at without them."""

    def start(self, **how):
        super().start(**{**how, "env": {"NO_COLOR": "", "CLICOLOR_FORCE": "1", **(how.get("env") or {})}})

    def shown(self, text):
        return re.sub(r"\x1b\[[0-9;?]*[A-Za-z]", "", text)

    test_colors = test_the_typed_line_has_colors = None  # they look at the codes


if __name__ == "__main__":
    unittest.main()
