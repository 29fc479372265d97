# SPDX-License-Identifier: GPL-3.0-or-later
# Cameras from measured points that were clicked in their images.
. "$(dirname "$0")/common.sh"

expectExit 0 calibrate points --help
expectText out.txt --focal --out --apply --accept-orientation

# A camera 2 m before the corner of a unit cube: f = 500, center (320, 240), axes as the world's but
# y down and z ahead. A point (x, y, z) is at (320 + 500 x / (y + 2), 240 - 500 z / (y + 2)).
cat > project.toml <<'TOML'
format = 2
name = "points"
[[camera]]
name = "only"
video = "only.mkv"
[camera.calibration]
size = [640, 480]
matrix = [[500, 0, 320], [0, 500, 240], [0, 0, 1]]
rotation = [[0.99995, -0.0099998, 0], [0, 0, -1], [0.0099998, 0.99995, 0]]
translation = [0.1, 0.0, 2.1]
TOML
point() {
  printf '[[point]]\nname = "%s"\nworld = [%s]\n[[point.click]]\ncamera = 1\npixel = [%s]\n' \
    "$1" "$2" "$3" >> project.toml
}
point a "0, 0, 0" "320, 240"
point b "0.4, 0, 0" "420, 240"
point c "0, 0, 0.4" "320, 140"
point d "0.5, 0.5, 0" "420, 240"
point e "0, 0.5, 0.5" "320, 140"
point f "-0.4, 0.5, 0.25" "240, 190"
expectExit 0 calibrate points project.toml --out found.toml --apply
expectText out.txt only "Worst"
expectText found.toml 'name = "only"'
expectExit 0 calibrate points project.toml
grep -q '^only  *6  *0\.000' out.txt || fail "exact points do not fit exactly: $(cat out.txt)"

# The tape was read wrongly.
sed -i 's/world = \[-0.4, 0.5, 0.25\]/world = [-0.4, 0.9, 0.25]/' project.toml
expectExit 0 calibrate points project.toml
expectText out.txt 'Does not fit the other points: f'

# The images arrive upside down: pixel (x, y) is at (639 - x, 479 - y), the center at (319, 239).
cat > project.toml <<'TOML'
format = 2
name = "rotated"
[[camera]]
name = "only"
video = "only.mkv"
[camera.calibration]
size = [640, 480]
matrix = [[500, 0, 319], [0, 500, 239], [0, 0, 1]]
rotation = [[0.99995, -0.0099998, 0], [0, 0, -1], [0.0099998, 0.99995, 0]]
translation = [0.1, 0.0, 2.1]
TOML
point a "0, 0, 0" "319, 239"
point b "0.4, 0, 0" "219, 239"
point c "0, 0, 0.4" "319, 339"
point d "0.5, 0.5, 0" "219, 239"
point e "0, 0.5, 0.5" "319, 339"
point f "-0.4, 0.5, 0.25" "399, 289"
cp project.toml before.toml
expectExit 0 calibrate points project.toml
expectText out.txt 'only seems to be rotated' 'rotate = 180, mirror = false; --accept-orientation sets it'
cmp project.toml before.toml || fail 'the project was changed without --apply'
expectExit 0 calibrate points project.toml --accept-orientation --apply
expectText out.txt 'only: rotate = 180, mirror = false now.'
expectText project.toml 'rotate = 180'
expectExit 0 calibrate points project.toml
grep -q '^only  *6  *0\.000' out.txt || fail "rotated points do not fit exactly: $(cat out.txt)"
! grep -q 'seems to be' out.txt || fail "$(cat out.txt)"
expectExit $kUsage calibrate points project.toml --accept-orientation
expectSentence --accept-orientation --apply

expectExit $kBadInput calibrate points demo
expectSentence point
expectExit $kUsage calibrate points demo --apply
expectSentence --apply
