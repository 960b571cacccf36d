#!/usr/bin/env python3
"""The eyes in a real window under a virtual X display, with keys pressed."""
import os
import shutil
import struct
import subprocess
import sys
import unittest

from session import CLIENT, SessionTest
from coherency_check import picture_faults, read_png


class Window(SessionTest):
    def setUp(self):
        super().setUp()
        read, write = os.pipe()
        xvfb = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "1400x700x24", "-nolisten", "tcp",
                                 "-fbdir", str(self.folder)],
                                pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        self.addCleanup(lambda: (xvfb.terminate(), xvfb.wait()))
        with os.fdopen(read) as number:
            self.display = ":" + number.readline().strip()
        os.environ["XDG_RUNTIME_DIR"] = str(self.folder)

    def window(self, name, address, *arguments):
        return self.start(name, CLIENT, "--server", address, "--display", "window", "--stats-json",
                          self.folder / f"{name}.json", "--snapshot-dir", self.folder, *arguments,
                          prefix=["env", f"DISPLAY={self.display}"])

    def text_brightness(self):
        """Mean brightness of the screen where the left eye has its text, beside a short line of it, from Xvfb's own frame buffer (XWD format)."""
        data = (self.folder / "Xvfb_screen0").read_bytes()
        header, line, colours = (struct.unpack_from(">I", data, at)[0] for at in (0, 48, 76))
        pixels = data[header + 12 * colours:]
        environment = dict(os.environ, DISPLAY=self.display)
        found = subprocess.run(["xdotool", "search", "--name", "Coherency", "getwindowgeometry", "--shell"],
                               env=environment, capture_output=True, text=True, check=True).stdout
        at = dict(entry.split("=") for entry in found.split() if "=" in entry)
        x, y = max(int(at["X"]), 0), max(int(at["Y"]), 0)
        rows = [pixels[(y + dy) * line + 4 * (x + 240):(y + dy) * line + 4 * (x + 340)] for dy in range(57, 68)]
        return sum(sum(row) for row in rows) / sum(len(row) for row in rows)

    def key(self, name):
        environment = dict(os.environ, DISPLAY=self.display)
        found = subprocess.run(["xdotool", "search", "--name", "Coherency"], env=environment, capture_output=True,
                               text=True, check=True).stdout.split()
        subprocess.run(["xdotool", "windowfocus", "--sync", found[0], "key", name], env=environment, check=True,
                       timeout=10)

    def test_keys(self):
        _, address = self.server()
        client = self.window("both", address, "--eye", "both", "--size", "480x360")
        self.until(lambda: (s := self.stats("both")) and s["frames"] > 10, 20, client)
        before = self.text_brightness()
        self.key("F1")
        self.until(lambda: self.text_brightness() < 0.8 * before, 5, client)  # the statistics' dark backing
        self.key("F2")
        snapshot = self.folder / "both_001.png"
        self.until(lambda: snapshot.exists() and snapshot.read_bytes().endswith(b"IEND\xaeB`\x82"), 10, client)
        width, height, rows, text = read_png(snapshot)
        self.assertEqual((width, height), (960, 360))
        self.assertEqual(list(picture_faults("both_001", rows)), [])
        self.assertEqual(text["scene"], "laboratory")
        self.assertEqual(self.stats("server")["mode"], "operator")
        self.key("F3")
        self.until(lambda: self.stats("server")["mode"] == "robot", 5, client)
        self.key("Escape")
        self.assertEnds(client, 0, 10)

    def test_fullscreen_on_a_chosen_monitor(self):
        _, address = self.server()
        client = self.window("mono", address, "--eye", "mono", "--fullscreen", "--monitor", "0", "--duration", "4")
        self.assertEnds(client, 0, 20)
        self.assertEqual(self.stats("mono")["size"], [1400, 700])

    def test_a_monitor_that_is_not_there(self):
        _, address = self.server()
        client = self.window("left", address, "--eye", "left", "--fullscreen", "--monitor", "7")
        self.assertEnds(client, 1, 20)
        self.assertIn("1400x700", client.text())


if __name__ == "__main__":
    for tool in ("Xvfb", "xdotool"):
        if not shutil.which(tool):
            print(f"skipped: {tool} is not installed")
            sys.exit(77)
    unittest.main(verbosity=2)
