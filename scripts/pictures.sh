#!/usr/bin/env bash
# Makes the pictures of the README and of docs/pictures anew: the demo's telling moments in both modes, both eyes, and
# views of the building. Needs scripts/test.sh to have built `look`.
set -euo pipefail
cd "$(dirname "$0")/.."
look=build/release/tests/render/look
[ -x "$look" ] || { echo "pictures.sh: $look is missing; run scripts/test.sh --quick first" >&2; exit 1; }
pictures=docs/pictures
mkdir -p "$pictures"
for mode in operator robot; do
  scripts/demo.sh --headless --mode "$mode"
  cp out/stereo_1.png "$pictures/${mode}_driving.png"
  cp out/stereo_2.png "$pictures/${mode}_carrying.png"
  cp out/stereo_3.png "$pictures/${mode}_tower.png"
done
view() { "$look" laboratory "$pictures/$1.png" --size 640x480 "${@:2}"; }
view laboratory --camera 2.8,1.7,-2.2,115,-12 --fov 75
view corridor --camera 4.76,1.2,6.1,0,-3 --base 4.76,-5,0 --fov 75
view door --camera 5.0,1.4,-0.2,130,-6 --fov 80 --doors 0.5 0.5 0.5 0.5
view office --camera 6.5,1.6,2.3,-45,-12 --fov 75
view meeting_room --camera 2.9,1.5,3.6,125,-10 --fov 75
view robot --robot-base 0,0.2,0 --base 2.4,2.2,0 --set shoulder_flexion=0.5 --camera 1.0,1.35,-1.2,144,-14 --fov 50
view down --eye mono --head 0,1.16,-0.03,0,-1.0,0
view holding --base 0,0.5,0 --camera=-0.05,0.85,-0.08,-140,-38 --fov 45 --set grip=1 --hold
"$look" laboratory "$pictures/headset.png" --hmd vive --size 540x600 --head 0,1.17,-0.12,0,-0.5,0
"$look" laboratory "$pictures/desk.png" --hmd desk --eye mono --size 640x360 --set grip=0.3
"$look" laboratory "$pictures/desk_moved.png" --hmd desk --eye mono --size 640x360 --head=-0.25,1.25,-0.05,0,0,0 --set grip=0.3
