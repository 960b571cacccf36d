#!/usr/bin/env python3
"""The client in Python (examples/read_motion.py) against the real server: two implementations of docs/wire.md, of which
the one shares nothing with the other but proto/coherency.proto."""
import math
import re
import subprocess
import sys
import unittest

from session import ROOT, SERVER, SessionTest

EXAMPLE = ROOT / "examples/read_motion.py"
HEADER = ("t_s,head_x_m,head_y_m,head_z_m,head_qw,head_qx,head_qy,head_qz,arm_j1_rad,arm_j2_rad,arm_j3_rad,arm_j4_rad,"
          "arm_j5_rad,arm_j6_rad,arm_j7_rad,grip,joy_x,joy_y,joy_yaw,pedal_l,pedal_r\n")
# name, value at the recording's begin, its change a second, what 16 bits change it by at most: half of a 65534th of the
# range and the unit's rounding
RECORDED = {
    "head_x": (0.10, 0.02, 1.6e-4), "head_y": (1.10, 0.01, 6.3e-5), "head_z": (-0.05, -0.02, 1.6e-4),
    "head_yaw": (0.30, 0.05, 4.9e-5), "head_pitch": (0.0, 0.0, 2.5e-5), "head_roll": (0.0, 0.0, 4.9e-5),
    "shoulder_flexion": (0.20, 0.03, 3.8e-5), "shoulder_abduction": (-0.30, 0.02, 2.4e-5),
    "shoulder_rotation": (0.50, -0.03, 3.6e-5), "elbow_flexion": (1.50, 0.03, 2.3e-5),
    "forearm_rotation": (-1.00, 0.02, 3.0e-5), "wrist_flexion": (-0.10, 0.02, 2.5e-5),
    "wrist_deviation": (0.05, -0.01, 2.0e-5), "grip": (0.20, 0.01, 1.6e-5 / 2), "stick_x": (0.10, 0.01, 1.6e-5),
    "stick_y": (0.20, -0.01, 1.6e-5), "stick_twist": (-0.10, 0.01, 1.6e-5), "pedal_left": (0.01, 0.01, 1.6e-5 / 2),
    "pedal_right": (0.02, 0.01, 1.6e-5 / 2)}
ROUNDING = 1.5e-6  # of what is printed, of a micrometre, and of the recording's 9 digits


def interpreter():
    """One that has what the example needs: the distribution's own, as a rule."""
    tried = ["/usr/bin/python3", sys.executable]
    for python in tried:
        if subprocess.run([python, "-c", "import nacl.bindings, google.protobuf"], capture_output=True,
                          check=False).returncode == 0:
            return python
    print(f"skipped: none of {', '.join(tried)} has nacl and protobuf; install python3-nacl and python3-protobuf")
    sys.exit(77)


def recorded(seconds):
    """A recording in which every DOF but pitch and roll changes evenly."""
    values = {name: begin + change * seconds for name, (begin, change, _) in RECORDED.items()}
    yaw = values.pop("head_yaw")
    del values["head_pitch"], values["head_roll"]
    head = [values.pop(name) for name in ("head_x", "head_y", "head_z")]
    columns = [seconds, *head, math.cos(yaw / 2), 0, math.sin(yaw / 2), 0, *values.values()]
    return ",".join(f"{value:.9f}" for value in columns) + "\n"


