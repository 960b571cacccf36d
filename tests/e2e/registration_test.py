#!/usr/bin/env python3
"""The pictures show the arm where a recording of real motion says it is.

A server replays a recording, two eyes draw the scene `targets` at a moment, and the centres of the markers in the two
pictures are compared, to 0.1 px, with a kinematics and a projection written here from the recordings' README and the
rig's measures alone.
"""
import csv
import math
import sys
import tomllib
import unittest

from session import MOTION_DATA, ROOT, SessionTest
from coherency_check import read_png

WIDTH, HEIGHT = 1280, 1440
RECORDING = MOTION_DATA / "cmu_29_07_hand_signals.csv"


def mul(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def apply(m, v):
    return [sum(m[i][k] * v[k] for k in range(3)) for i in range(3)]


def transposed(m):
    return [list(row) for row in zip(*m)]


def add(a, b):
    return [x + y for x, y in zip(a, b)]


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def about(axis, angle):
    """Rodrigues' rotation."""
    n = math.sqrt(sum(c * c for c in axis))
    x, y, z = (c / n for c in axis)
    c, s = math.cos(angle), math.sin(angle)
    v = 1 - c
    return [[c + x * x * v, x * y * v - z * s, x * z * v + y * s],
            [y * x * v + z * s, c + y * y * v, y * z * v - x * s],
            [z * x * v - y * s, z * y * v + x * s, c + z * z * v]]


def from_quaternion(w, x, y, z):
    n = math.sqrt(w * w + x * x + y * y + z * z)
    angle = 2 * math.atan2(math.sqrt(x * x + y * y + z * z) / n, w / n)
    return about((x, y, z), angle) if angle else about((1, 0, 0), 0)


def slerp(a, b, s):
    d = sum(p * q for p, q in zip(a, b))
    if d < 0:
        b, d = [-q for q in b], -d
    if d > 0.9999999:
        return [p + s * (q - p) for p, q in zip(a, b)]
    t = math.acos(d)
    return [(math.sin((1 - s) * t) * p + math.sin(s * t) * q) / math.sin(t) for p, q in zip(a, b)]


class Recording:
    def __init__(self, path):
        with open(path) as file:
            self.rows = [[float(v) for v in row] for row in list(csv.reader(file))[1:]]

    def at(self, t):
        """(head position, head quaternion w x y z, seven joints) by interpolation."""
        after = next(i for i, row in enumerate(self.rows) if row[0] >= t)
        if after == 0:
            after = 1
        a, b = self.rows[after - 1], self.rows[after]
        s = (t - a[0]) / (b[0] - a[0])
        linear = [p + s * (q - p) for p, q in zip(a, b)]
        return linear[1:4], slerp(a[4:8], b[4:8], s), linear[8:15]


class Model:
    """Wrist and palm in the body frame, eyes, and the picture; from the formulas, not from the project's code."""

    def __init__(self, rig, recording):
        self.rig = rig
        first = recording.rows[0][1:4]
        neutral = [0.0, rig["seat_height"] + rig["trunk_length"] + rig["neck_length"], -rig["neck_back"]]
        self.shift = sub(neutral, first)

    def head(self, position, quaternion):
        return from_quaternion(*quaternion), add(position, self.shift)

    def arm(self, position, quaternion, joints):
        """(wrist, palm) in the body frame."""
        rig = self.rig
        r_head, p_head = self.head(position, quaternion)
        neck = add(p_head, apply(r_head, [0, -rig["neck_length"], rig["neck_back"]]))
        up = sub(neck, [0, rig["seat_height"], 0])
        axis = [up[2], 0.0, -up[0]]  # y x up
        lean = math.atan2(math.hypot(up[0], up[2]), up[1])
        thorax = about(axis, lean) if lean > 1e-12 else about((1, 0, 0), 0)
        shoulder = add(neck, apply(thorax, [rig["shoulder_half_width"], -rig["shoulder_drop"], 0]))
        u, b = rig["shoulder_tilt_up"], rig["shoulder_tilt_back"]
        a1 = [math.cos(u) * math.cos(b), math.sin(u), math.cos(u) * math.sin(b)]
        a3 = [-math.sin(u) * math.cos(b), math.cos(u), -math.sin(u) * math.sin(b)]
        a2 = [-math.sin(b), 0, math.cos(b)]
        base = transposed([a1, a3, a2])
        hinge = [0, math.sqrt(3) / 2, 0.5]
        # H0: +x -> -y, hinge -> +x, x cross hinge -> +z; as (images) * (originals)^T
        h0 = mul(transposed([[0, -1, 0], [1, 0, 0], [0, 0, 1]]), [[1, 0, 0], hinge, [0, -0.5, math.sqrt(3) / 2]])
        x, y, z = (1, 0, 0), (0, 1, 0), (0, 0, 1)
        j = joints
        upper = mul(mul(mul(mul(base, about(x, j[0])), about(z, j[1])), about(y, j[2])), h0)
        fore = mul(upper, about(hinge, j[3]))
        hand = mul(mul(mul(fore, about(x, j[4])), about(y, j[6])), about(z, j[5]))
        wrist = add(apply(upper, [rig["upper_arm"], 0, 0]), apply(fore, [rig["forearm"], 0, 0]))
        palm = add(wrist, apply(hand, [rig["hand"], 0, 0]))
        return tuple(add(shoulder, apply(thorax, p)) for p in (wrist, palm))

    def in_eye(self, position, quaternion, point, side):
        """A body-frame point in the eye's frame; side -1 left, +1 right."""
        r_head, p_head = self.head(position, quaternion)
        rig = self.rig
        eye = add(p_head, apply(r_head, [side * rig["eye_distance"] / 2, rig["eye_up"], -rig["eye_forward"]]))
        return apply(transposed(r_head), sub(point, eye))


class Display:
    def __init__(self, hmd, eye):
        angles = {k: math.tan(math.radians(v)) for k, v in hmd[eye].items()}
        self.left, self.right = angles["left"], angles["right"]
        fit = (self.left + self.right) * HEIGHT / WIDTH / (angles["down"] + angles["up"])
        self.up = angles["up"] * fit
        self.focal = WIDTH / (self.left + self.right)

    def sphere_centre(self, p, radius):
        """Centre of a sphere's elliptic image: the mean of the two ends of its radial axis (exact for a pinhole)."""
        d = math.sqrt(sum(c * c for c in p))
        theta, alpha = math.atan2(math.hypot(p[0], p[1]), -p[2]), math.asin(radius / d)
        r = (math.tan(theta + alpha) + math.tan(theta - alpha)) / 2
        n = math.hypot(p[0], p[1]) or 1.0
        return (self.left + r * p[0] / n) * self.focal, (self.up - r * p[1] / n) * self.focal


def linear(byte):
    c = byte / 255
    return c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4


LINEAR = [linear(b) for b in range(256)]
# A marker shows in the channels of its colour; by the two strongest.
COLOURS = {"wrist": lambda r, g, b: min(r, b) if g < 0.3 * min(r, b) else 0.0,
           "palm": lambda r, g, b: g if max(r, b) < 0.3 * g else 0.0}


def marker_centre(picture, name):
    """Centroid of a marker by the light its pixels have; None where there is none."""
    weigh, total, x_sum, y_sum = COLOURS[name], 0.0, 0.0, 0.0
    for y, row in enumerate(picture[2]):
        if not any(row):
            continue
        for x in range(picture[0]):
            pixel = row[3 * x:3 * x + 3]
            if not any(pixel):
                continue
            w = weigh(*(LINEAR[c] for c in pixel))
            total, x_sum, y_sum = total + w, x_sum + w * (x + 0.5), y_sum + w * (y + 0.5)
    return (x_sum / total, y_sum / total) if total > 5 else None


class Registration(SessionTest):
    def test_arm_is_where_the_recording_says(self):
        rig = tomllib.loads((ROOT / "configs/rigs/default.toml").read_text())
        hmd = tomllib.loads((ROOT / "configs/hmds/generic.toml").read_text())
        recording = Recording(RECORDING)
        model = Model(rig, recording)
        displays = {"left": (Display(hmd, "left"), -1), "right": (Display(hmd, "right"), 1)}
        at = self.moment(recording, model, displays)
        _, address = self.server("--recording", RECORDING, config="targets")
        clients = {}
        for eye in displays:
            clients[eye] = self.client(address, eye, "--size", f"{WIDTH}x{HEIGHT}", "--fps", "10", "--snapshot-dir", self.folder,
                        "--snapshot-at", at)
        paths = {eye: self.folder / f"{eye}.png" for eye in displays}
        for eye, path in paths.items():
            self.until(lambda: path.exists() and path.read_bytes().endswith(b"IEND\xaeB`\x82"), at + 20, clients[eye])
        for eye, (display, side) in displays.items():
            picture = read_png(paths[eye])
            tick_s = int(picture[3]["tick"]) * 1e-3
            position, quaternion, joints = recording.at(tick_s)
            for name, point in zip(("wrist", "palm"), model.arm(position, quaternion, joints)):
                wanted = display.sphere_centre(model.in_eye(position, quaternion, point, side), 0.006)
                found = marker_centre(picture, name)
                self.assertIsNotNone(found, f"{eye}: no {name} marker")
                error = math.dist(found, wanted)
                print(f"{eye} eye, {name}: seen at {found[0]:.3f} {found[1]:.3f}, expected {wanted[0]:.3f} "
                      f"{wanted[1]:.3f}, off {error:.3f} px at {tick_s:.3f} s")
                self.assertLess(error, 0.1, f"{eye}: {name}")

    def moment(self, recording, model, displays):
        """A time when both markers are well inside both pictures."""
        for tenth in range(20, 200):
            position, quaternion, joints = recording.at(tenth / 10)
            points = model.arm(position, quaternion, joints)
            if all(self.inside(display, model.in_eye(position, quaternion, p, side))
                   for display, side in displays.values() for p in points):
                return tenth / 10
        self.fail("the arm is never in view")

    @staticmethod
    def inside(display, p):
        if p[2] > -0.2:
            return False
        x, y = display.sphere_centre(p, 0.006)
        return 60 < x < WIDTH - 60 and 60 < y < HEIGHT - 60


if __name__ == "__main__":
    if not RECORDING.exists():
        print(f"skipped: no recording at {RECORDING}")
        sys.exit(77)
    unittest.main(verbosity=2)
