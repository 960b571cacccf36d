#!/usr/bin/env python3
"""Joins a Coherency motion server and prints the master's degrees of freedom: docs/wire.md, "A session", step by step.

    /usr/bin/python3 examples/read_motion.py --server 192.168.1.20:7430 --key FILE --samples 3
"""
import argparse
import os
import select
import socket
import struct
import sys
import time

from google.protobuf.message import DecodeError
from nacl import bindings as sodium

from coherency_wire import (DOFS, Control, Datagrams, Refused, all_units, blank, connection_keys, read_key, seal,
                            state_hash, wire, with_difference)


def join(control, preshared):
    """Steps 1 to 4 of a session. Returns the welcome."""
    secret = os.urandom(32)
    own = wire.Hello(major=3, minor=0, public_key=sodium.crypto_scalarmult_base(secret), keyed=preshared != bytes(32))
    client_hello = control.say(hello=own)
    hello, server_hello = control.wait_for("hello")
    if (hello.major, hello.keyed, len(hello.public_key)) != (own.major, own.keyed, 32):
        raise Refused(f"the server speaks version {hello.major} with {'a' if hello.keyed else 'no'} key, "
                      f"this client version {own.major} with {'a' if own.keyed else 'no'} key")
    control.keys = connection_keys(secret, hello.public_key, preshared, client_hello, server_hello)
    control.say(join=wire.Join(eye=b"mono", software=b"read_motion.py"))
    return control.wait_for("welcome")[0]


class Client:
    def __init__(self, control, welcome, over_tcp):
        self.control, self.welcome, self.over_tcp = control, welcome, over_tcp
        address = control.tcp.getpeername()
        self.udp = socket.socket(control.tcp.family, socket.SOCK_DGRAM)
        self.udp.connect((address[0], welcome.udp_port, *address[2:]))
        self.motion = Datagrams(welcome.motion_key, 0)
        self.keyframes = {}
        self.newest = self.newest_frame = self.probes = self.packets = self.frames = 0

    def probe(self):
        probe = wire.ClockProbe(t0_client_ns=time.monotonic_ns(), keyframe=max(self.keyframes, default=0),
                                way=wire.TCP if self.over_tcp else wire.UDP)
        body = wire.Datagram(clock_probe=probe).SerializeToString()
        if self.over_tcp:
            return self.control.say(datagram=body)
        self.probes += 1
        header = b"COH\x03" + struct.pack(">IQ", self.welcome.client_id, self.probes)
        return self.udp.send(seal(self.control.keys[2], self.welcome.client_id, self.probes, header, body))

    def samples(self):
        """(sample, units, state) of every packet that is newer than those before, without end."""
        next_probe, heard = 0.0, time.monotonic()
        while (now := time.monotonic()) - heard < 3:
            if now >= next_probe:
                self.probe()
                next_probe = now + 0.1
            for body in self.bodies(next_probe - now):
                datagram = wire.Datagram.FromString(body)
                if datagram.HasField("motion") and datagram.motion.keyframe in self.keyframes:
                    heard = now
                    yield from self.take(datagram.motion)
        raise Refused("no motion comes" + ("" if self.over_tcp else "; where UDP is blocked, --tcp helps"))

    def bodies(self, patience):
        """Of the datagrams that have come, by whichever way; takes in keyframes."""
        ready, _, _ = select.select([self.control.tcp, self.udp], [], [], patience)
        if self.control.tcp in ready:
            self.control.receive()
        while (message := self.control.next()[0]) is not None:
            if message.HasField("keyframe"):
                new = message.keyframe
                self.keyframes[new.number] = with_difference(blank(new), new.world)
                self.keyframes = dict(sorted(self.keyframes.items())[-2:])
            elif message.HasField("datagram"):
                yield message.datagram
        if self.udp in ready and (body := self.motion.open(self.udp.recv(2048))) is not None:
            yield body

    def take(self, motion):
        self.packets += 1
        state = with_difference(self.keyframes[motion.keyframe], motion.world)
        units = self.checked(motion, state)
        for frame in reversed(motion.frames):  # oldest first; each comes in many packets
            if frame.number > self.newest_frame:
                self.checked(frame, with_difference(state, frame.world))
                self.newest_frame = frame.number
                self.frames += 1
        if motion.sample.sequence > self.newest:
            self.newest = motion.sample.sequence
            yield motion.sample, units, state

    def checked(self, said, state):
        units = all_units(said.sample, self.welcome)
        if said.hash != state_hash(state, said.sample, units):
            raise Refused(f"what came with sample {said.sample.sequence} does not have its hash")
        return units


def show(sample, units, state, welcome):
    print(f"sample {sample.sequence} at {state.tick * welcome.period_ns / 1e9:.3f} s of the session, "
          f"{sample.device_time_us} us of the device")
    for dof, (name, kind, _, _) in enumerate(DOFS):
        note = "" if sample.valid >> dof & 1 else "held" if welcome.dofs >> dof & 1 else "stands still"
        print(f"  {name:18} {units[dof] * kind.one:+10.6f} {kind.name:3} {note}".rstrip())


def main():
    parser = argparse.ArgumentParser(description="Prints the DOFs that a Coherency motion server sends.")
    parser.add_argument("--server", default="127.0.0.1:7430", metavar="HOST:PORT")
    parser.add_argument("--key", metavar="FILE", help="the server's key file, where it has one")
    parser.add_argument("--samples", type=int, default=1, metavar="N", help="print so many and end")
    parser.add_argument("--tcp", action="store_true", help="ask for motion over TCP, where UDP is blocked")
    options = parser.parse_args()
    host, _, port = options.server.rpartition(":")
    preshared = read_key(options.key) if options.key else bytes(32)
    control = Control(host.strip("[]"), int(port))
    client = Client(control, join(control, preshared), options.tcp)
    for _, news in zip(range(options.samples), client.samples()):
        show(*news, client.welcome)
    control.say(goodbye=wire.Goodbye(reason=b"the client ends"))
    print(f"{client.packets} packets and {client.frames} frames, each with its hash, from keyframe "
          f"{max(client.keyframes)} at last", file=sys.stderr)


if __name__ == "__main__":
    try:
        main()
    except (Refused, DecodeError, OSError, ValueError) as error:
        sys.exit(f"read_motion: {error}")
