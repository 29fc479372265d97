# SPDX-License-Identifier: GPL-3.0-or-later
# dewpoint --self-test on a computer without a display. $1: the program, $2: a folder of the test's own.
set -euo pipefail
rm -rf "$2"
mkdir -p "$2/run" "$2/config"
chmod 700 "$2/run"
unset DISPLAY WAYLAND_DISPLAY QT_QPA_PLATFORM
XDG_RUNTIME_DIR=$2/run XDG_CONFIG_HOME=$2/config "$1" --self-test >"$2/out.txt"
for subject in window graphics languages versions disk "codec FFV1" tracking; do
  grep -qE "^(ok|note) +$subject: " "$2/out.txt" || { cat "$2/out.txt"; exit 1; }
done
grep -qE 'graphics: .*there is no display' "$2/out.txt" || { cat "$2/out.txt"; exit 1; }
