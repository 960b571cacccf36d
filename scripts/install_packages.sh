#!/usr/bin/env bash
# Installs what Coherency builds, tests and runs with, from the distribution's archive (Debian 12, Ubuntu 24.04).
# Says what it installs; does nothing when everything is there. Usage: install_packages.sh [build|test|bench]...
set -euo pipefail

build="g++ cmake ninja-build pkg-config git libglm-dev libglfw3-dev libegl-dev libepoxy-dev libboost-dev
  libprotobuf-dev protobuf-compiler libsodium-dev libusb-1.0-0-dev libtomlplusplus-dev libcli11-dev libfmt-dev
  nlohmann-json3-dev libpng-dev libstb-dev libgl1-mesa-dri libegl-mesa0 python3"
tests="libgtest-dev librapidcheck-dev libbenchmark-dev libumockdev-dev umockdev xvfb xauth xdotool iproute2
  clang libclang-rt-dev clang-format clang-tidy ffmpeg python3-protobuf python3-nacl"
# What bench/peers compares with, and plots with; no other program and no test needs it.
bench="libopenscenegraph-dev liblcm-dev python3-matplotlib"

wanted=""
for set in "${@:-build test}"; do
  case "$set" in
    build) wanted+=" $build" ;;
    test) wanted+=" $tests" ;;
    bench) wanted+=" $bench" ;;
    "build test") wanted+=" $build $tests" ;;
    *) echo "install_packages.sh: unknown set '$set'; known are: build, test, bench" >&2; exit 2 ;;
  esac
done

missing=""
for package in $wanted; do
  # dpkg knows only real packages that are installed; "install ok installed" is its word for one.
  dpkg-query -W -f '${Status}\n' "$package" 2>/dev/null | grep -q "ok installed" || missing+=" $package"
done
if [ -z "$missing" ]; then
  echo "packages: all there"
  exit 0
fi

sudo=""
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "install_packages.sh: need root or sudo to install:$missing" >&2; exit 1; }
  sudo="sudo"
fi
echo "packages to install:$missing"
$sudo env DEBIAN_FRONTEND=noninteractive apt-get update -q
$sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $missing
