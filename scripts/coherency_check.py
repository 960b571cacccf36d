#!/usr/bin/env python3
"""Says in words how a session of a motion server and two eyes went, and whether it is as it should be.

Reads server.json, left.json, right.json (what --stats-json writes), left.png and right.png or left_1.png and so on
(--snapshot-dir, --snapshot-at) from one folder; writes stereo.png or stereo_1.png and so on there. Exit status 0: all is well; 1: something is wrong, which is then named; 2: bad arguments.
Needs nothing but Python's standard library.
"""
import argparse
import json
import pathlib
import struct
import sys
import time
import zlib


def read_png(path):
    """(width, height, rows of RGB bytes, text chunks) of an 8-bit RGB picture without interlacing."""
    data = path.read_bytes()
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        raise ValueError(f"{path}: not a PNG")
    at, packed, text = 8, b"", {}
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colour, _, _, interlace = struct.unpack(">IIBBBBB", body)
            if (depth, colour, interlace) != (8, 2, 0):
                raise ValueError(f"{path}: not 8-bit RGB")
        elif kind == b"IDAT":
            packed += body
        elif kind == b"tEXt":
            key, value = body.split(b"\0", 1)
            text[key.decode("latin-1")] = value.decode("latin-1")
        at += 12 + length
    raw, stride, rows = zlib.decompress(packed), width * 3, []
    previous = bytearray(stride)
    for y in range(height):
        start = y * (stride + 1)
        previous = unfilter(raw[start], raw[start + 1:start + 1 + stride], previous)
        rows.append(bytes(previous))
    return width, height, rows, text


def unfilter(kind, line, above):
    """One row of PNG filtering undone (PNG specification, section 9)."""
    row = bytearray(line)
    for i in range(len(row)):
        left = row[i - 3] if i >= 3 else 0
        up = above[i]
        if kind == 1:
            row[i] = (row[i] + left) & 255
        elif kind == 2:
            row[i] = (row[i] + up) & 255
        elif kind == 3:
            row[i] = (row[i] + (left + up) // 2) & 255
        elif kind == 4:
            corner = above[i - 3] if i >= 3 else 0
            estimate = left + up - corner
            near = min((abs(estimate - left), 0, left), (abs(estimate - up), 1, up),
                       (abs(estimate - corner), 2, corner))
            row[i] = (row[i] + near[2]) & 255
    return row


def write_png(path, width, height, rows):
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    raw = b"".join(b"\0" + row for row in rows)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
                     chunk(b"IDAT", zlib.compress(raw, 6)) + chunk(b"IEND", b""))


def picture_faults(name, rows):
    """A picture that shows something has many colours and no one of them nearly everywhere."""
    pixels = [rows[y][x:x + 3] for y in range(0, len(rows), 3) for x in range(0, len(rows[y]), 9)]
    counts = {}
    for pixel in pixels:
        counts[pixel] = counts.get(pixel, 0) + 1
    share = max(counts.values()) / len(pixels)
    if len(counts) < 50 or share > 0.9:
        yield f"{name}.png shows nothing: {len(counts)} colours, one of them on {share:.0%} of the picture"


def moments(folder):
    """What the pictures' names end with: "" for left.png and right.png, "_1", "_2" ... for those of several moments."""
    found = {path.stem.removeprefix(name) for name in ("left", "right") for path in folder.glob(f"{name}*.png")}
    return sorted(found) or [""]


def stereo_faults(folder, moment, since=None):
    pictures = {}
    for name in (f"left{moment}", f"right{moment}"):
        path = folder / f"{name}.png"
        if not path.exists() or (since is not None and path.stat().st_mtime < since):
            yield f"{path} is missing: that eye drew no picture"
            continue
        pictures[name] = read_png(path)
        yield from picture_faults(name, pictures[name][2])
    if len(pictures) < 2:
        return
    left, right = pictures.values()
    if left[:2] != right[:2]:
        yield f"the pictures{moment} differ in size: {left[:2]} and {right[:2]}"
        return
    if left[2] == right[2]:
        yield f"left{moment}.png and right{moment}.png are the same picture: the eyes stand in one place"
    for key in ("tick", "hash"):
        if left[3].get(key) != right[3].get(key):
            yield f"the pictures{moment} are not of one moment: {key} {left[3].get(key)} and {right[3].get(key)}"
    write_png(folder / f"stereo{moment}.png", 2 * left[0], left[1], [a + b for a, b in zip(left[2], right[2])])


def eye_faults(name, eye):
    packets = eye["packets"]
    if eye["frames"] < 10:
        yield f"the {name} eye drew only {eye['frames']} frames"
    if eye["replica"]["hash_mismatches"]:
        yield f"the {name} eye's replica differed from the server {eye['replica']['hash_mismatches']} times"
    if packets["lost"]:
        yield f"the {name} eye lost {packets['lost']} of {packets['received'] + packets['lost']} packets"
    if packets["rejected"]:
        yield f"the {name} eye refused {packets['rejected']} packets"
    if eye["motion_age_ms"] > 500:
        yield f"the {name} eye has had no motion for {eye['motion_age_ms']:.0f} ms: is the server alive?"
    if eye["connections"] != 1:
        yield f"the {name} eye connected {eye['connections']} times"


