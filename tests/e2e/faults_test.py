#!/usr/bin/env python3
"""The chain under what goes wrong: bad input, killed programs, noise on the ports."""
import os
import pathlib
import signal
import socket
import subprocess
import time
import unittest

from session import CLIENT, ROOT, SERVER, SessionTest

HEADER = ("t_s,head_x_m,head_y_m,head_z_m,head_qw,head_qx,head_qy,head_qz,arm_j1_rad,arm_j2_rad,arm_j3_rad,arm_j4_rad,"
          "arm_j5_rad,arm_j6_rad,arm_j7_rad,grip,joy_x,joy_y,joy_yaw,pedal_l,pedal_r\n")
LABORATORY = ROOT / "configs/servers/laboratory.toml"


def row(t, first="0", qw="1"):
    return f"{t},{first},1.6,0,{qw},0,0,0,0.1,0.1,0.1,0.5,0,0,0,0,0,0,0,0,0\n"


class BadInput(SessionTest):
    """Exit 2 for arguments and configuration, 1 for what fails while running; one line with place and remedy."""

    def refuse(self, code, words, *arguments):
        environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
        done = subprocess.run([str(a) for a in arguments], capture_output=True, text=True, timeout=20,
                              env=environment)
        said = done.stdout + done.stderr
        self.assertEqual(done.returncode, code, said)
        for word in words:
            self.assertIn(word, said)
        return said

    def test_arguments(self):
        for program in (SERVER, CLIENT):
            said = self.refuse(2, [f'{pathlib.Path(program).name}: "--moed" is no option', "--help"], program, "--moed",
                               "robot")
            self.assertEqual(len(said.strip().splitlines()), 1, said)
        said = self.refuse(2, ["--config FILE is missing", "servers/laboratory.toml"], SERVER)
        self.assertTrue(pathlib.Path(said.split(" is ")[-1].strip()).exists(), said)
        self.refuse(2, ["is a folder"], SERVER, "--config", ROOT / "configs")
        for seed in ("-1", "x", "1.5", "99999999999999999999"):
            self.refuse(2, ["motion_server: --world-seed", f'"{seed}"', "whole number from 0"], SERVER, "--config",
                        LABORATORY, "--world-seed", seed)
        self.refuse(2, ["telepathy"], SERVER, "--config", LABORATORY, "--master", "telepathy")
        self.refuse(2, ["needs a recording"], SERVER, "--config", LABORATORY, "--master", "replay")
        for address in ("127.0.0.1:99999", "7430", "foo:1", "foo"):
            self.refuse(2, [f'"{address}"', "right would be 127.0.0.1:7430"], SERVER, "--config", LABORATORY, "--listen",
                        address)
        self.refuse(2, ['"7430" is no HOST:PORT'], CLIENT, "--server", "7430")
        self.refuse(2, ["--insecure"], SERVER, "--config", LABORATORY, "--listen", "0.0.0.0:0")
        self.refuse(2, ["--make-key"], SERVER, "--config", LABORATORY, "--listen", "0.0.0.0:0")
        self.refuse(2, ["--key FILE", "--insecure"], CLIENT, "--server", "192.0.2.1")
        self.refuse(2, ["third"], CLIENT, "--eye", "third")
        self.refuse(2, ["WIDTHxHEIGHT"], CLIENT, "--size", "640")
        self.refuse(2, ["16 to 16384"], CLIENT, "--size", "0x480")
        self.refuse(2, ["nowhere.toml: no such file"], CLIENT, "--hmd", "nowhere.toml")
        self.refuse(2, ['"narrow" is not known', "desk, generic, index"], CLIENT, "--hmd", "narrow")
        for program in (SERVER, CLIENT):
            self.refuse(2, ["--stats-json /nope/x", "no folder /nope"], program, *(["--config", LABORATORY] * (
                program == SERVER)), "--stats-json", "/nope/x")

    def test_help_and_version_end_well(self):
        for program in (SERVER, CLIENT):
            self.assertIn("--stats-json", self.refuse(0, ["--help"], program, "--help"))
            self.refuse(0, ["0."], program, "--version")
        self.refuse(0, ["meeting room", "cube of 55 mm to build with", "takes a colour"], SERVER, "--list-objects")

    def test_configuration(self):
        self.refuse(2, ["nowhere.toml: no such file"], SERVER, "--config", "nowhere.toml")
        bad = self.folder / "bad.toml"
        scene = ROOT / "configs/scenes/laboratory.toml"
        bad.write_text(f"scene = \"{scene}\"\n[network]\nport = 70000\n")
        self.refuse(2, ["bad.toml:3:", "network.port", "from 0 to 65535"], SERVER, "--config", bad)
        bad.write_text("scene = \n")
        self.refuse(2, ["bad.toml:1:"], SERVER, "--config", bad)
        bad.write_text(f"scene = \"{scene}\"\n[network]\naddress = \"foo\"\n")
        self.refuse(2, ["bad.toml:3:", "network.address", "127.0.0.1"], SERVER, "--config", bad)
        rig = self.folder / "rig.toml"
        rig.write_text("name = \"Jörg\"\n")
        bad.write_text(f"scene = \"{scene}\"\nrig = \"rig.toml\"\n")
        self.refuse(2, ["rig.toml:1:8", "Jörg", "ASCII"], SERVER, "--config", bad)

    def test_what_a_rig_leaves_out_is_said(self):
        (self.folder / "rig.toml").write_text("upper_arm = 0.29\n")
        mine = self.folder / "mine.toml"
        mine.write_text(f"scene = \"{ROOT / 'configs/scenes/laboratory.toml'}\"\nrig = \"rig.toml\"\n"
                        "[network]\naddress = \"localhost\"\n")
        said = self.refuse(0, ["rig rig gives no eye_distance", "robot_scale"], SERVER, "--config", mine, "--duration", "0.3",
                           "--listen", "localhost:0")
        self.assertNotIn("upper_arm", said)
        self.assertNotIn("0 of 0", said)

    def test_unknown_scene(self):
        self.refuse(2, ["atlantis", "laboratory"], SERVER, "--config", LABORATORY, "--listen", "127.0.0.1:0",
                    "--scene", "atlantis")
        for name in ("", "../scenes/look", "Jörg"):
            self.refuse(2, [f'"{name}" is no name', "blocks, corridor"], SERVER, "--config", LABORATORY, "--scene", name)
        self.refuse(2, ["nothing in", "takes its count"], SERVER, "--config", LABORATORY, "--scene", "laboratory:3")
        self.refuse(2, ["from 1 to 200000"], SERVER, "--config", LABORATORY, "--scene", "grid:200001")
        spaced = self.folder / "my scene.toml"
        spaced.write_text("")
        self.refuse(2, ["my scene.toml", "rename"], SERVER, "--config", LABORATORY, "--scene", spaced)

    def test_scenes_that_cannot_be(self):
        scene = self.folder / "scene.toml"
        table = "[[object]]\nkind = \"table\"\nposition = [0.0, 0.0, -1.2]\n"
        for text, words in [
            ("[[object]]\nkind = \"unicorn\"\n", ["scene.toml:2:8", "unicorn", "there are", "table"]),
            (table + table, ["scene.toml:4:", "two objects are called 'table'"]),
            ("\n[[object]]\nname = \"a\"\n", ["scene.toml:2:", "kind: is missing"]),
            (table + "name = \"Tisch für alle\"\n", ["scene.toml:4:8", "Tisch für alle", "ASCII"]),
            (table + table + "name = \"another\"\nheading = 20.0\n", ["scene.toml: ", "'scene/another' stands in 'scene/table'", "mm"]),
            (table + "[[object]]\nkind = \"block\"\nposition = [0.0, 0.71, -1.2]\n", ["'scene/block' stands in 'scene/table'"]),
            ("start = [0.0, -1.0, 0.0]\n" + table, ["the master system", "would stand in 'scene/table'"]),
            ("[[object]]\nkind = \"table\"\nposition = [2e9, 0.0, 0.0]\n", ["scene.toml:3:", "from -1000000000 to 1000000000"]),
            ("[[object]]\nkind = \"block\"\ncolour = \"reddish\"\n", ["scene.toml:3:10", "reddish", "#c8433a"]),
        ]:
            scene.write_text(text)
            said = self.refuse(2, words, SERVER, "--config", LABORATORY, "--listen", "127.0.0.1:0", "--scene", scene)
            self.assertLess(len(said.strip().splitlines()), 2, said)
        scene.write_text("scatter = [0.0, 0.01, -1.2, -1.19]\n" + table + "".join(
            f"[[object]]\nkind = \"block\"\nname = \"{i}\"\nposition = [{0.1 * i}, 0.7475, -1.2]\n" for i in range(3)))
        self.refuse(2, ["scene.toml: "], SERVER, "--config", LABORATORY, "--listen", "127.0.0.1:0", "--scene", scene,
                    "--world-seed", "5")
        self.refuse(2, ["whole number from 1"], SERVER, "--config", LABORATORY, "--scene", "grid:none")
        self.refuse(2, ["has no robot"], SERVER, "--config", LABORATORY, "--scene", "blocks", "--mode", "robot")

    def test_recordings(self):
        file = self.folder / "bad.csv"
        for text, words in [
            (None, ["bad.csv"]),
            ("", ["bad.csv:1"]),
            (HEADER, ["bad.csv"]),
            ("a,b,c\n1,2,3\n", ["bad.csv:1"]),
            (HEADER + row("0") + row("0.1", first="left"), ["bad.csv:3:5", "left"]),
            (HEADER + row("0") + row("0.1", first="nan"), ["bad.csv:3:5"]),
            (HEADER + row("0") + row("0.1", first="500"), ["bad.csv:3", "head_x"]),
            (HEADER + row("0.1") + row("0.1"), ["bad.csv:3:1"]),
            (HEADER + row("0") + row("0.1", qw="0.5"), ["bad.csv:3"]),
            (HEADER + row("0") + "0.1,1,2\n", ["bad.csv:3"]),
        ]:
            if text is not None:
                file.write_text(text)
            said = self.refuse(2, words, SERVER, "--config", LABORATORY, "--listen", "127.0.0.1:0", "--recording", file)
            self.assertLess(len(said.strip().splitlines()), 2, said)

    def test_port_in_use(self):
        with socket.socket() as taken:
            taken.bind(("127.0.0.1", 0))
            taken.listen()
            port = taken.getsockname()[1]
            self.refuse(1, [f"127.0.0.1:{port}"], SERVER, "--config", LABORATORY, "--listen", f"127.0.0.1:{port}")

    def test_unreachable_server(self):
        self.refuse(1, ["asking the server at 127.0.0.1:9", "motion_server"], CLIENT, "--server", "127.0.0.1:9", "--wait", "1", "--display",
                    "headless")
        self.refuse(1, ["no.such.host.invalid"], CLIENT, "--server", "no.such.host.invalid", "--insecure", "--wait", "1",
                    "--display", "headless")

    def test_window_without_a_display(self):
        for option in (["--display", "window"], ["--fullscreen"]):
            self.refuse(2, ["--display headless"], CLIENT, "--server", "127.0.0.1:9", *option)

    def test_numbers_that_are_none(self):
        for option, value in (("--duration", "nan"), ("--wait", "inf"), ("--fps", "nan"), ("--frames", "-1"),
                              ("--snapshot-at", "-5"), ("--samples", "0"),
                              ("--detail-px", "-0.1"), ("--smallest-px", "nan")):
            self.refuse(2, [option], CLIENT, option, value)
        self.refuse(2, ["--fullscreen"], CLIENT, "--fullscreen", "--display", "headless")

    def test_a_driver_that_is_too_old(self):
        _, address = self.server()
        os.environ["MESA_GL_VERSION_OVERRIDE"] = "3.3"
        self.addCleanup(os.environ.pop, "MESA_GL_VERSION_OVERRIDE")
        self.refuse(1, ["4.5"], CLIENT, "--server", address, "--display", "headless", "--frames", "1")

    def test_pictures_that_cannot_be_taken(self):
        _, address = self.server()
        client = (CLIENT, "--server", address, "--display", "headless", "--size", "160x120")
        self.refuse(1, ["/proc/nowhere"], *client, "--snapshot-dir", "/proc/nowhere")
        self.refuse(1, ["before the moment"], *client, "--snapshot-dir", self.folder, "--snapshot-at", "100",
                    "--duration", "1.5")
        self.refuse(1, ["already"], *client, "--snapshot-dir", self.folder, "--snapshot-at", "0.001")

    def test_statistics_that_cannot_be_written(self):
        self.refuse(2, ["/nowhere/stats.json"], SERVER, "--config", LABORATORY, "--listen", "127.0.0.1:0",
                    "--duration", "0.2", "--stats-json", "/nowhere/stats.json")
        self.refuse(1, ["/dev/full"], SERVER, "--config", LABORATORY, "--listen", "127.0.0.1:0", "--duration", "0.2",
                    "--stats-json", "/dev/full")


