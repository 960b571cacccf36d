#!/usr/bin/env python3
"""A LAN on one machine: server, left eye and right eye on three hosts (network namespaces) joined by a bridge."""
import os
import subprocess
import sys
import unittest

from session import SessionTest
from coherency_check import eye_faults, read_png, server_faults, stereo_faults

HOSTS = {"server": "10.91.0.1", "left": "10.91.0.2", "right": "10.91.0.3"}
TAG = f"coh{os.getpid() % 100000}"


def ip(*arguments):
    subprocess.run(["ip", *arguments], check=True, capture_output=True, text=True)


def namespaces_allowed():
    if os.geteuid() != 0:
        return False
    try:
        ip("netns", "add", TAG + "probe")
        ip("netns", "del", TAG + "probe")
        return True
    except (OSError, subprocess.CalledProcessError):
        return False


class Lan(SessionTest):
    def setUp(self):
        super().setUp()
        bridge = TAG + "br"  # the bridge stands in a namespace of its own, so that nothing of the machine's changes
        self.namespace(bridge)
        ip("-n", bridge, "link", "add", "br0", "type", "bridge")
        ip("-n", bridge, "link", "set", "br0", "up")
        for host, address in HOSTS.items():
            self.namespace(TAG + host)
            ip("link", "add", "eth0", "netns", TAG + host, "type", "veth", "peer", "name", host, "netns", bridge)
            ip("-n", bridge, "link", "set", host, "master", "br0", "up")
            ip("-n", TAG + host, "addr", "add", address + "/24", "dev", "eth0")
            ip("-n", TAG + host, "link", "set", "eth0", "up")
            ip("-n", TAG + host, "link", "set", "lo", "up")

    def namespace(self, name):
        ip("netns", "add", name)
        self.addCleanup(ip, "netns", "del", name)

    def on(self, host):
        return ["ip", "netns", "exec", TAG + host]

    def test_three_hosts(self):
        from session import CLIENT, ROOT, SERVER
        server = self.start("server", SERVER, "--config", ROOT / "configs/servers/lan.toml", "--insecure", "--stats-json",
                            self.folder / "server.json", prefix=self.on("server"))
        self.until(lambda: "listening on 0.0.0.0:7430" in server.text(), 10, server)
        eyes = {eye: self.start(eye, CLIENT, "--server", HOSTS["server"], "--eye", eye, "--display", "headless", "--fps",
                                "25", "--size", "320x240", "--duration", "8", "--snapshot-dir", self.folder,
                                "--snapshot-at", "6", "--stats-json", self.folder / f"{eye}.json", prefix=self.on(eye))
                for eye in ("left", "right")}
        for eye, process in eyes.items():
            self.assertEnds(process, 0)
        self.until(lambda: self.stats("server")["stereo"]["frames_compared"] > 50, 5)
        faults = list(server_faults(self.stats("server")))
        for eye in eyes:
            # The eyes have just ended: what is judged is the run, not the last half second.
            stats = dict(self.stats(eye), motion_age_ms=0)
            faults += eye_faults(eye, stats)
            print(f"{eye}: clock {stats['clock']['offset_us']:+.1f} us within {stats['clock']['bound_us']:.1f} us "
                  "(one machine: the truth is 0)")
            self.assertLessEqual(abs(stats["clock"]["offset_us"]), stats["clock"]["bound_us"])
        faults += stereo_faults(self.folder, "")
        self.assertEqual(faults, [])
        self.assertEqual(read_png(self.folder / "stereo.png")[0], 640)
        addresses = {c["eye"]: c["address"] for c in self.stats("server")["clients"]}
        for eye in eyes:
            self.assertIn(HOSTS[eye], addresses[eye])


if __name__ == "__main__":
    if not namespaces_allowed():
        print("skipped: making network namespaces needs root and iproute2")
        sys.exit(77)
    unittest.main(verbosity=2)
