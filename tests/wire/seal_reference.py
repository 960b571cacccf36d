#!/usr/bin/env python3
"""Handshake and seals computed a second time and on its own, with python3-nacl: prints the values that
HandshakeTest.cpp, SealedDatagramTest.cpp and SealedStreamTest.cpp have. Shares no code with the program.
"""
from nacl import bindings


def blake2b(message, key=b"", salt=b"", personal=b""):
    return bindings.crypto_generichash_blake2b_salt_personal(message, 32, key, salt, personal)


def connection_keys(secret, other, preshared, client_opening, server_opening):
    shared = bindings.crypto_scalarmult(secret, other)
    master = blake2b(b"coherency 3" + shared + blake2b(client_opening) + blake2b(server_opening), key=preshared)
    return [
        blake2b(b"", key=master, salt=number.to_bytes(8, "little").ljust(16, b"\0"), personal=b"coherncy".ljust(16, b"\0"))
        for number in range(1, 5)
    ]


def sealed(key, channel, counter, header, body):
    nonce = channel.to_bytes(4, "big") + counter.to_bytes(8, "big")
    return header + bindings.crypto_aead_chacha20poly1305_ietf_encrypt(body, header, nonce, key)


def sealed_datagram(key, channel, counter, body):
    header = b"COH\x03" + channel.to_bytes(4, "big") + counter.to_bytes(8, "big")
    return sealed(key, channel, counter, header, body)


def sealed_message(key, number, body):
    return sealed(key, 0, number, b"\x01", body)


def main():
    client_secret, server_secret = bytes(range(32)), bytes(range(32, 64))
    client_public = bindings.crypto_scalarmult_base(client_secret)
    server_public = bindings.crypto_scalarmult_base(server_secret)
    print("client public   ", client_public.hex())
    print("server public   ", server_public.hex())
    for name, preshared in (("64..95", bytes(range(64, 96))), ("none", bytes(32))):
        openings = b"client opening", b"server opening"
        keys = connection_keys(client_secret, server_public, preshared, *openings)
        assert keys == connection_keys(server_secret, client_public, preshared, *openings)
        print("pre-shared", name)
        for who, key in zip(("client_control", "server_control", "client_datagrams", "server_datagrams"), keys):
            print(f"{who:16}", key.hex())
    key = bytes(range(32))
    print("datagram 1      ", sealed_datagram(key, 0x01020304, 1, b"coherency").hex())
    print("datagram 2      ", sealed_datagram(key, 0x01020304, 2, b"coherency").hex())
    print("message 0       ", sealed_message(key, 0, b"coherency").hex())
    print("message 1       ", sealed_message(key, 1, b"coherency").hex())


main()
