"""A LAN on one machine: server, left eye and right eye on three hosts (network namespaces) joined by a bridge."""
import os
import subprocess
import sys
import unittest

from session import SessionTest

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


class LanTest(SessionTest):
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


def main():
    if not namespaces_allowed():
        print("skipped: making network namespaces needs root and iproute2")
        sys.exit(77)
    unittest.main(verbosity=2)
