#!/usr/bin/env python3
"""Killed and started again: server, left eye, right eye or both eyes, in an order drawn from a seed, and each time both
eyes have to show equal states within a second. Then the same half as often for eyes alone and the server alone, after
which who survived has to be what it was: memory, descriptors, threads.

What is measured: from the moment that the last of those started again is ready (an eye: its first picture; the server:
its line "listening on") to the first frame that both eyes drew from equal states. The server writes how many there are
every half second; as frames follow each other by at least FRAME_S, n of them began no later than (n - 1) FRAME_S before.
That bound is what is printed and judged.

COHERENCY_RESTARTS=200 for the long run, COHERENCY_SEED for another order, COHERENCY_RESTART_LIMIT_S for slow machines.
"""
import os
import pathlib
import random
import re
import signal
import statistics
import time
import unittest

from session import CLIENT, ROOT, SERVER, SessionTest

RESTARTS = int(os.environ.get("COHERENCY_RESTARTS", "12"))
SEED = int(os.environ.get("COHERENCY_SEED", "1"))
LIMIT_S = float(os.environ.get("COHERENCY_RESTART_LIMIT_S", "1"))
FRAME_S = 0.016
WARM_UP = 3  # rounds: buffers grow to their size
MOST_GROWTH_KB = 2048
MOST_GROWTH_A_ROUND_KB = 40
VICTIMS = {"server": ["server"], "left": ["left"], "right": ["right"], "both": ["left", "right"]}


class Usage:
    """What a process holds. The smallest of some looks: a lookup of a name takes a thread for a moment."""

    def __init__(self, pid):
        looks = [self.look(pathlib.Path(f"/proc/{pid}")) for _ in range(5)]
        self.rss_kb, self.descriptors, self.threads = (min(one) for one in zip(*looks))

    @staticmethod
    def look(process):
        time.sleep(0.02)
        status = dict(line.split(":\t", 1) for line in (process / "status").read_text().splitlines() if ":\t" in line)
        return int(status["VmRSS"].split()[0]), len(os.listdir(process / "fd")), int(status["Threads"])

    def __str__(self):
        return f"{self.rss_kb} kB, {self.descriptors} descriptors, {self.threads} threads"


class Restart(SessionTest):
    def setUp(self):
        super().setUp()
        self.programs, self.since, self.address, self.took = {}, {}, "127.0.0.1:0", []
        for name in ("server", "left", "right"):
            self.begin(name)
        self.equal_after(0.0, 0)

    def begin(self, name):
        if name == "server":
            stats = self.folder / "server.json"
            stats.unlink(missing_ok=True)
            process = self.start(name, SERVER, "--config", ROOT / "configs/servers/laboratory.toml", "--listen", self.address,
                                 "--stats-json", stats)
            self.address = self.until(lambda: re.search(r"^listening on (\S+)", process.text(), re.M), 10, process).group(1)
        else:
            process = self.start(name, CLIENT, "--server", self.address, "--eye", name, "--display", "headless", "--size",
                                 "64x48", "--samples", "1", "--stats-json", self.folder / f"{name}.json")
        self.programs[name] = process
        self.since[name] = time.time()

    def agreeing(self):
        """(frames, when that was written) by the server."""
        stats = self.stats("server")
        if stats is None:
            return 0, 0.0
        self.assertEqual(stats["stereo"]["differing"], {"tick": 0, "state": 0})
        self.assertEqual(stats["stereo"]["one_eye_only"]["mismatch"], 0)
        return stats["stereo"]["frames_agreeing"], (self.folder / "server.json").stat().st_mtime

    def first_picture(self, eye):
        """When it was, of an eye that has shown one since it began."""
        path = self.folder / f"{eye}.json"
        if not path.exists() or path.stat().st_mtime < self.since[eye]:
            return None
        stats = self.stats(eye)
        return self.since[eye] + stats["first_frame_ms"] / 1e3 if stats and stats["frames"] else None

    def equal_after(self, ready, before):
        """Waits for frames on which the eyes agree beyond `before`; the bound told above, from `ready` on."""
        frames, written = self.until(lambda: (now := self.agreeing())[0] > before and now, 30, self.programs["server"])
        return max(0.0, written - (frames - before - 1) * FRAME_S - ready)

    def round(self, who):
        victims = VICTIMS[who]
        for name in victims:
            self.programs[name].end(signal.SIGKILL)
            (self.folder / f"{name}.json").unlink(missing_ok=True)
        time.sleep(0.8)  # the server has told what was reported before
        before = self.agreeing()[0]
        for name in victims:
            self.begin(name)
        if who == "server":
            ready = self.since["server"]
        else:
            ready = max(self.until(lambda: self.first_picture(eye), 30, self.programs[eye]) for eye in victims)
        took = self.equal_after(ready, before)
        self.took.append(took)
        for eye in ("left", "right"):
            stats = self.stats(eye)
            if stats:
                self.assertEqual(stats["replica"]["hash_mismatches"], 0)
        return took

    def tell(self, what):
        late = [took for took in self.took if took > LIMIT_S]
        print(f"{what}, {len(self.took)} times (seed {SEED}, load {os.getloadavg()[0]:.1f} on {os.cpu_count()} processors): "
              f"equal again after median {statistics.median(self.took):.2f} s, at most {max(self.took):.2f} s")
        self.assertEqual(late, [], f"of {len(self.took)} so many took more than {LIMIT_S} s")

    def test_any_of_them_in_random_order(self):
        chance = random.Random(SEED)
        order = [chance.choice(list(VICTIMS)) for _ in range(RESTARTS)]
        for who in order:
            self.round(who)
        self.tell(f"killed in random order ({', '.join(f'{who} {order.count(who)}' for who in VICTIMS)})")

    def survives(self, who, survivors):
        """Rounds of a kind, after which the survivors hold what they held after the first few."""
        rounds = WARM_UP + max(2, RESTARTS // 4)
        for number in range(rounds):
            self.round(who[number % len(who)])
            if number + 1 == WARM_UP:
                before = {name: Usage(self.programs[name].process.pid) for name in survivors}
        self.tell(f"killed: {', '.join(who)}")
        for name in survivors:
            after = Usage(self.programs[name].process.pid)
            print(f"  {name} survived: {before[name]}; {rounds - WARM_UP} rounds later {after}")
            self.assertEqual(after.descriptors, before[name].descriptors)
            self.assertEqual(after.threads, before[name].threads)
            self.assertLess(after.rss_kb - before[name].rss_kb,
                            MOST_GROWTH_KB + MOST_GROWTH_A_ROUND_KB * (rounds - WARM_UP))

    def test_eyes_leave_nothing_behind_in_a_server(self):
        self.survives(["left", "both", "right"], ["server"])

    def test_servers_leave_nothing_behind_in_eyes(self):
        self.survives(["server"], ["left", "right"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
