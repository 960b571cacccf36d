"""The wire of Coherency in Python: docs/wire.md without its conversations, which read_motion.py leads. Parts have the
names of that page's sections. Shares nothing with the programs but proto/coherency.proto.

From Debian's or Ubuntu's packages it takes protobuf-compiler, python3-protobuf and python3-nacl.
"""
import math
import pathlib
import socket
import struct
import subprocess
import sys
import tempfile
from collections import namedtuple

from nacl import bindings as sodium
from nacl.exceptions import CryptoError

PROTO = pathlib.Path(__file__).resolve().parent.parent / "proto"
with tempfile.TemporaryDirectory() as folder:
    subprocess.run(["protoc", f"--python_out={folder}", f"-I{PROTO}", "coherency.proto"], check=True)
    sys.path.insert(0, folder)
    import coherency_pb2 as wire
    sys.path.remove(folder)


class Refused(Exception):
    """In words, for people."""


# ---- Keys ----
def read_key(path):
    word, _, digits = pathlib.Path(path).read_text().strip().partition(" ")
    if word != "coherency-key-1" or len(digits) != 64:
        raise Refused(f'{path} is no key file, which is one line, "coherency-key-1 " and 64 hexadecimal digits')
    return bytes.fromhex(digits)


def blake2b(message, key=b"", salt=b"", personal=b""):
    return sodium.crypto_generichash_blake2b_salt_personal(message, 32, key, salt, personal)


def connection_keys(secret, other_public, preshared, client_hello, server_hello):
    """client_control, server_control, client_datagrams, server_datagrams"""
    shared = sodium.crypto_scalarmult(secret, other_public)
    master = blake2b(b"coherency 3" + shared + blake2b(client_hello) + blake2b(server_hello), key=preshared)
    return [blake2b(b"", master, number.to_bytes(16, "little"), b"coherncy" + bytes(8)) for number in (1, 2, 3, 4)]


def seal(key, channel, counter, header, body):
    nonce = struct.pack(">IQ", channel, counter)
    return header + sodium.crypto_aead_chacha20poly1305_ietf_encrypt(body, header, nonce, key)


def open_sealed(key, channel, counter, header, sealed):
    nonce = struct.pack(">IQ", channel, counter)
    try:
        return sodium.crypto_aead_chacha20poly1305_ietf_decrypt(sealed, header, nonce, key)
    except CryptoError:
        return None  # forged


# ---- Control: TCP ----
class Control:
    def __init__(self, host, port):
        self.tcp = socket.create_connection((host, port), timeout=3)
        self.unread = b""
        self.keys = None  # until both hellos were said
        self.sealed = self.opened = 0

    def say(self, **body):
        """Returns the message's bytes, as the keys depend on those of the hellos."""
        message = framed = wire.ControlMessage(**body).SerializeToString()
        if self.keys:
            framed = seal(self.keys[0], 0, self.sealed, b"\x01", message)
            self.sealed += 1
        self.tcp.sendall(struct.pack(">I", len(framed)) + framed)
        return message

    def receive(self):
        came = self.tcp.recv(65536)
        if not came:
            raise Refused("the server closed the connection")
        self.unread += came

    def next(self):
        """The next whole message of those received, and its bytes; None, None where there is none."""
        length = int.from_bytes(self.unread[:4], "big")
        if length > 65536:
            raise Refused("what answers there is no motion server")
        if len(self.unread) < 4 + length:
            return None, None
        message, self.unread = self.unread[4:4 + length], self.unread[4 + length:]
        clear = message[:1] != b"\x01"
        if not clear:
            message = open_sealed(self.keys[1], 0, self.opened, b"\x01", message[1:]) if self.keys else None
            if message is None:
                raise Refused("the server has another key, or is none")
            self.opened += 1
        decoded = wire.ControlMessage.FromString(message)
        if decoded.HasField("goodbye") and not (clear and self.opened):
            raise Refused(f"the server says: {decoded.goodbye.reason.decode()}")
        if clear and self.keys:
            raise Refused("something came in the clear that has to be sealed")
        return decoded, message

    def wait_for(self, kind):
        while (answer := self.next())[0] is None:
            self.receive()
        if not answer[0].HasField(kind):
            raise Refused(f"no {kind} came, but something else: what answers there is no motion server")
        return getattr(answer[0], kind), answer[1]


# ---- Motion: UDP ----
class Datagrams:
    """Opens what one side sends on one channel, each datagram once."""

    def __init__(self, key, channel):
        self.key, self.channel = key, channel
        self.newest, self.seen = 0, set()

    def open(self, datagram):
        """The body; None where it is of another channel, forged or replayed."""
        if len(datagram) < 32 or datagram[:4] != b"COH\x03":
            return None
        channel, counter = struct.unpack(">IQ", datagram[4:16])
        body = channel == self.channel and open_sealed(self.key, channel, counter, datagram[:16], datagram[16:])
        if not body or counter in self.seen or counter <= max(0, self.newest - 4096):
            return None
        self.newest = max(self.newest, counter)
        self.seen = {c for c in self.seen if c > self.newest - 4096} if len(self.seen) > 8192 else self.seen
        self.seen.add(counter)
        return body


