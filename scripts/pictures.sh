#!/usr/bin/env bash
# Makes the pictures of the README anew: the demo's two eyes while reaching for a block, and two views of `look`.
# Needs scripts/test.sh to have built `look`.
set -euo pipefail
cd "$(dirname "$0")/.."
look=build/release/tests/render/look
[ -x "$look" ] || { echo "pictures.sh: $look is missing; run scripts/test.sh --quick first" >&2; exit 1; }
mkdir -p docs/pictures
scripts/demo.sh --headless --seconds 20
cp out/stereo.png docs/pictures/stereo.png
"$look" laboratory docs/pictures/down.png --eye mono --head 0 1.16 -0.03 0 -1.0 0
"$look" laboratory docs/pictures/operator.png --camera 1.4 1.7 0.2 40 -18 --size 640x480 --fov 70
