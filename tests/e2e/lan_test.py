#!/usr/bin/env python3
"""A session of three hosts (lan.py)."""
import lan
from coherency_check import eye_faults, read_png, server_faults, stereo_faults
from lan import HOSTS
from session import CLIENT, ROOT, SERVER


class Lan(lan.LanTest):
    def test_three_hosts(self):
        key = self.folder / "session.key"
        self.assertEnds(self.start("key", SERVER, "--make-key", key), 0)
        server = self.start("server", SERVER, "--config", ROOT / "configs/servers/lan.toml", "--key", key, "--stats-json",
                            self.folder / "server.json", prefix=self.on("server"))
        self.until(lambda: "listening on 0.0.0.0:7430" in server.text(), 10, server)
        eyes = {eye: self.start(eye, CLIENT, "--server", HOSTS["server"], "--key", key, "--eye", eye, "--display", "headless", "--fps",
                                "25", "--size", "320x240", "--duration", "12", "--snapshot-dir", self.folder,
                                "--snapshot-at", "9", "--stats-json", self.folder / f"{eye}.json", prefix=self.on(eye))
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
    lan.main()
