"""Sessions of a server and two eyes with small pictures, as tests of faults need them: on the hosts of lan.py, each eye
behind a relay if wanted (relays.py)."""
import os
import re
import subprocess
import time

import lan
from relays import Relay
from session import CLIENT, ROOT, SERVER

EYES = ("left", "right")
SMALL = ("--display", "headless", "--size", "64x48", "--samples", "1")
AT_SERVER = f"{lan.HOSTS['server']}:7430"


def first_of_all(how):
    """A prefix that runs a program before the machine's other work, where that is allowed."""
    allowed = subprocess.run([*how, "true"], capture_output=True).returncode == 0
    return how if allowed else []


NETWORK = first_of_all(["chrt", "-f", "60"])  # a relay that waits for a processor would be another fault than was asked for
PROGRAM = first_of_all(["chrt", "-r", "5"])  # neither are faults what a machine does that has other work


def cause_of(stereo):
    return (f"{stereo['frames_agreeing']} of {stereo['frames_compared']} compared agree, differing {stereo['differing']}, "
            f"one eye only {stereo['one_eye_only']}")


def since(after, before):
    """What was counted between two statistics' `stereo`."""
    difference = {key: after[key] - before[key] for key in ("frames_compared", "frames_agreeing")}
    for group in ("differing", "one_eye_only"):
        difference[group] = {key: after[group][key] - before[group][key] for key in after[group]}
    return difference


class HostSession(lan.LanTest):
    def setUp(self):
        super().setUp()
        self.key = self.folder / "session.key"
        self.assertEnds(self.start("key", SERVER, "--make-key", self.key), 0)

    def serve(self, scene="laboratory", network="", name="server"):
        """On its host, with a key; once it listens."""
        config = self.folder / f"{name}.toml"
        config.write_text(f'scene = "{ROOT / "configs/scenes"}/{scene}.toml"\nrig = "{ROOT / "configs/rigs/default.toml"}"\n'
                          f'[network]\naddress = "0.0.0.0"\n{network}\n')
        server = self.start(name, SERVER, "--config", config, "--key", self.key, "--stats-json",
                            self.folder / f"{name}.json", prefix=self.on("server") + PROGRAM)
        self.until(lambda: re.search("^listening on", server.text(), re.M), 10, server)
        return server

    def relay(self, host, *options):
        """Between the host's own 127.0.0.1:7430 and the server."""
        relay = Relay(self.folder / f"relay_{host}.log", "127.0.0.1:7430", AT_SERVER, *options,
                      prefix=self.on(host) + NETWORK)
        self.started.append(relay)
        self.until(relay.listening, 5, relay)
        return relay

    def eye(self, eye, *options, server=AT_SERVER, key=None, name=None, prefix=()):
        name = name or eye
        return self.start(name, CLIENT, "--server", server, "--key", key or self.key, "--eye", eye, *SMALL, "--stats-json",
                          self.folder / f"{name}.json", *options, prefix=[*self.on(eye), *PROGRAM, *prefix])

    def eyes(self, **options):
        return {eye: self.eye(eye, **options) for eye in EYES}

    def stereo(self, name="server"):
        return (self.stats(name) or {"stereo": {"frames_agreeing": 0}})["stereo"]

    def agreeing(self, more=30, seconds=20, name="server"):
        """Waits until the eyes have agreed on so many frames more; gives the newest count of all."""
        before = self.stereo(name)["frames_agreeing"]
        self.until(lambda: self.stereo(name)["frames_agreeing"] >= before + more, seconds)
        return self.stereo(name)

    def whole(self, name="server"):
        """Whatever happened, no eye has shown another state than the other, nor one without its hash."""
        stereo = self.stereo(name)
        self.assertEqual(stereo["differing"], {"tick": 0, "state": 0})
        self.assertEqual(stereo["one_eye_only"]["mismatch"], 0)
        for eye in EYES:
            stats = self.stats(eye)
            if stats:
                self.assertEqual(stats["replica"]["hash_mismatches"], 0, stats)
        return stereo


def load():
    return f"load {os.getloadavg()[0]:.1f} on {os.cpu_count()} processors"


def pause(seconds):
    """For what the outside world does in the meantime."""
    time.sleep(seconds)