def server_faults(server):
    # Missed periods are counted and made up for; half of them missed is no working server.
    wanted = server["duration_s"] * server["nominal_rate_hz"]
    if server["samples"] < 0.5 * wanted:
        yield f"the server took {server['samples']} samples where {wanted:.0f} were due"
    stereo = server["stereo"]
    if stereo["frames_compared"] < 3:
        yield f"only {stereo['frames_compared']} frames were drawn by both eyes"
    elif stereo["frames_agreeing"] < stereo["frames_compared"]:
        yield (f"only {stereo['frames_agreeing']} of {stereo['frames_compared']} frames agree between the eyes: "
               f"{stereo['differing']['tick']} were of two moments, {stereo['differing']['state']} of two states")


def counted(number, what):
    return f"{number} {what}" + ("" if number == 1 else "s")


def is_software(renderer):
    return any(name in renderer.lower() for name in ("llvmpipe", "softpipe", "swrast"))


def describe(server, eyes):
    print(f"server: {server['samples']} samples of {server['master']} at {server['rate_hz']:.0f} Hz, "
          f"period jitter {server['period_jitter_us']['p50']:.0f} us median, "
          f"{server['period_jitter_us']['p99']:.0f} us p99, {counted(server['missed'], 'period')} missed")
    for name, eye in eyes.items():
        latency = eye["motion_to_present_ms"]
        print(f"{name} eye: {eye['frames']} frames of {eye['size'][0]}x{eye['size'][1]}, {eye['fps']:.1f} a second, "
              f"{eye['frame_ms']['p50']:.1f} ms each; motion to picture {latency['p50']:.1f} ms median, "
              f"{latency['p99']:.1f} ms p99; {eye['packets']['received']} packets, {eye['packets']['lost']} lost")
    for renderer in sorted({eye["renderer"] for eye in eyes.values()}):
        print(f"drawn by {renderer}" + ("; this is software, a GPU is faster" if is_software(renderer) else ""))
    task = server["task"]
    if task["towers"]:
        print(f"task: {counted(task['towers'], 'tower')} of three blocks, the last {task['tower_s'] - task['started_s']:.1f} s after "
              f"the joystick first moved, as {server['mode']}")
    stereo = server["stereo"]
    frames = server["frames"]
    one_eyed = ", ".join(f"{count} {cause.replace('_', ' ')}" for cause, count in stereo["one_eye_only"].items() if count)
    print(f"both eyes: {stereo['frames_compared']} frames drawn by both, {stereo['frames_agreeing']} of them from the same "
          f"state, shown {stereo['present_skew_us']['p50'] / 1000:.2f} ms apart at the median; drawn by one eye alone: "
          f"{one_eyed or 'none'}")
    print(f"frames: {frames['hz']:.1f} a second, seen {frames['margin_ms']:.0f} ms after their moment, predicted by "
          f"{server['prediction']['kind']}")


def load(folder, name, since):
    path = folder / f"{name}.json"
    try:
        if since is not None and path.stat().st_mtime < since:
            return None
        return json.loads(path.read_text())
    except (OSError, ValueError):
        return None


def watch(folder, seconds, since):
    """Waits until all three have reported, and then for `seconds` more; faults of waiting are returned."""
    deadline = time.monotonic() + 60
    names = ("server", "left", "right")
    while not all(load(folder, name, since) for name in names):
        if time.monotonic() > deadline:
            missing = [name for name in names if not load(folder, name, since)]
            return [f"no statistics of {name} within 60 s" for name in missing]
        time.sleep(0.2)
    time.sleep(seconds)
    late = [name for name in names if time.time() - (folder / f"{name}.json").stat().st_mtime > 3]
    return [f"{name} has reported nothing for 3 s: it has ended or hangs" for name in late]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path, help="where statistics and pictures are")
    parser.add_argument("--watch", type=float, metavar="S",
                        help="the session is running: wait for it, look on for S seconds, then judge")
    parser.add_argument("--tower", action="store_true", help="the task must have been done: a tower of three blocks stood")
    arguments = parser.parse_args()
    if not arguments.folder.is_dir():
        parser.error(f"{arguments.folder}: no such folder")
    since = time.time() - 5 if arguments.watch is not None else None
    faults = watch(arguments.folder, arguments.watch, since) if arguments.watch is not None else []
    server = load(arguments.folder, "server", since)
    eyes = {name: load(arguments.folder, name, since) for name in ("left", "right")}
    faults += [f"{name}.json is missing or unreadable" for name, stats in {"server": server, **eyes}.items()
               if stats is None]
    if server and all(eyes.values()):
        describe(server, eyes)
        faults += server_faults(server)
        for name, eye in eyes.items():
            faults += eye_faults(name, eye)
    if server and arguments.tower and not server["task"]["towers"]:
        faults.append("no tower of three blocks was built")
    for moment in moments(arguments.folder):
        faults += stereo_faults(arguments.folder, moment, since)
    for fault in faults:
        print(f"WRONG: {fault}")
    print("verdict: " + ("all is well" if not faults else counted(len(faults), "fault")))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