class Survival(SessionTest):
    def frames(self, name):
        return (self.stats(name) or {}).get("frames", 0)

    def test_two_eyes_agree_and_lose_nothing(self):
        _, address = self.server()
        eyes = [self.client(address, eye, "--fps", "20", "--size", "320x240", "--duration", "6")
                for eye in ("left", "right")]
        for eye in eyes:
            self.assertEnds(eye, 0)
        for name in ("left", "right"):
            stats = self.stats(name)
            self.assertGreater(stats["frames"], 10)
            self.assertEqual(stats["packets"]["lost"], 0, stats)
            self.assertEqual(stats["packets"]["rejected"], 0)
            self.assertEqual(stats["replica"]["hash_mismatches"], 0)
        server = self.until(lambda: (s := self.stats("server")) and s["stereo"]["frames_compared"] > 3 and s, 5)
        self.assertEqual(server["stereo"]["frames_agreeing"], server["stereo"]["frames_compared"])

    def test_a_killed_eye_comes_back_at_once_and_a_third_disturbs_nobody(self):
        _, address = self.server()
        options = ("--fps", "20", "--size", "160x120")
        self.client(address, "right", *options)
        left = self.client(address, "left", *options)
        self.until(lambda: self.frames("left") > 10 and self.frames("right") > 10, 15, left)
        left.end(signal.SIGKILL)
        again = time.monotonic()
        second = self.client(address, "left", *options, "--frames", "1", name="again")
        self.assertEnds(second, 0)
        print(f"killed eye: first frame {self.stats('again')['first_frame_ms']:.0f} ms after its start, program over "
              f"after {time.monotonic() - again:.2f} s")
        # Half a second here with nothing else running (docs/measurements.md); what is printed counts, this is for hangs.
        self.assertLess(self.stats("again")["first_frame_ms"], 5000)
        third = self.client(address, "mono", *options, "--duration", "2")
        self.assertEnds(third, 0)
        right = self.until(lambda: self.stats("right"), 5)
        self.assertEqual(right["packets"]["lost"], 0, right)
        self.assertEqual(right["connections"], 1)

    def test_eyes_hold_and_return_when_the_server_does(self):
        first, address = self.server()
        left = self.client(address, "left", "--fps", "20", "--size", "160x120")
        self.until(lambda: self.frames("left") > 10, 15)
        first.end(signal.SIGKILL)
        self.until(lambda: (s := self.stats("left")) and s["motion_age_ms"] > 1500, 10)
        before = self.frames("left")
        self.until(lambda: self.frames("left") > before, 5)  # the last pose goes on being shown
        self.server(listen=address, name="second")
        self.until(lambda: self.stats("left")["connections"] == 2 and self.stats("left")["motion_age_ms"] < 100, 5)
        self.until(lambda: f"the server at {address} is back" in left.text(), 3, left)
        self.assertIn(f"lost the server at {address}", left.text())
        self.assertIn("(left) has come", first.text())

    def test_a_slow_stranger_disturbs_nobody(self):
        server, address = self.server()
        host, port = address.rsplit(":", 1)
        strangers = [socket.create_connection((host, int(port))) for _ in range(8)]
        for stranger in strangers:
            stranger.sendall(b"\x00\x00\xff\x00")  # the length of a message that never ends
        end = time.monotonic() + 2.6
        while time.monotonic() < end:  # silent clients are dropped after 2 s
            for stranger in strangers:
                try:
                    stranger.send(b"x")
                except OSError:
                    pass
            time.sleep(0.0005)
        for stranger in strangers:
            stranger.close()
        self.assertTrue(server.running(), server.text())
        self.assertEnds(self.client(address, "left", "--frames", "3", "--size", "160x120"), 0)

    def test_silent_strangers_keep_nobody_out(self):
        server, address = self.server()
        host, port = address.rsplit(":", 1)
        strangers = [socket.create_connection((host, int(port))) for _ in range(80)]
        self.addCleanup(lambda: [stranger.close() for stranger in strangers])
        self.assertEnds(self.client(address, "left", "--frames", "3", "--size", "160x120", "--wait", "1.5"), 0)
        server.end(signal.SIGINT)
        self.assertIn("0 clients now, 1 served", server.text())

    def test_noise_on_both_ports_is_counted_and_ignored(self):
        server, address = self.server()
        host, port = address.rsplit(":", 1)
        self.client(address, "left", "--fps", "20", "--size", "160x120")
        self.until(lambda: self.frames("left") > 10, 15)
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as datagrams:
            for size in list(range(0, 200)) + [1400] * 20:
                datagrams.sendto(os.urandom(size), (host, int(port)))
        for _ in range(20):
            with socket.create_connection((host, int(port))) as stream:
                stream.sendall(os.urandom(300))
        stats = self.until(lambda: (s := self.stats("server")) and sum(s["rejected"].values()) > 200 and s, 5)
        self.assertTrue(server.running())
        left = self.until(lambda: self.stats("left"), 5)
        self.assertEqual(left["packets"]["lost"], 0, left)
        print("noise counted:", stats["rejected"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
