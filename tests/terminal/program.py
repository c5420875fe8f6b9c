"""Runs wristwise as these tests need it: in a pipe, on a pseudo terminal, in a folder of its own."""

import fcntl
import os
import pathlib
import pty
import re
import select
import shutil
import signal
import struct
import subprocess
import tempfile
import termios
import time
import unittest

PROGRAM = os.environ["WRISTWISE_PROGRAM"]
SOURCE = pathlib.Path(os.environ["WRISTWISE_SOURCE_DIR"])
ESCAPE = re.compile(rb"\x1b\[[0-9;]*[A-Za-z]")
COLOUR = re.compile(rb"\x1b\[[0-9;]*m")
CLEAR_LINE = b"\r\x1b[K"


def environment(**changes):
    env = {key: value for key, value in os.environ.items() if key not in ("NO_COLOR", "TERM")}
    env["TERM"] = "xterm"
    for key, value in changes.items():
        env.pop(key, None)
        if value is not None:
            env[key] = value
    return env


def run(arguments, folder, **changes):
    """In pipes: exit status, stdout and stderr."""
    done = subprocess.run([PROGRAM, *arguments], cwd=folder, env=environment(**changes),
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=300)
    return done.returncode, done.stdout, done.stderr


def run_on_terminal(arguments, folder, columns=80, stdout=True, stderr=True, signals=(),
                    resize=None, **changes):
    """With stdout and stderr, or one of them, on a terminal. `signals`: pairs of seconds and signal.
    `resize`: seconds and the columns from then on. Returns the exit status and what was written to
    the terminal."""
    master, slave = pty.openpty()

    def set_columns(count):
        fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 25, count, 0, 0))

    set_columns(columns)
    null = open(os.devnull, "wb")
    process = subprocess.Popen([PROGRAM, *arguments], cwd=folder, env=environment(**changes),
                               stdin=slave, stdout=slave if stdout else null,
                               stderr=slave if stderr else null, start_new_session=True)
    todo = [(at, lambda number=number: process.send_signal(number)) for at, number in signals]
    if resize:
        todo.append((resize[0], lambda: set_columns(resize[1])))
    start, written = time.monotonic(), b""
    deadline = start + 300
    while True:
        for entry in [entry for entry in todo if time.monotonic() - start >= entry[0]]:
            if process.poll() is None:
                entry[1]()
            todo.remove(entry)
        ready, _, _ = select.select([master], [], [], 0.02)
        if ready:
            written += os.read(master, 65536)
        elif process.poll() is not None:
            break
        if time.monotonic() > deadline:
            process.send_signal(signal.SIGKILL)
            raise AssertionError("it does not end: " + " ".join(arguments))
    null.close()
    os.close(slave)
    os.close(master)
    return process.returncode, written


def screen(written):
    """The lines that are seen in the end, on a terminal that is wide enough."""
    lines, current, column = [], [], 0
    text = COLOUR.sub(b"", written).decode()
    while text:
        if text.startswith("\x1b[K"):
            del current[column:]
            text = text[3:]
            continue
        character, text = text[0], text[1:]
        if character == "\n":
            lines.append("".join(current))
            current, column = [], 0
        elif character == "\r":
            column = 0
        else:
            current[column:column + 1] = [character]
            column += 1
    return lines + ["".join(current)]


class ProgramTest(unittest.TestCase):
    """In a folder of its own with copies of problems/ and robots/."""

    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self._folder.name)
        for name in ("problems", "robots"):
            shutil.copytree(SOURCE / name, self.folder / name,
                            ignore=shutil.ignore_patterns(".wristwise_cache"))

    def tearDown(self):
        self._folder.cleanup()
