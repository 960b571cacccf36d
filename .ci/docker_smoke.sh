#!/usr/bin/env bash
# Runs `docker compose up --exit-code-from checker` where there may be neither an engine nor a registry: starts
# an engine of its own where none answers, and makes the base image from the distribution's archive where it cannot be pulled. A
# user with an ordinary engine needs none of this.
# Usage: docker_smoke.sh [--expect-failure draw-nothing|server-stops]
#   the two failures the checker exists for, each provoked on purpose; the script succeeds if the checker finds it
set -euo pipefail
cd "$(dirname "$0")/.."

provoke=""
[ "${1:-}" = "--expect-failure" ] && provoke=${2:?which failure?}

missing=""
for tool in dockerd:docker.io docker-compose:docker-compose debootstrap:debootstrap iptables:iptables; do
  command -v "${tool%%:*}" >/dev/null || missing+=" ${tool#*:}"
done
if [ -n "$missing" ]; then
  echo "packages to install:$missing"
  apt-get update -q
  DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $missing
fi

engine=""
work=$(mktemp -d)
cleanup() {
  docker-compose down --volumes --remove-orphans >/dev/null 2>&1 || :
  if [ -n "$engine" ]; then kill "$engine" 2>/dev/null || :; wait "$engine" 2>/dev/null || :; fi
  rm -rf "$work"
}
trap cleanup EXIT
if ! docker info >/dev/null 2>&1; then
  dockerd >"$work/dockerd.log" 2>&1 &
  engine=$!
  for _ in $(seq 60); do
    docker info >/dev/null 2>&1 && break
    kill -0 "$engine" 2>/dev/null || { tail -20 "$work/dockerd.log" >&2; exit 1; }
    sleep 0.5
  done
fi
if ! docker image inspect debian:bookworm-slim >/dev/null 2>&1 && ! docker pull -q debian:bookworm-slim 2>/dev/null; then
  mirror=$(sed -n 's/^deb \(\[[^]]*\] \)\?\([^ ]*\) bookworm main.*/\2/p;s/^URIs: *\([^ ]*\).*/\1/p' \
    /etc/apt/sources.list /etc/apt/sources.list.d/* 2>/dev/null | head -n 1) || :  # not every machine has both
  debootstrap --variant=minbase bookworm "$work/base" "${mirror:-http://deb.debian.org/debian}" >"$work/debootstrap.log"
  cp -r /etc/apt/apt.conf.d/. "$work/base/etc/apt/apt.conf.d/"  # a proxy, where there is one
  tar -C "$work/base" -c . | docker import - debian:bookworm-slim
fi

docker-compose build
status=0
case "$provoke" in
  "") docker-compose up --exit-code-from checker | tee "$work/said" || status=$? ;;
  draw-nothing)
    # The eye runs, but looks at a patch of wall one degree wide.
    cat >"$work/override.yml" <<'Y'
version: "2.4"
services:
  left:
    command: >
      sh -c "sed 's/^near_m.*/near_m = 1.0/; s/52.0/-40.0/; s/44.0/41.0/' /opt/coherency/share/coherency/hmds/generic.toml >/tmp/nothing.toml
      && until test -s /out/session.key; do sleep 0.1; done
      && exec render_client --server server --key /out/session.key --eye left --display headless --fps 20 --wait 60 --hmd /tmp/nothing.toml
      --snapshot-dir /out --snapshot-at 12 --stats-json /out/left.json"
Y
    docker-compose -f docker-compose.yml -f "$work/override.yml" up --exit-code-from checker | tee "$work/said" || status=$?
    found="left.png shows nothing" ;;
  server-stops)
    cat >"$work/override.yml" <<'Y'
version: "2.4"
services:
  server:
    command: >
      sh -c "{ test -e /out/session.key || motion_server --make-key /out/session.key; }
      && motion_server --config /opt/coherency/share/coherency/servers/lan.toml --key /out/session.key
      --stats-json /out/server.json --duration 14; exec sleep 60"
Y
    docker-compose -f docker-compose.yml -f "$work/override.yml" up --exit-code-from checker | tee "$work/said" || status=$?
    found="server has reported nothing" ;;
  *) echo "docker_smoke.sh: unknown failure '$provoke'" >&2; exit 2 ;;
esac
if [ -z "$provoke" ]; then
  [ "$status" -eq 0 ] || { echo "compose smoke: failed with $status"; exit 1; }
  echo "compose smoke: passed"
else
  [ "$status" -ne 0 ] && grep -q "WRONG: .*$found" "$work/said" || { echo "compose smoke: the checker missed '$provoke'"; exit 1; }
  echo "compose smoke: '$provoke' was found, as it should be"
fi
