#!/usr/bin/env bash
# Installs what is needed, builds, and runs every test: formatting, the optimised build, the sanitizers, clang-tidy.
# Usage: test.sh [--quick]     --quick: the optimised build and its tests only
set -euo pipefail
cd "$(dirname "$0")/.."

quick=no
case "${1:-}" in
  "") ;;
  --quick) quick=yes ;;
  -h | --help) sed -n '2,3s/^# //p' "$0"; exit 0 ;;
  *) echo "test.sh: unknown option '$1'; known is --quick" >&2; exit 2 ;;
esac

started=$SECONDS
step() { printf '\n=== %s (%d s)\n' "$1" $((SECONDS - started)); }

step "packages"
scripts/install_packages.sh build test

sources() { git ls-files '*.h' '*.cpp'; }
if [ "$quick" = no ]; then
  step "formatting"
  sources | xargs clang-format --dry-run --Werror
fi

build_and_test() {
  local preset=$1
  step "build: $preset"
  local targets=$2
  shift 2
  cmake --preset "$preset" -DCOHERENCY_WERROR=ON -DCOHERENCY_TESTS=ON -DCOHERENCY_BENCH=ON >/dev/null
  cmake --build --preset "$preset" --target $targets
  step "tests: $preset"
  ctest --preset "$preset" -j "$(nproc)" "$@"
}

# Tests that start whole programs or open windows are about behaviour, not memory: the sanitizers leave them out, as
# they slow the software renderer ten times.
build_and_test release all
if [ "$quick" = no ]; then
  build_and_test asan all -LE "e2e"
  build_and_test tsan "test_net test_server" -L "threads"
  step "clang-tidy"
  run-clang-tidy -quiet -extra-arg=-Wno-unknown-warning-option -p build/release "$PWD/(common|motion_server|render_client)/.*\.cpp" >build/tidy.log 2>&1 ||
    { grep -E "(warning|error):" build/tidy.log | sort -u; exit 1; }
fi
step "done"
