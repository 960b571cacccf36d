#!/usr/bin/env bash
# Installs, builds, and runs one motion server and two eyes while a simulated operator drives to the table and builds a
# tower of three blocks; leaves pictures of three moments of it in out/ (stereo_1.png to stereo_3.png: driving up, carrying,
# done) and a report in words. Windows where there is a display, headless otherwise. In robot mode one is the slave robot;
# with a recording nothing is built: one sees what its motion does.
# Usage: demo.sh [--mode operator|robot] [--recording FILE] [--headless] [--size WxH]
set -euo pipefail
here=$PWD
cd "$(dirname "$0")/.."

seconds=27
moments=5,19.4,24.5
size=640x480
judge=(--tower)
shown=("driving up" carrying done)
display=""
server_options=()
while [ $# -gt 0 ]; do
  case "$1" in
    --mode)
      case "${2:-}" in
        operator) ;;
        robot) moments=6,16,26; seconds=28 ;;
        *) echo "demo.sh: --mode must be operator or robot" >&2; exit 2 ;;
      esac
      server_options+=(--mode "$2"); shift 2 ;;
    --recording)
      file=$(cd "$here" && realpath -m -- "${2:?--recording needs a file}")
      [ -r "$file" ] || { echo "demo.sh: --recording $2: no file that can be read" >&2; exit 2; }
      server_options+=(--recording "$file"); judge=(); shown=("after 5 s" "after 19.4 s" "after 24.5 s"); shift 2 ;;
    --size)
      size=${2:?--size needs WxH}
      [[ $size =~ ^[1-9][0-9]*x[1-9][0-9]*$ ]] || { echo "demo.sh: --size must be as in 640x480" >&2; exit 2; }
      shift 2 ;;
    --headless) display=headless; shift ;;
    -h | --help) sed -n '2,6s/^# //p' "$0"; exit 0 ;;
    *) echo "demo.sh: unknown option '$1'; see --help" >&2; exit 2 ;;
  esac
done
if [ -z "$display" ]; then
  if [ -n "${DISPLAY:-}" ]; then display=window; else display=headless; fi
fi

echo "1/4 packages"
scripts/install_packages.sh build
echo "2/4 build (a few minutes the first time)"
# Tests and benchmarks need packages of their own: they stay in where test.sh has put them in before.
[ -f build/release/CMakeCache.txt ] || lean="-DCOHERENCY_TESTS=OFF -DCOHERENCY_BENCH=OFF"
cmake --preset release ${lean:-} >/dev/null
cmake --build --preset release --target motion_server render_client

echo "3/4 one server, two eyes ($display), $seconds seconds"
rm -rf out && mkdir -p out
pids=()
end_all() { for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null || :; done; wait 2>/dev/null || :; }
trap end_all EXIT

port_file=out/server.log
build/release/motion_server/motion_server --config configs/servers/laboratory.toml --listen 127.0.0.1:0 \
  --duration $((seconds + 3)) --stats-json out/server.json "${server_options[@]}" 2>"$port_file" &
pids+=($!)
server=$!
for _ in $(seq 100); do
  address=$(sed -n 's/^listening on \([^ ]*\).*/\1/p' "$port_file")
  [ -n "$address" ] && break
  kill -0 "$server" 2>/dev/null || { cat "$port_file" >&2; exit 1; }
  sleep 0.1
done
[ -n "$address" ] || { echo "demo.sh: the server does not listen after 10 s" >&2; exit 1; }
eyes=()
for eye in left right; do
  build/release/render_client/render_client --server "$address" --eye "$eye" --display "$display" --size "$size" \
    --duration "$seconds" --snapshot-dir out --snapshot-at "$moments" --stats-json "out/$eye.json" \
    2>"out/$eye.log" &
  pids+=($!)
  eyes+=($!)
done
for second in $(seq "$seconds"); do
  printf '\r  %2d of %d s ' "$second" "$seconds"
  sleep 1
  for pid in "${pids[@]}"; do
    kill -0 "$pid" 2>/dev/null || [ "$second" -ge $((seconds - 1)) ] || { echo; cat out/*.log >&2; exit 1; }
  done
done
printf '\n'
failed=no
for pid in "${eyes[@]}" "$server"; do wait "$pid" || failed=yes; done
if [ "$failed" = yes ]; then
  cat out/*.log >&2
  exit 1
fi
echo "4/4 report"
python3 scripts/coherency_check.py out "${judge[@]}"
echo "pictures: out/stereo_1.png (${shown[0]}) out/stereo_2.png (${shown[1]}) out/stereo_3.png (${shown[2]})"
