#!/bin/sh
# in_xvfb.sh PROGRAM [ARGUMENT...]: runs it on an X server of its own, whose screen it finds in the file that
# COHERENCY_SCREEN names. Exit status 77: skipped, with a reason.
for tool in xvfb-run Xvfb xauth; do
  command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
COHERENCY_SCREEN="$folder/Xvfb_screen0" \
  xvfb-run -a -s "-screen 0 1024x768x24 -nolisten tcp -fbdir $folder" "$@"