class PythonClient(SessionTest):
    def configured(self, text):
        path = self.folder / "server.toml"
        path.write_text(f'scene = "laboratory"\n{text}')
        return path

    def serve(self, *arguments, text=""):
        """As SessionTest.server(), of a configuration of this test's own."""
        process = self.start("server", SERVER, "--config", self.configured(text), "--listen", "127.0.0.1:0",
                             "--stats-json", self.folder / "server.json", "--duration", "100", *arguments)
        found = self.until(lambda: re.search(r"^listening on (\S+)", process.text(), re.M), 10, process)
        return process, found.group(1)

    def ask(self, address, *arguments):
        return subprocess.run([PYTHON, EXAMPLE, "--server", address, *map(str, arguments)], capture_output=True,
                              text=True, timeout=60, check=False)

    def read(self, address, count, *arguments):
        """`count` samples: [(microseconds of the device, {DOF: (value, note)})]; every packet had its hash. And the number
        of the newest keyframe."""
        done = self.ask(address, "--samples", count, *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        told = re.fullmatch(r"(\d+) packets and (\d+) frames, each with its hash, from keyframe (\d+) at last\n",
                            done.stderr)
        self.assertIsNotNone(told, done.stderr)
        self.assertGreaterEqual(int(told[1]), count)
        self.assertGreaterEqual(int(told[2]), 1)
        samples = []
        for line in done.stdout.splitlines():
            if heading := re.fullmatch(r"sample \d+ at [\d.]+ s of the session, (\d+) us of the device", line):
                samples.append((int(heading[1]), {}))
            else:
                name, value, note = re.fullmatch(r"  (\w+) +([+-][\d.]+) ?(?:m|rad)? *([a-z ]*)", line).groups()
                samples[-1][1][name] = (float(value), note)
        self.assertEqual(len(samples), count)
        for _, dofs in samples:
            self.assertEqual(list(dofs), list(RECORDED))
        return samples, int(told[3])

    def served(self, process):
        """The server's statistics, once it has ended; it understood all that came."""
        self.assertEqual(process.end(), 0, process.text())
        stats = self.stats("server")
        self.assertEqual(set(stats["rejected"].values()), {0}, stats["rejected"])
        return stats

    def key(self, name):
        path = self.folder / name
        subprocess.run([SERVER, "--make-key", path], check=True)
        return path

    def assertRecorded(self, samples, encoded):
        """Each DOF is where the recording has it at the sample's time."""
        for microseconds, dofs in samples:
            for name, (begin, change, step) in RECORDED.items():
                limit = ROUNDING + (step if encoded else 0.0)
                self.assertAlmostEqual(dofs[name][0], begin + change * microseconds * 1e-6, delta=limit,
                                       msg=f"{name} at {microseconds} us")

    def recording(self):
        path = self.folder / "recording.csv"
        path.write_text(HEADER + "".join(recorded(row / 50) for row in range(50 * 40)))
        return path

    REPLAY = '[master.replay]\nhead_height = "recorded"\n'

    def test_reads_a_recording_exactly_with_a_key(self):
        key = self.key("right.key")
        server, address = self.serve("--key", key, "--recording", self.recording(), text=self.REPLAY)
        samples, _ = self.read(address, 500, "--key", key)
        self.assertRecorded(samples, encoded=False)
        self.assertEqual({note for _, dofs in samples for _, note in dofs.values()}, {""})
        client, = self.served(server)["clients"]
        self.assertEqual((client["way"], client["eye"]), ("udp", "mono"))

    def test_reads_compact_codes(self):
        text = '[network]\nencoding = "compact"\n' + self.REPLAY
        server, address = self.serve("--recording", self.recording(), text=text)
        samples, _ = self.read(address, 500)
        self.assertRecorded(samples, encoded=True)
        self.assertTrue(self.served(server)["encoding"].startswith("compact"))

    def test_reads_over_tcp(self):
        key = self.key("right.key")
        server, address = self.serve("--key", key, "--recording", self.recording(), text=self.REPLAY)
        samples, _ = self.read(address, 300, "--tcp", "--key", key)
        self.assertRecorded(samples, encoded=False)
        client, = self.served(server)["clients"]
        self.assertEqual(client["way"], "tcp")

    def test_reads_six_dofs_and_knows_where_the_others_stand(self):
        server, address = self.serve("--scene", "look")
        samples, _ = self.read(address, 100)
        for _, dofs in samples:
            for name, (_, note) in dofs.items():
                self.assertEqual(note, "" if name.startswith("head_") else "stands still")
        self.assertEqual(samples[0][1]["grip"], samples[-1][1]["grip"])
        self.served(server)

    def test_follows_keyframes(self):
        """The simulated operator grasps within ten seconds, the state changes, and keyframes follow each other."""
        server, address = self.serve()
        _, keyframe = self.read(address, 12000)
        self.assertGreater(keyframe, 1)
        self.served(server)

    def test_other_key_is_refused(self):
        right, wrong = self.key("right.key"), self.key("wrong.key")
        server, address = self.serve("--key", right)
        done = self.ask(address, "--key", wrong)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("another key than this client", done.stderr)
        done = self.ask(address)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("this server has a key", done.stderr)
        self.until(lambda: server.text().count(" refused: this server has ") == 2, 5, server)
        self.assertEqual(server.end(), 0)
        stats = self.stats("server")
        self.assertEqual((stats["rejected"]["forged"], stats["rejected"]["foreign"]), (1, 1))
        self.assertEqual(stats["clients_served"], 0)

    def test_key_for_a_server_without_one_is_refused(self):
        server, address = self.serve()
        done = self.ask(address, "--key", self.key("a.key"))
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("this server has no key", done.stderr)
        self.assertEqual(server.end(), 0)
        self.assertEqual(self.stats("server")["rejected"]["foreign"], 1)

    def test_speaks_in_words_where_nobody_answers(self):
        done = self.ask("127.0.0.1:1")
        self.assertEqual(done.returncode, 1)
        self.assertIn("read_motion: ", done.stderr)
        not_a_key = self.folder / "nothing.key"
        not_a_key.write_text("coherency-key-1 00\n")
        done = self.ask("127.0.0.1:1", "--key", not_a_key)
        self.assertEqual(done.returncode, 1)
        self.assertIn("is no key file", done.stderr)


if __name__ == "__main__":
    PYTHON = interpreter()
    unittest.main(verbosity=2)
