#!/usr/bin/env python3
"""A stranger on one host of lan.py: hears what passes the host's interface and sends datagrams under anybody's address.

    datagrams.py hear SECONDS      prints "SOURCE:PORT TARGET:PORT HEX" for each datagram that eth0 sees
    datagrams.py send              sends what such lines on standard input say
"""
import socket
import struct
import sys
import time

EVERYTHING = 3  # ETH_P_ALL: what the host sends, too
IPV4 = 0x0800


def hear(seconds):
    with socket.socket(socket.AF_PACKET, socket.SOCK_DGRAM, socket.htons(EVERYTHING)) as wire:
        wire.bind(("eth0", EVERYTHING))
        wire.settimeout(0.05)
        ends = time.monotonic() + seconds
        while time.monotonic() < ends:
            try:
                packet, (_, protocol, *_) = wire.recvfrom(65536)
            except TimeoutError:
                continue
            if protocol != IPV4 or packet[9] != socket.IPPROTO_UDP:
                continue
            header = 4 * (packet[0] & 15)
            source, target, length, _ = struct.unpack(">HHHH", packet[header:header + 8])
            body = packet[header + 8:header + length]
            print(f"{socket.inet_ntoa(packet[12:16])}:{source} {socket.inet_ntoa(packet[16:20])}:{target} {body.hex()}")


def send():
    with socket.socket(socket.AF_INET, socket.SOCK_RAW, socket.IPPROTO_RAW) as wire:
        for line in sys.stdin:
            source, target, *body = line.split()
            (source, source_port), (target, target_port) = (end.rsplit(":", 1) for end in (source, target))
            body = bytes.fromhex(body[0]) if body else b""
            udp = struct.pack(">HHHH", int(source_port), int(target_port), 8 + len(body), 0)  # no checksum
            header = struct.pack(">BBHHHBBH4s4s", 0x45, 0, 28 + len(body), 0, 0, 64, socket.IPPROTO_UDP, 0,
                                 socket.inet_aton(source), socket.inet_aton(target))
            wire.sendto(header + udp + body, (target, 0))


if __name__ == "__main__":
    send() if sys.argv[1] == "send" else hear(float(sys.argv[2]))
