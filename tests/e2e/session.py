"""Starts the real programs for end-to-end tests, and ends them whatever happens. Python's standard library only."""
import contextlib
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SERVER = os.environ.get("COHERENCY_SERVER", ROOT / "build/release/motion_server/motion_server")
CLIENT = os.environ.get("COHERENCY_CLIENT", ROOT / "build/release/render_client/render_client")
MOTION_DATA = pathlib.Path(os.environ.get("COHERENCY_MOTION_DATA", ROOT.parent / "shared/data/motion"))
sys.path.insert(0, str(ROOT / "scripts"))


class Process:
    """One program, its stderr kept in a file."""

    def __init__(self, arguments, log, prefix=()):
        self.log = log
        environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
        with open(log, "wb") as stderr:
            self.process = subprocess.Popen([*prefix, *map(str, arguments)], stdout=stderr, stderr=stderr,
                                            env=environment)

    def text(self):
        return self.log.read_text(errors="replace")

    def wait(self, timeout):
        return self.process.wait(timeout)

    def running(self):
        return self.process.poll() is None

    def end(self, how=signal.SIGTERM):
        if self.running():
            self.process.send_signal(how)
            try:
                self.process.wait(10)
            except subprocess.TimeoutExpired:
                self.process.kill()
                self.process.wait()
        return self.process.returncode


class SessionTest(unittest.TestCase):
    """A folder for files, and programs that end with the test."""

    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory(prefix="coherency_")))
        self.started = []
        self.addCleanup(lambda: [p.end() for p in reversed(self.started)])

    def start(self, name, *arguments, prefix=()):
        process = Process(arguments, self.folder / f"{name}.log", prefix)
        self.started.append(process)
        return process

    def server(self, *arguments, config="laboratory", listen="127.0.0.1:0", name="server"):
        """(process, ADDRESS:PORT) once it listens."""
        process = self.start(name, SERVER, "--config", ROOT / f"configs/servers/{config}.toml", "--listen", listen,
                             "--stats-json", self.folder / f"{name}.json", "--duration", "150", *arguments)
        found = self.until(lambda: re.search(r"^listening on (\S+)", process.text(), re.M), 10, process)
        return process, found.group(1)

    def client(self, address, eye, *arguments, name=None):
        name = name or eye
        return self.start(name, CLIENT, "--server", address, "--eye", eye, "--display", "headless", "--stats-json",
                          self.folder / f"{name}.json", *arguments)

    def stats(self, name):
        with contextlib.suppress(OSError, ValueError):
            return json.loads((self.folder / f"{name}.json").read_text())
        return None

    def until(self, condition, seconds, process=None):
        """Waits for a condition of the outside world; fails with the process's words when it does not come."""
        deadline = time.monotonic() + seconds
        while time.monotonic() < deadline:
            value = condition()
            if value:
                return value
            if process is not None and not process.running():
                break
            time.sleep(0.02)
        self.fail(f"did not happen within {seconds} s: {process.text() if process else condition}")

    def assertEnds(self, process, code, seconds=30):
        self.assertEqual(process.wait(seconds), code, process.text())
