#!/bin/sh
# in_xvfb.sh PROGRAM [ARGUMENT...]: runs it on an X server of its own. Exit status 77: skipped, with a reason.
for tool in xvfb-run Xvfb xauth; do
  command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done
exec xvfb-run -a -s "-screen 0 1024x768x24 -nolisten tcp" "$@"
