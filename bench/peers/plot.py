#!/usr/bin/env python3
"""Plots what a frame costs this project's renderer by the number of fixed objects (a grid of boxes, light without shadows):
with all about the eye in view, with a twentieth, and with a hundred of them, the others elsewhere. Needs python3-matplotlib.
"""
import argparse
import json
import pathlib
import statistics
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
LOOKS = {  # name: how many of so many boxes are in view, and how it is drawn
    "all in view": (lambda count: count, "tab:red"),
    "a twentieth in view": (lambda count: count // 20, "tab:green"),
    "100 in view, the others elsewhere": (lambda count: 100, "tab:blue"),
}


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    parser.add_argument("build", nargs="?", type=pathlib.Path, default=ROOT / "build/release", metavar="BUILD_FOLDER",
                        help="where peer_ours was built")
    parser.add_argument("--counts", type=int, nargs="+", default=[100, 1000, 10_000, 100_000, 1_000_000])
    parser.add_argument("--frames", type=int, default=15)
    parser.add_argument("--figures", type=pathlib.Path, default=ROOT / "out/peers/cost.json",
                        help="where they are written, or read from where they are there")
    parser.add_argument("--plot", type=pathlib.Path, default=ROOT / "docs/pictures/cost.png")
    return parser.parse_args()


def measure(given):
    """{look: {count: figures}}"""
    program = given.build.resolve() / "bench/peers/peer_ours"
    figures = {name: {} for name in LOOKS}
    for count in given.counts:
        for name, (in_view, _) in LOOKS.items():
            command = [program, f"grid:{count}", "--scenes", ROOT / "configs/scenes", "--rays", 0, "--in-view",
                       max(in_view(count), 1), "--frames", given.frames, "--warm-up", 3]
            done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, text=True, check=True)
            figures[name][count] = json.loads(done.stdout)
            print(f"{count}, {name}:", ", ".join(f"{key} {middle(value):.4g}" for key, value in figures[name][count].items()))
    return figures


def middle(value):
    return statistics.median(value) if isinstance(value, list) else value


def plot(figures, path):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(figsize=(7.5, 5.0))
    for name, by_count in figures.items():
        counts = sorted(by_count, key=int)
        for key, style, what in (("cpu_ms", "o-", "frame, all threads"), ("update_ms", "s--", "before the GPU draws")):
            axes.plot([int(count) for count in counts], [middle(by_count[count][key]) for count in counts], style,
                      color=LOOKS[name][1], label=f"{name}: {what}")
    axes.axhline(1.0, color="grey", linewidth=0.8)
    axes.set(xscale="log", yscale="log", xlabel="fixed objects in the scene", ylabel="processor time a frame, ms",
             title="Cost by number of objects (640x480, 4 samples, llvmpipe)")
    axes.grid(True, which="major", alpha=0.4)
    axes.legend(fontsize="small", loc="upper left")
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def main():
    given = arguments()
    if not given.figures.exists():
        given.figures.parent.mkdir(parents=True, exist_ok=True)
        given.figures.write_text(json.dumps(measure(given), indent=1))
    plot(json.loads(given.figures.read_text()), given.plot)


if __name__ == "__main__":
    main()
