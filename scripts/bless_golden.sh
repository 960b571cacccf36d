#!/usr/bin/env bash
# Makes the golden pictures of tests/golden anew and says which have changed: look at each of them before committing it.
# Refuses another renderer than the pinned one (tests/golden/renderer.txt). Needs scripts/test.sh to have built
# `bless_golden`.
set -euo pipefail
cd "$(dirname "$0")/.."
bless=build/release/tests/golden/bless_golden
[ -x "$bless" ] || { echo "bless_golden.sh: $bless is missing; run scripts/test.sh --quick first" >&2; exit 1; }
LIBGL_ALWAYS_SOFTWARE=1 LP_NATIVE_VECTOR_WIDTH=128 "$bless"