# ---- Samples ----
Kind = namedtuple("Kind", "name one")  # the unit in SI, and the integer unit in it
METRES, RADIANS, RATIO = Kind("m", 1e-6), Kind("rad", 2 * math.pi / 2**32), Kind("", 2.0**-30)
DOFS = [  # name, kind, range in SI
    ("head_x", METRES, -10, 10), ("head_y", METRES, -4, 4), ("head_z", METRES, -10, 10),
    ("head_yaw", RADIANS, -math.pi, math.pi), ("head_pitch", RADIANS, -math.pi / 2, math.pi / 2),
    ("head_roll", RADIANS, -math.pi, math.pi), ("shoulder_flexion", RADIANS, -1.6, 3.2),
    ("shoulder_abduction", RADIANS, -1.5, 1.5), ("shoulder_rotation", RADIANS, -2.3, 2.3),
    ("elbow_flexion", RADIANS, -0.1, 2.8), ("forearm_rotation", RADIANS, -1.9, 1.9),
    ("wrist_flexion", RADIANS, -1.6, 1.6), ("wrist_deviation", RADIANS, -1.3, 1.3), ("grip", RATIO, 0, 1),
    ("stick_x", RATIO, -1, 1), ("stick_y", RATIO, -1, 1), ("stick_twist", RATIO, -1, 1),
    ("pedal_left", RATIO, 0, 1), ("pedal_right", RATIO, 0, 1)]


def wrapped(number, bits):
    """As a signed integer of so many bits."""
    return (number + 2**(bits - 1)) % 2**bits - 2**(bits - 1)


def units_from_code(dof, code):
    _, kind, least, most = DOFS[dof]
    first, last = round(least / kind.one), round(most / kind.one)
    return wrapped(first + (min(code, 65534) * (last - first) + 32767) // 65534, 32)


def all_units(sample, welcome):
    """Of all 19 DOFs: those that travel from the sample, the others from the welcome."""
    travelling = [dof for dof in range(19) if welcome.dofs >> dof & 1]
    came = struct.unpack(f"<{len(sample.codes) // 2}H", sample.codes) if welcome.compact else sample.units
    if len(came) != len(travelling):
        raise Refused(f"a sample came with {len(came)} DOFs instead of {len(travelling)}")
    units = list(welcome.still)
    for dof, value in zip(travelling, came):
        units[dof] = units_from_code(dof, value) if welcome.compact else value
    return units


# ---- Keyframes and differences ----
# Vehicles: x, y, z, heading, velocities right and ahead, turn rate. Movables: holder, x, y, z, attitude x, y, z, w, fall,
# resting, unrest. Task: started, done, towers, standing.
State = namedtuple("State", "tick mode master robot closed_hands movables doors task")


def blank(keyframe):
    return State(0, 0, (0,) * 7, (0,) * 7, 0, ((0,) * 11,) * keyframe.movables, (0,) * keyframe.doors, (0,) * 4)


def with_vehicle(old, new):
    added = (new.base.x_nm, new.base.y_nm, new.base.z_nm, new.base.heading_units,
             new.velocity_right_um, new.velocity_ahead_um, new.turn_rate_units)
    return tuple(wrapped(a + b, bits) for a, b, bits in zip(old, added, (64, 64, 64, 32, 32, 32, 32)))


def with_difference(state, world):
    movables, doors, task = list(state.movables), list(state.doors), state.task
    for new in world.movables:
        _, x, y, z, *attitude = movables[new.index][:8]
        place = (wrapped(x + new.x_nm, 64), wrapped(y + new.y_nm, 64), wrapped(z + new.z_nm, 64))
        movables[new.index] = (new.holder, *place, *(new.attitude or attitude), new.fall_um, new.resting, new.unrest_us)
    for new in world.doors:
        doors[new.index] = new.open
    if world.HasField("task"):
        task = (world.task.started_tick, world.task.done_tick, world.task.towers, world.task.standing)
    return State((state.tick + world.ticks) % 2**64, world.mode, with_vehicle(state.master, world.master),
                 with_vehicle(state.robot, world.robot), world.closed_hands, tuple(movables), tuple(doors), task)


# ---- The hash ----
def state_hash(state, sample, units):
    data = struct.pack("<QB", state.tick, state.mode)
    data += struct.pack("<qqqiiii", *state.master) + struct.pack("<qqqiiii", *state.robot)
    data += struct.pack("<BB", state.closed_hands, len(state.movables))
    data += b"".join(struct.pack("<BqqqiiiiiBI", *movable) for movable in state.movables)
    data += struct.pack(f"<B{len(state.doors)}i", len(state.doors), *state.doors)
    data += struct.pack("<QQIB", *state.task)
    data += struct.pack("<QqqI19i", sample.sequence, sample.server_time_ns, sample.device_time_us, sample.valid, *units)
    value = 0xcbf29ce484222325
    for byte in data:
        value = (value ^ byte) * 0x100000001b3 & 0xffffffffffffffff
    return value
