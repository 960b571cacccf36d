#!/usr/bin/env bash
# Runs bench_lcm_latency in a network namespace of its own, where multicast has loopback as its way: none of its packets
# can leave the machine, and none of another's come in. Needs root, or a system on which users may make namespaces.
# Usage: lcm.sh [BUILD_FOLDER] [OPTION]...     build/release where no folder is given; options as --help says
set -euo pipefail
cd "$(dirname "$0")/../.."

build=build/release
if [ $# -gt 0 ] && [ "${1#-}" = "$1" ]; then build=$1; shift; fi
program=$build/bench/peers/bench_lcm_latency
[ -x "$program" ] || { echo "lcm.sh: $program is not there: scripts/install_packages.sh bench, configure and build again" >&2; exit 1; }
# A user becomes root in a namespace of users first; root needs none.
if [ "$(id -u)" -eq 0 ]; then user=(); else user=(--user --map-root-user); fi
exec unshare "${user[@]}" --net sh -c \
  'ip link set lo up multicast on && ip route add 224.0.0.0/4 dev lo && exec "$@"' sh "$program" "$@"
