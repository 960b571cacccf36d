"""Impairing relays (tests/relay) between the hosts of a session (lan.py): on an eye's host, as its way to the server."""
import json
import os
import re
import subprocess

from session import ROOT, Process

RELAY = os.environ.get("COHERENCY_RELAY", ROOT / "build/release/tests/relay/impairing_relay")
# 5 % lost, 20 ms without anything about once a second, 5 ms jitter in which datagrams overtake each other.
IMPAIRED = ("--loss", "0.05", "--burst-every-ms", "1000", "--burst-ms", "20", "--jitter-ms", "5", "--reorder", "--duplicate",
            "0.01", "--corrupt", "0.001")


class Relay(Process):
    """Listens where it says `listen`, on the host that `prefix` is; ends with its standard input."""

    def __init__(self, log, listen, server, *options, prefix=()):
        self.log = log
        with open(log, "wb") as stderr:
            self.process = subprocess.Popen(
                [*prefix, str(RELAY), "--listen", listen, "--server", server, "--until-stdin-closes", *map(str, options)],
                stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=stderr, text=True)

    def listening(self):
        return re.search("^listening on", self.text(), re.M)

    def say(self, line):
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()
        answer = self.process.stdout.readline().strip()
        if answer.startswith("error") or not answer:
            raise AssertionError(f"the relay to {line!r}: {answer or self.text()}")
        return answer

    def stats(self):
        return json.loads(self.say("stats"))

    def end(self, how=None):
        for stream in (self.process.stdin, self.process.stdout):
            stream.close()
        return super().end(*([how] if how else []))
