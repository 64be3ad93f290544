"""A bar appears on a terminal after a second; nothing is ever written for what is quick, or to a file."""

from __future__ import annotations

import os
import pty
import subprocess
import sys

from tests.architecture.source import ROOT

CODE = """
import time
import rich.progress  # a busy machine takes longer to load it than the bar would be seen
from rbpsym.commands import progress
progress.PATIENCE = 0.1
with progress.Progress("first", 2) as bar:
    bar.step("ladder")
    time.sleep({pause})
    bar.step("pendulum")
    time.sleep({pause})
"""


def on_terminal(pause: float) -> str:
    """What is written to a terminal on stderr."""
    ours, theirs = pty.openpty()
    command = [sys.executable, "-c", CODE.format(pause=pause)]
    environment = {**os.environ, "TERM": "xterm", "PYTHONPATH": str(ROOT)}
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=theirs, env=environment) as running:
        os.close(theirs)
        told = b""
        while piece := _read(ours):
            told += piece
        assert running.stdout.read() == b""
    os.close(ours)
    assert running.returncode == 0
    return told.decode()


def _read(handle: int) -> bytes:
    try:
        return os.read(handle, 4096)
    except OSError:  # the other end is closed
        return b""


def test_what_is_slow_shows_a_bar() -> None:
    told = on_terminal(0.8)
    assert "ladder" in told and "pendulum" in told


def test_what_is_quick_shows_nothing() -> None:
    assert on_terminal(0.0) == ""


def test_a_file_gets_nothing() -> None:
    done = subprocess.run([sys.executable, "-c", CODE.format(pause=0.3)], capture_output=True, cwd=ROOT, check=True)
    assert done.stdout + done.stderr == b""
