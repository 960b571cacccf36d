#!/usr/bin/env python3
"""Draws the same scenes with this project, with OpenSceneGraph and with one bare multi-draw of the triangles that show (the
floor), all in turn, several rounds. Prints a table for each scene and writes all figures: medians over a round's frames, then
the median of the rounds and, in brackets, the least and the most. Ratios are taken within a round. All of 640x480, 4 samples.
"""
import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
OURS = "this project"
OSG = "OpenSceneGraph, optimiser"
FLOOR = "floor"
PEERS = {  # name: program and its options
    OURS: ["peer_ours"],
    FLOOR: ["peer_floor"],
    "floor, all in view": ["peer_floor", "--all-in-view"],
    "OpenSceneGraph": ["peer_osg"],
    "OpenSceneGraph, display lists": ["peer_osg", "--buffers", "lists"],
    OSG: ["peer_osg", "--optimizer", "default"],
    "OpenSceneGraph, optimiser in cells": ["peer_osg", "--optimizer", "cells"],
}
FIGURES = {"wall_ms": "frame, ms", "cpu_ms": "processor, ms", "update_ms": "update and clipping, ms",
           "startup_ms": "start-up, ms", "peak_mib": "memory, MiB"}
RATIOS = {  # heading: of which figure, against whom
    "processor: floor": ("cpu_ms", FLOOR), "processor: all in view": ("cpu_ms", "floor, all in view"),
    "processor: optimised": ("cpu_ms", OSG), "update: ours": ("update_ms", OURS)}


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    parser.add_argument("build", nargs="?", type=pathlib.Path, default=ROOT / "build/release", metavar="BUILD_FOLDER",
                        help="where the programs were built")
    parser.add_argument("--scenes", nargs="+", default=["grid:10000", "grid:10000@0", "grid:100000@0", "laboratory", "moving:10000"],
                        help="as peer_export has them; @RAYS: light with so many, 0: without shadows")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--frames", type=int, default=40, help="timed ones, of each peer in each round")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "out/peers", help="folder for pictures, tables, figures")
    given = parser.parse_args()
    given.programs = given.build.resolve() / "bench/peers"
    if not os.access(given.programs / "peer_ours", os.X_OK):
        parser.error(f"{given.programs}: no peers there; build with -DCOHERENCY_BENCH=ON")
    if not os.access(given.programs / "peer_osg", os.X_OK):
        print("without OpenSceneGraph: scripts/install_packages.sh bench, then configure and build again", file=sys.stderr)
        for name in [name for name, command in PEERS.items() if command[0] == "peer_osg"]:
            del PEERS[name]
    return given


def world(scene):
    name, _, rays = scene.partition("@")
    return [name, "--scenes", ROOT / "configs/scenes", *(["--rays", rays] if rays else [])]


def run(given, name, scene, *options):
    program, *own = PEERS[name]
    what = world(scene) if name == OURS else [given.out / f"{scene}.scene"]
    command = [given.programs / program, *what, *own, "--frames", str(given.frames), *options]
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, text=True)
    if done.returncode != 0:
        sys.exit(f"{program} {scene}: ended with {done.returncode}")
    result = json.loads(done.stdout)
    return {key: statistics.median(value) if isinstance(value, list) else value for key, value in result.items()}


def measure(given, scene):
    """{peer: [a round's figures]}; every peer's picture is compared with ours."""
    file, picture = given.out / f"{scene}.scene", given.out / f"{scene}.png"
    name, *options = world(scene)
    subprocess.run([given.programs / "peer_export", name, file, *options], check=True)
    run(given, OURS, scene, "--picture", picture)
    rounds = {name: [] for name in PEERS}
    for number in range(given.rounds):
        for name in PEERS:
            print(f"{scene}, round {number + 1}: {name}", file=sys.stderr)
            rounds[name].append(run(given, name, scene, "--compare", picture))
    file.unlink()
    return rounds


def spread(values):
    digits = 0 if statistics.median(values) >= 100 else 2
    return f"{statistics.median(values):.{digits}f} ({min(values):.{digits}f} to {max(values):.{digits}f})"


def ratio(rounds, name, figure, other):
    if other not in rounds:
        return "-"
    return spread([a[figure] / b[figure] for a, b in zip(rounds[name], rounds[other])])


def table(scene, rounds):
    apart = "picture: most apart, share of pixels above 3"
    head = ["", *FIGURES.values(), *RATIOS, apart]
    lines = [f"### {scene}", "", "| " + " | ".join(head) + " |", "|---" * len(head) + "|"]
    for name, results in rounds.items():
        cells = [spread([result[key] for result in results]) for key in FIGURES]
        cells += [ratio(rounds, name, *what) for what in RATIOS.values()]
        differing = results[0]["difference"]
        cells.append(f"{differing['max']}, {differing['share_above_3']:.4%}")
        lines.append("| " + " | ".join([name, *cells]) + " |")
    return "\n".join(lines) + "\n"


def main():
    given = arguments()
    given.out.mkdir(parents=True, exist_ok=True)
    figures, tables = {}, []
    for scene in given.scenes:
        figures[scene] = measure(given, scene)
        tables.append(table(scene, figures[scene]))
        print(tables[-1])
        (given.out / "peers.json").write_text(json.dumps(figures, indent=1))
        (given.out / "peers.md").write_text("\n".join(tables))


if __name__ == "__main__":
    main()
