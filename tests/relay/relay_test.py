#!/usr/bin/env python3
"""The impairing relay between clients and an echo of UDP and TCP, all on loopback. Python's standard library only."""
import contextlib
import hashlib
import json
import math
import os
import pathlib
import random
import selectors
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
RELAY = os.environ.get("COHERENCY_RELAY", ROOT / "build/release/tests/relay/impairing_relay")
SERVER_HOST, RELAY_HOST = "127.0.0.1", "127.0.0.2"
MEBIBYTE = random.Random(1).randbytes(1 << 20)


class Echo:
    """UDP and TCP on one port; what a TCP connection brings is sent back after its end, on the half still open."""

    def __init__(self):
        self.tcp = socket.create_server((SERVER_HOST, 0), backlog=512)
        self.port = self.tcp.getsockname()[1]
        self.udp = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.udp.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4 << 20)
        self.udp.bind((SERVER_HOST, self.port))
        self.waking, self.wake = socket.socketpair()
        self.threads = [threading.Thread(target=run) for run in (self.echo_udp, self.accept)]
        for thread in self.threads:
            thread.start()

    def until_closed(self, listened):
        with selectors.DefaultSelector() as selector:
            for one in (listened, self.waking):
                selector.register(one, selectors.EVENT_READ)
            while self.waking not in (ready := [key.fileobj for key, _ in selector.select()]):
                yield from ready

    def echo_udp(self):
        for ready in self.until_closed(self.udp):
            data, address = ready.recvfrom(65536)
            ready.sendto(data, address)

    def accept(self):
        for ready in self.until_closed(self.tcp):
            threading.Thread(target=self.echo_tcp, args=(ready.accept()[0],), daemon=True).start()

    def echo_tcp(self, connection):
        with connection, contextlib.suppress(OSError):
            connection.sendall(b"".join(iter(lambda: connection.recv(65536), b"")))

    def close(self):
        self.wake.send(b"x")
        for thread in self.threads:
            thread.join()
        for one in (self.tcp, self.udp, self.waking, self.wake):
            one.close()


class RelayTest(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory(prefix="coherency_")))
        self.echo = Echo()
        self.addCleanup(self.echo.close)
        self.port = self.echo.port
        self.relay = None
        self.addCleanup(self.end)

    def start(self, *options):
        """The relay once it listens. It ends with this process, whatever happens, as its input does."""
        self.relay = subprocess.Popen(
            [RELAY, "--listen", f"{RELAY_HOST}:{self.port}", "--server", f"{SERVER_HOST}:{self.port}", "--stats-json",
             self.folder / "relay.json", "--until-stdin-closes", *map(str, options)],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertIn("listening on", self.relay.stderr.readline())

    def say(self, line):
        self.relay.stdin.write(line + "\n")
        self.relay.stdin.flush()
        return self.relay.stdout.readline().strip()

    def end(self):
        """Statistics at the end, which is a clean one."""
        if self.relay is None:
            return None
        with self.relay as relay:
            self.relay = None
            relay.stdin.close()
            self.assertEqual(relay.wait(10), 0)
            self.assertEqual(relay.stderr.read(), "")
        return json.loads((self.folder / "relay.json").read_text())

    def udp(self):
        client = self.enterContext(socket.socket(socket.AF_INET, socket.SOCK_DGRAM))
        client.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4 << 20)
        client.connect((RELAY_HOST, self.port))
        return client

    def tcp(self):
        client = self.enterContext(socket.create_connection((RELAY_HOST, self.port), timeout=20))
        return client

    def exchange(self, client, datagrams, at_once=50, silence=0.2):
        """All that came back until nothing more did."""
        back = []
        for begin in range(0, len(datagrams), at_once):
            group = datagrams[begin:begin + at_once]
            for datagram in group:
                client.send(datagram)
            back += self.received(client, len(group), 0.02)
        return back + self.received(client, len(datagrams), silence)

    @staticmethod
    def received(client, count, silence):
        got = []
        client.settimeout(silence)
        with contextlib.suppress(TimeoutError):
            while len(got) < count:
                got.append(client.recv(65536))
        return got


