#!/usr/bin/env python3
"""What an eye leaves behind on displays with lenses and on screens: snapshots of either kind, and films."""
import os
import shutil
import subprocess
import unittest

from session import CLIENT, SessionTest
from coherency_check import read_png


class Displays(SessionTest):
    def setUp(self):
        super().setUp()
        _, self.address = self.server()

    def picture(self, *arguments):
        """(width, height, rows) of what both eyes leave at the end of three frames."""
        client = self.client(self.address, "both", "--frames", "3", "--fps", "20", "--snapshot-dir", self.folder,
                             *arguments)
        self.assertEnds(client, 0)
        return read_png(self.folder / "both.png")[:3]

    def test_snapshots_are_of_what_is_seen_or_of_what_the_panel_shows(self):
        width, height, rows = self.picture("--hmd", "rift_dk1", "--size", "160x200", "--snapshot-of", "panel")
        self.assertEqual((width, height), (320, 200))
        self.assertEqual(bytes(rows[0][:3]), b"\0\0\0", "no lens shows a panel's corner")
        self.assertTrue(any(rows[100][3 * 80:3 * 83]))
        seen_width, seen_height, rows = self.picture("--hmd", "rift_dk1", "--size", "160x200")
        self.assertGreater(seen_width, width)
        self.assertTrue(any(rows[0][:3]), "a picture has corners")
        half_width, half_height, _ = self.picture("--hmd", "rift_dk1", "--size", "160x200", "--render-scale", "0.5")
        self.assertAlmostEqual(half_width, seen_width / 2, delta=2)
        self.assertAlmostEqual(half_height, seen_height / 2, delta=1)

    def test_size_is_the_panels_or_the_screens_shape(self):
        self.assertEqual(self.picture("--hmd", "rift_dk1", "--snapshot-of", "panel")[:2], (1280, 800))
        self.assertEqual(self.picture("--hmd", "desk")[:2], (1280, 360))
        self.assertEqual(self.picture()[:2], (1280, 480))

    def test_a_film_has_a_frame_for_each_that_was_to_be_seen(self):
        if shutil.which("ffmpeg") is None:
            self.skipTest("ffmpeg is not installed")
        film = self.folder / "film.mp4"
        client = self.client(self.address, "both", "--size", "80x60", "--fps", "20", "--frames", "30", "--video", film)
        self.assertEnds(client, 0)
        probed = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_entries",
                                 "stream=width,height,avg_frame_rate,nb_read_frames", "-of", "csv=p=0", film],
                                check=True, capture_output=True, text=True).stdout.strip().split(",")
        self.assertEqual(probed[:3], ["160", "60", "125/8"])  # one of four of 62.5 a second
        self.assertGreaterEqual(int(probed[3]), 30)

    def test_an_encoder_that_dies_ends_the_film_and_not_the_run(self):
        fake = self.folder / "ffmpeg"
        fake.write_text("#!/bin/sh\nhead -c 100000 >/dev/null\necho 'no room left' >&2\nexit 1\n")
        fake.chmod(0o755)
        path = os.environ["PATH"]
        self.addCleanup(os.environ.__setitem__, "PATH", path)
        os.environ["PATH"] = f"{self.folder}:{path}"
        client = self.client(self.address, "both", "--size", "80x60", "--fps", "20", "--frames", "40", "--snapshot-dir",
                             self.folder, "--video", self.folder / "film.mp4")
        self.assertEnds(client, 1)
        self.assertIn("film.mp4: the film ends here: ffmpeg has ended: no room left", client.text())
        self.assertTrue((self.folder / "both.png").exists(), "drawn to its end")

    def test_what_cannot_be_filmed_is_refused_before_anything_starts(self):
        for arguments, words in ((("--video", "film.avi"), "must end in .mp4"),
                                 (("--video", "/nowhere/film.mp4"), "there is no folder /nowhere")):
            client = self.start("refused", CLIENT, "--server", self.address, *arguments)
            self.assertEnds(client, 2)
            self.assertIn(words, client.text())
        path = os.environ["PATH"]
        self.addCleanup(os.environ.__setitem__, "PATH", path)
        os.environ["PATH"] = str(self.folder)
        client = self.start("refused", CLIENT, "--server", self.address, "--video", "film.mp4")
        self.assertEnds(client, 2)
        self.assertIn("apt-get install ffmpeg", client.text())


if __name__ == "__main__":
    unittest.main(verbosity=2)
