#!/usr/bin/env python3
"""The same input gives the same world, bit by bit, whatever the rules were compiled with.

Compiles the rules of the shared world (common/world and what it needs) with every compiler there is, at -O0, -O2 and -O3
and for every x86-64 level this processor has, runs 100 000 steps of random and of recorded input, and compares the hashes
with each other and with the golden ones. Where the C library can be told to do without them, it also runs without the
processor's FMA and AVX. usage: determinism_test.py ROOT WORK_FOLDER RECORDINGS
"""
import concurrent.futures
import csv
import itertools
import math
import os
import pathlib
import platform
import shutil
import subprocess
import sys

GOLDEN = {"random": "3db07af78a3a3424", "recorded": "eda5af5196a69583"}  # FNV-1a of every step's state; they change with the rules, knowingly
RECORDING = "cmu_14_20_reach_twist_bend.csv"

SOURCES = (
    "common/math/Coord3 common/math/FixedPoint common/math/Rotation common/math/SingularValue common/math/TransformMatrix "
    "common/math/Trigonometry common/motion/Dof common/body/Rig common/body/ArmKinematics common/body/Posture "
    "common/world/BasePose common/world/Blocks common/world/Cube common/world/Driving common/world/Hands common/world/Neighbourhood "
    "common/world/Plan common/world/Snapshot common/world/World common/world/WorldState tests/determinism/steps").split()
LENGTH, TURN = 1e6, 2.0 ** 32 / (2 * math.pi)
OLD_LIBRARY = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-AVX2_Usable,-FMA,-FMA_Usable,-FMA4,-AVX,-AVX_Usable"}


def levels():
    """x86-64 levels of this processor beyond the first (gcc's names)."""
    if platform.machine() != "x86_64":
        return []
    flags = set(next(line for line in open("/proc/cpuinfo") if line.startswith("flags")).split())
    found = []
    for level, needed in (("x86-64-v2", "ssse3 sse4_2 popcnt"), ("x86-64-v3", "avx2 bmi2 fma movbe"),
                          ("x86-64-v4", "avx512f avx512bw avx512dq avx512vl")):
        if set(needed.split()) <= flags:
            found.append(level)
    return found


def variants():
    for compiler in ("g++", "clang++"):
        if not shutil.which(compiler):
            print(f"SKIP: {compiler} is not here; what it builds is not compared")
            continue
        for optimisation in ("-O0", "-O2", "-O3"):
            yield compiler, [optimisation]
        for level in levels():
            yield compiler, ["-O3", f"-march={level}"]


def signed32(value):
    return (value + 2 ** 31) % 2 ** 32 - 2 ** 31


def samples_of(recording, file):
    """The recording's rows as samples in the wire's units, each held for its 8 or 9 ms."""
    with open(recording) as source, open(file, "w") as out:
        rows = csv.DictReader(source)
        for row in rows:
            x, y, z, w = (float(row[f"head_q{c}"]) for c in "xyzw")
            pitch = math.asin(max(-1.0, min(1.0, -2 * (y * z - x * w))))
            yaw = math.atan2(2 * (x * z + y * w), 1 - 2 * (x * x + y * y))
            roll = math.atan2(2 * (x * y + z * w), 1 - 2 * (x * x + z * z))
            units = [round(float(row[f"head_{c}_m"]) * LENGTH) for c in "xyz"]
            units[1] -= 500_000  # who stands is seated
            units += [signed32(round(angle * TURN)) for angle in (yaw, pitch, roll)]
            units += [signed32(round(float(row[f"arm_j{j}_rad"]) * TURN)) for j in range(1, 8)]
            units += [0] * 6
            line = " ".join(map(str, units)) + "\n"
            out.write(line * 8)


def build(root, folder, compiler, options):
    folder.mkdir(parents=True, exist_ok=True)
    flags = ["-std=c++20", "-ffp-contract=off", "-w", "-DNDEBUG", f"-I{root}", *options]
    objects = []
    for source in SOURCES:
        target = folder / (source.replace("/", "_") + ".o")
        subprocess.run([compiler, *flags, "-c", f"{root}/{source}.cpp", "-o", target], check=True)
        objects.append(target)
    program = folder / "steps"
    subprocess.run([compiler, *objects, "-o", program], check=True)
    return program


def main():
    root, work, recordings = (pathlib.Path(a) for a in sys.argv[1:4])
    inputs = {"random": "random"}
    if (recordings / RECORDING).exists():
        work.mkdir(parents=True, exist_ok=True)
        samples_of(recordings / RECORDING, work / "recorded.txt")
        inputs["recorded"] = str(work / "recorded.txt")
    else:
        print(f"SKIP: recorded input; {recordings / RECORDING} is not here")
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        builds = {}
        for compiler, options in variants():
            name = " ".join([compiler, *options])
            builds[name] = pool.submit(build, root, work / name.replace(" ", "_"), compiler, options)
        programs = {name: future.result() for name, future in builds.items()}
    wrong = 0
    environments = (({}, ""), (OLD_LIBRARY, ", C library without AVX and FMA"))
    for (name, program), (extra, what), (kind, argument) in itertools.product(
            programs.items(), environments, inputs.items()):
        said = subprocess.run([program, argument], check=True, capture_output=True, text=True,
                              env={**os.environ, **extra}).stdout.strip()
        good = said.split()[0] == GOLDEN[kind]
        wrong += not good
        print(f"{'ok   ' if good else 'WRONG'} {kind:9} {said}  [{name}{what}]")
    if wrong:
        print(f"{wrong} hashes are not the golden ones {GOLDEN}")
    print(f"{len(programs)} builds, {len(inputs)} inputs")
    return 1 if wrong or not programs else 0


if __name__ == "__main__":
    sys.exit(main())
