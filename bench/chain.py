#!/usr/bin/env python3
"""The chain's figures in one run: latency beside bare UDP, server's CPU with two clients, time to the first frame, frame
time of an eye at 640x480 and at 1280x1440. Prints medians; several rounds show the spread.
"""
import argparse
import json
import os
import pathlib
import re
import statistics
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
ENVIRONMENT = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}


PROGRAMS = ("bench/bench_latency", "motion_server/motion_server", "render_client/render_client")


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", nargs="?", type=pathlib.Path, default=ROOT / "build/release", metavar="BUILD_FOLDER",
                        help="where the programs were built [build/release]")
    build = parser.parse_args().build.resolve()
    missing = [str(build / name) for name in PROGRAMS if not os.access(build / name, os.X_OK)]
    if missing:
        parser.error(f"{', '.join(missing)}: not there; build with -DCOHERENCY_BENCH=ON, as scripts/test.sh does, or name "
                     "the folder of another build")
    return build


def start_server(build, folder):
    """Offers frames every 4 ms: eyes are held back by their drawing alone."""
    log = folder / "server.log"
    config = folder / "server.toml"
    config.write_text(f'scene = "{ROOT}/configs/scenes/laboratory.toml"\nrig = "{ROOT}/configs/rigs/default.toml"\n'
                      "[frames]\nhz = 250.0\n")
    with open(log, "wb") as stderr:
        server = subprocess.Popen([build / "motion_server/motion_server", "--config",
                                   config, "--listen", "127.0.0.1:0", "--stats-json",
                                   folder / "server.json"], stderr=stderr)
    while not (found := re.search(r"listening on (\S+)", log.read_text())):
        time.sleep(0.02)
    return server, found.group(1)


def cpu_seconds(pid):
    fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def start_eye(build, folder, address, eye, size, fps, seconds):
    return subprocess.Popen([build / "render_client/render_client", "--server", address, "--eye", eye, "--display",
                             "headless", "--size", size, "--fps", str(fps), "--duration", str(seconds), "--stats-json",
                             folder / f"{eye}.json"], stderr=subprocess.DEVNULL, env=ENVIRONMENT)


def round_of(build, folder, size, fps, eyes, seconds=8):
    """(server's CPU share, statistics of each eye, of the server)."""
    server, address = start_server(build, folder)
    try:
        clients = [start_eye(build, folder, address, eye, size, fps, seconds) for eye in eyes]
        time.sleep(2)
        before, begun = cpu_seconds(server.pid), time.monotonic()
        time.sleep(seconds - 4)
        share = (cpu_seconds(server.pid) - before) / (time.monotonic() - begun)
        for client in clients:
            client.wait(30)
        return share, [json.loads((folder / f"{eye}.json").read_text()) for eye in eyes]
    finally:
        server.terminate()
        server.wait()


def spread(values):
    return f"{statistics.median(values):.2f} (from {min(values):.2f} to {max(values):.2f}, {len(values)} runs)"


def main():
    build = arguments()
    print(f"machine: {os.cpu_count()} cores, {open('/proc/cpuinfo').read().split('model name')[1].split(':')[1].splitlines()[0].strip()}")
    subprocess.run([build / "bench/bench_latency", "--seconds", "10"], check=True)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        rounds = [round_of(build, folder, "160x120", 10, ("left", "right")) for _ in range(3)]
        print("server's CPU at 1 kHz with two clients, % of a core:", spread([100 * r[0] for r in rounds]))
        print("start to first frame, ms:", spread([e["first_frame_ms"] for r in rounds for e in r[1]]))
        for size in ("640x480", "1280x1440"):
            alone = [round_of(build, folder, size, 1000, ("left",))[1][0] for _ in range(3)]
            print(f"one eye alone at {size}, as fast as it goes: frame, ms:", spread([e["frame_ms"]["p50"] for e in alone]),
                  " frames a second:", spread([e["fps"] for e in alone]))
            both = [e for _ in range(3) for e in round_of(build, folder, size, 1000, ("left", "right"))[1]]
            print(f"both eyes on this machine at {size}: frame, ms:", spread([e["frame_ms"]["p50"] for e in both]),
                  " frames a second:", spread([e["fps"] for e in both]))
        print("renderer:", alone[0]["renderer"])


if __name__ == "__main__":
    main()
