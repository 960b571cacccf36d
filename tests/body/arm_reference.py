#!/usr/bin/env python3
"""The arm of the motion data's README, computed a second time and on its own: prints arm_reference.csv.

    R_hand = T Rx(j1) Rz(j2) Ry(j3) H0 R((0, 0.8660, 0.5), j4) Rx(j5) Ry(j7) Rz(j6)

Away from the T-pose (right arm along +x) the upper arm turns by the factors up to H0, the forearm by those up to j5.
Segments have the default rig's lengths. Columns: seven joints, elbow, wrist and palm in the shoulder frame, and R_hand
row by row. Shares no code with the program.
"""
import itertools
import math
import random

UPPER_ARM, FOREARM, HAND = 0.29, 0.26, 0.09
UP, BACK = math.radians(25.0), math.radians(30.0)
HINGE = (0.0, math.sqrt(3.0) / 2.0, 0.5)
LIMITS = ((-1.6, 3.2), (-1.5, 1.5), (-2.3, 2.3), (-0.1, 2.8), (-1.9, 1.9), (-1.6, 1.6), (-1.3, 1.3))


def times(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def product(*matrices):
    result = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    for m in matrices:
        result = times(result, m)
    return result


def about(axis, angle):
    """Right-handed rotation (Rodrigues)."""
    x, y, z = axis
    c, s = math.cos(angle), math.sin(angle)
    v = 1.0 - c
    return [[c + x * x * v, x * y * v - z * s, x * z * v + y * s],
            [y * x * v + z * s, c + y * y * v, y * z * v - x * s],
            [z * x * v - y * s, z * y * v + x * s, c + z * z * v]]


X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
A1 = (math.cos(UP) * math.cos(BACK), math.sin(UP), math.cos(UP) * math.sin(BACK))
A2 = (-math.sin(BACK), 0.0, math.cos(BACK))
A3 = (-math.sin(UP) * math.cos(BACK), math.cos(UP), -math.sin(UP) * math.sin(BACK))
T = [[A1[i], A3[i], A2[i]] for i in range(3)]
# H0 takes x to -y, the hinge to x, and so their cross product (0, -1/2, sqrt(3)/2) to z.
FROM = [(1.0, 0.0, 0.0), HINGE, (0.0, -0.5, math.sqrt(3.0) / 2.0)]
TO = [(0.0, -1.0, 0.0), X, Z]
H0 = [[sum(TO[k][i] * FROM[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def arm(j1, j2, j3, j4, j5, j6, j7):
    upper = product(T, about(X, j1), about(Z, j2), about(Y, j3), H0)
    fore = product(upper, about(HINGE, j4), about(X, j5))
    hand = product(fore, about(Y, j7), about(Z, j6))
    elbow = [UPPER_ARM * upper[i][0] for i in range(3)]
    wrist = [elbow[i] + FOREARM * fore[i][0] for i in range(3)]
    palm = [wrist[i] + HAND * hand[i][0] for i in range(3)]
    return elbow, wrist, palm, hand


def main():
    names = ["j%d" % (i + 1) for i in range(7)]
    names += ["%s_%s" % (part, axis) for part in ("elbow", "wrist", "palm") for axis in "xyz"]
    names += ["r%d%d" % (i, j) for i in range(3) for j in range(3)]
    print(",".join(names))
    chance = random.Random(19)
    rows = [(0.0, -UP, BACK, 0.0, 0.0, 0.0, 0.0)]
    rows += itertools.product(*LIMITS)  # every corner of the joints' limits
    rows += [tuple(chance.uniform(*limit) for limit in LIMITS) for _ in range(60)]
    for joints in rows:
        elbow, wrist, palm, hand = arm(*joints)
        values = list(joints) + elbow + wrist + palm + [v for row in hand for v in row]
        print(",".join("%.15g" % v for v in values))


if __name__ == "__main__":
    main()