def numbered(count, size=40):
    return [n.to_bytes(4, "big") * (size // 4) for n in range(count)]


class Udp(RelayTest):
    def test_without_impairment_all_comes_as_it_was_sent(self):
        self.start()
        datagrams = [random.Random(n).randbytes(size) for n, size in enumerate([0, 1, 1200, 9000, 65507] * 20)]
        self.assertEqual(self.exchange(self.udp(), datagrams, at_once=1), datagrams)
        stats = self.end()
        for direction in ("up", "down"):
            self.assertEqual(stats[direction]["datagrams"], len(datagrams))
            self.assertEqual(stats[direction]["sent"], len(datagrams))
            self.assertLess(stats[direction]["delay_ms"]["p50"], 5)

    def test_loss_is_within_its_bounds_and_the_same_for_a_seed(self):
        count, loss = 4000, 0.1
        runs = []
        for seed in (7, 7, 8):
            self.start("--seed", seed, "--loss", loss)
            runs.append(self.exchange(self.udp(), numbered(count)))
            stats = self.end()
            self.assertEqual(stats["up"]["datagrams"], count)
            self.assertEqual(stats["down"]["sent"], len(runs[-1]))
            self.assertEqual(stats["down"]["datagrams"], count - stats["up"]["dropped"]["loss"])
            for direction in ("up", "down"):
                of = stats[direction]["datagrams"]
                self.assertLess(abs(stats[direction]["dropped"]["loss"] - loss * of), 5 * math.sqrt(of * loss * (1 - loss)))
        self.assertEqual(runs[0], runs[1])
        self.assertNotEqual(runs[0], runs[2])

    def test_jitter_keeps_the_order_unless_told_otherwise(self):
        self.start("--jitter-ms", 5, "--delay-ms", 3)
        client = self.udp()
        begun = time.monotonic()
        datagrams = numbered(200)
        self.assertEqual(self.exchange(client, datagrams), datagrams)
        self.assertGreaterEqual(time.monotonic() - begun, 2 * 0.003)
        self.assertEqual(self.say("reorder on"), "ok")
        mixed = self.exchange(client, datagrams)
        self.assertNotEqual(mixed, datagrams)
        self.assertEqual(sorted(mixed), datagrams)
        stats = self.end()
        for direction in ("up", "down"):
            self.assertGreaterEqual(stats[direction]["delay_ms"]["p50"], 3)

    def test_duplicates_and_flipped_bits(self):
        self.start("--duplicate", 1)
        client = self.udp()
        client.send(b"once")
        self.assertEqual(self.received(client, 4, 2), [b"once"] * 4)
        self.assertEqual(self.say("duplicate 0"), "ok")
        self.assertEqual(self.say("corrupt 1"), "ok")
        (got,) = self.exchange(client, [bytes(100)])
        self.assertIn(int.from_bytes(got, "big").bit_count(), (0, 2))  # one bit on the way there, one on the way back
        stats = self.end()
        self.assertEqual((stats["up"]["duplicated"], stats["down"]["duplicated"]), (1, 2))
        self.assertEqual((stats["up"]["corrupted"], stats["down"]["corrupted"]), (1, 1))

    def test_blocked_and_opened_in_mid_session(self):
        self.start("--block-udp")
        client = self.udp()
        self.assertEqual(self.exchange(client, [b"a"] * 10), [])
        self.assertEqual(self.say("block-udp off"), "ok")
        self.assertEqual(self.exchange(client, [b"b"] * 10), [b"b"] * 10)
        self.assertEqual(self.say("loss 1"), "ok")
        self.assertEqual(self.say("impair off"), "ok")
        self.assertEqual(self.exchange(client, [b"c"] * 10), [b"c"] * 10)
        self.assertEqual(self.say("impair on"), "ok")
        self.assertEqual(self.exchange(client, [b"d"] * 10), [])
        now = json.loads(self.say("stats"))
        self.assertEqual(now["up"]["dropped"], {"loss": 10, "burst": 0, "blocked": 10})
        for wrong in ("loss 2", "lose 1", "impair maybe", ""):
            self.assertTrue(self.say(wrong).startswith("error: "), wrong)

    def test_a_burst_takes_everything(self):
        self.start("--burst-every-ms", 1, "--burst-ms", 1)
        self.assertEqual(self.exchange(self.udp(), [b"x"] * 50), [])
        self.assertEqual(self.end()["up"]["dropped"]["burst"], 50)

    def test_three_hundred_flows_leave_nothing_open(self):
        self.start("--flow-silence-s", 0.5)
        before, most = self.descriptors(), 0
        for n in range(300):
            self.assertEqual(self.echoed(self.udp(), n.to_bytes(4, "big")), n.to_bytes(4, "big"))
            most = max(most, self.descriptors())
        self.assertLessEqual(most, before + 256)
        deadline = time.monotonic() + 10
        while self.descriptors() > before and time.monotonic() < deadline:
            time.sleep(0.05)
        self.assertEqual(self.descriptors(), before)
        flows = self.end()["flows"]
        self.assertEqual((flows["opened"], flows["open"]), (300, 0))
        self.assertEqual(flows["expired"] + flows["evicted"], 300)

    def test_of_too_many_flows_the_most_silent_one_goes(self):
        self.start("--flow-silence-s", 60)
        clients = [self.udp() for _ in range(257)]
        for client in [*clients[:256], clients[0], clients[256]]:
            self.assertEqual(self.echoed(client, b"here"), b"here")
        flows = json.loads(self.say("stats"))["flows"]
        self.assertEqual((flows["opened"], flows["open"], flows["evicted"]), (257, 256, 1))
        self.echoed(clients[0], b"still here")
        self.assertEqual(json.loads(self.say("stats"))["flows"]["opened"], 257)
        self.echoed(clients[1], b"here again")
        self.assertEqual(json.loads(self.say("stats"))["flows"]["opened"], 258)

    @staticmethod
    def echoed(client, datagram):
        client.settimeout(5)
        client.send(datagram)
        return client.recv(100)

    def descriptors(self):
        return len(os.listdir(f"/proc/{self.relay.pid}/fd"))


class Tcp(RelayTest):
    def upload(self, client, data=MEBIBYTE):
        client.sendall(data)
        client.shutdown(socket.SHUT_WR)

    def download(self, client, pause=0.0):
        data = hashlib.sha256()
        while part := client.recv(65536):
            data.update(part)
            time.sleep(pause)
        return data.digest()

    def test_a_mebibyte_each_way_with_a_slow_reader(self):
        self.start("--loss", 1, "--corrupt", 1)  # of UDP alone
        client = self.tcp()
        client.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 65536)
        self.upload(client)
        self.assertEqual(self.download(client, pause=0.002), hashlib.sha256(MEBIBYTE).digest())
        client.close()
        stats = self.end()
        self.assertEqual((stats["up"]["tcp_bytes"], stats["down"]["tcp_bytes"]), (len(MEBIBYTE), len(MEBIBYTE)))

    def test_the_writer_stops_where_nobody_reads(self):
        with socket.create_server((SERVER_HOST, 0)) as server:
            self.port = server.getsockname()[1]
            self.start()
            client = self.tcp()
            client.settimeout(1)
            sent = 0
            with self.assertRaises(TimeoutError):
                while sent < 64 << 20:
                    sent += client.send(MEBIBYTE)
            self.assertLess(int(pathlib.Path(f"/proc/{self.relay.pid}/statm").read_text().split()[1]) * 4096, 64 << 20)

    def test_delay_holds_each_way_and_the_order(self):
        self.start("--tcp-delay-ms", 60)
        client = self.tcp()
        begun = time.monotonic()
        self.upload(client)
        self.assertEqual(self.download(client), hashlib.sha256(MEBIBYTE).digest())
        self.assertGreaterEqual(time.monotonic() - begun, 0.12)

    def test_a_cut_resets_all_and_new_ones_are_taken(self):
        self.start()
        clients = [self.tcp() for _ in range(5)]
        deadline = time.monotonic() + 5
        while json.loads(self.say("stats"))["tcp"]["connections"] < 5 and time.monotonic() < deadline:
            time.sleep(0.01)
        self.assertEqual(self.say("cut"), "ok")
        for client in clients:
            with self.assertRaises(ConnectionResetError):
                client.recv(1)
        again = self.tcp()
        self.upload(again, b"again")
        self.assertEqual(self.download(again), hashlib.sha256(b"again").digest())
        self.assertEqual(self.end()["tcp"], {"connections": 6, "refused": 0, "cut": 5})

    def test_without_a_server_a_client_is_reset(self):
        with socket.socket() as free:
            free.bind((SERVER_HOST, 0))
            self.port = free.getsockname()[1]
            self.start()
            with self.assertRaises(ConnectionError):
                self.tcp().recv(1)
            self.assertEqual(self.end()["tcp"]["refused"], 1)


class Ends(RelayTest):
    def test_signals_end_it_with_its_statistics(self):
        for how in (signal.SIGTERM, signal.SIGINT):
            self.start()
            self.relay.send_signal(how)
            self.assertEqual(self.relay.wait(10), 0)
            self.assertIn("up", self.end())

    def test_wrong_options_are_named(self):
        for options, named in ((["--listen", "127.0.0.2", "--server", "127.0.0.1:7430"], "--listen"),
                               (["--listen", "127.0.0.2:1", "--server", "nowhere:7430"], "nowhere"),
                               (["--listen", "127.0.0.2:7430"], "--server"),
                               (["--listen", "127.0.0.2:1", "--server", "127.0.0.1:1", "--loss", "nan"], "nan")):
            done = subprocess.run([RELAY, *options], capture_output=True, text=True, stdin=subprocess.DEVNULL)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(named, done.stderr)

    def test_a_port_in_use_is_named(self):
        done = subprocess.run([RELAY, "--listen", f"{SERVER_HOST}:{self.port}", "--server", f"{RELAY_HOST}:{self.port}"],
                              capture_output=True, text=True, stdin=subprocess.DEVNULL)
        self.assertEqual(done.returncode, 1)
        self.assertIn(f"{SERVER_HOST}:{self.port}: Address already in use", done.stderr)


if __name__ == "__main__":
    if not os.access(RELAY, os.X_OK):
        sys.exit(f"{RELAY}: not there; build impairing_relay, or name it in COHERENCY_RELAY")
    unittest.main(verbosity=2)
