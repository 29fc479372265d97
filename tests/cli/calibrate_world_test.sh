# SPDX-License-Identifier: GPL-3.0-or-later
# Floor, origin, axes and scale of cameras that are calibrated, from points clicked in two images.
. "$(dirname "$0")/common.sh"

expectExit 0 calibrate world --help
expectText out.txt --upright --floor --level --length --meters --x-axis --origin --quarter-turn --move --rotate --apply

# Two cameras 1 m apart, 2 m before the points and 1 m high, that look along y: f = 500, center
# (320, 240). The first one sees a point (x, y, z) at (320 + 500 x / (y + 2), 240 - 500 (z - 1) / (y + 2)).
project() {
  cat > project.toml <<'TOML'
format = 2
name = "world"
[[camera]]
name = "left"
video = "left.mkv"
[camera.calibration]
size = [640, 480]
matrix = [[500, 0, 320], [0, 500, 240], [0, 0, 1]]
rotation = [[1, 0, 0], [0, 0, -1], [0, 1, 0]]
translation = [0, 1, 2]
[[camera]]
name = "right"
video = "right.mkv"
[camera.calibration]
size = [640, 480]
matrix = [[500, 0, 320], [0, 500, 240], [0, 0, 1]]
rotation = [[1, 0, 0], [0, 0, -1], [0, 1, 0]]
translation = [-1, 1, 2]
TOML
}
point() {
  printf '[[point]]\nname = "%s"\nworld = [0, 0, 0]\n' "$1" >> project.toml
  printf '[[point.click]]\ncamera = 1\npixel = [%s]\n' "$2" >> project.toml
  [ -z "${3:-}" ] || printf '[[point.click]]\ncamera = 2\npixel = [%s]\n' "$3" >> project.toml
}
expectCamera() {
  grep -qE "^$1 +$2 +$3 +$4\$" out.txt || fail "$1 is not at $2 $3 $4: $(cat out.txt)"
}

# The floor is at z = 0.1.
project
point a "320, 465" "70, 465"
point b "570, 465" "320, 465"
point c "320, 390" "153.3333, 390"
point alone "320, 240"
cp project.toml before.toml
expectExit 0 calibrate world project.toml --floor a,b,c
expectText out.txt 'floor    rotated by' 'points within 0.00 mm'
expectCamera left -?0.0000 -2.0000 0.9000
expectCamera right 1.0000 -2.0000 0.9000
cmp project.toml before.toml || fail 'the project was changed without --apply'

expectExit 0 calibrate world project.toml --floor a,b,c --length a,b --meters 2 --out found.toml
expectText out.txt 'all lengths x 2.00000'
expectCamera right 2.0000 -4.0000 1.8000
expectText found.toml 'name = "right"'

expectExit 0 calibrate world project.toml --x-axis a,c --origin a
expectCamera left -2.0000 -?0.0000 0.9000
expectExit 0 calibrate world project.toml --move 0 0 -1 --rotate 90
expectCamera left 2.0000 -?0.0000 -?0.0000
expectExit 0 calibrate world project.toml --quarter-turn x --apply
expectText out.txt 'see --upright'
expectExit 0 calibrate world project.toml --upright --apply
expectCamera left -?0.0000 -2.0000 1.0000
expectExit 0 calibrate world project.toml --upright
expectText out.txt 'upright  unchanged'

expectExit $kBadInput calibrate world project.toml --floor a,b
expectSentence points
expectExit $kBadInput calibrate world project.toml --floor a,b,nowhere
expectSentence nowhere
expectExit $kBadInput calibrate world project.toml --origin alone
expectSentence alone 'at least two cameras'
expectExit $kUsage calibrate world project.toml --length a,b
expectExit $kUsage calibrate world demo --apply
expectSentence --apply

# What is known before and after.
expectExit 0 calibrate status project.toml
expectText out.txt 'set by hand' 'accuracy  not measured'
expectExit 0 calibrate world project.toml --floor a,b,c --length a,b --meters 2 --apply
expectExit 0 calibrate status project.toml
expectText out.txt 'scale     points marked in the images' 'floor     points marked in the images' 'length    2.0000 m measured, 2.0000 m found'
expectExit 0 calibrate status demo
expectText out.txt 'exact (simulated)'
expectExit $kBadInput calibrate status nowhere.toml

# A board that lies on the floor in frame 0: cameras in a world turned about x are where they were.
expectExit 0 simulate board --frames 30 --out shown
expectExit 0 new shown.toml --camera left=shown/left.mkv --camera right=shown/right.mkv \
  --calibration shown/truth.toml
expectExit 0 calibrate world shown.toml --quarter-turn x --apply
expectExit 0 calibrate world shown.toml --board chessboard:9x6:0.025 --out floor.toml
expectText out.txt 'board    rotated by' 'board seen by 2 cameras'
paste <(grep ^translation floor.toml) <(grep ^translation shown/truth.toml) | tr -d '[],=' |
  awk '{ for (k = 2; k <= 4; ++k) if (($k - $(k + 4)) ^ 2 > 0.003 ^ 2) far = 1 }
    END { exit far || NR != 2 }' ||
  fail "$(cat floor.toml shown/truth.toml)"
expectExit $kBadInput calibrate world shown.toml --board chessboard:9x6:0.025 --board-frame 100000
expectSentence frame 'has only'
expectExit $kBadInput calibrate world shown.toml --board chessboard:8x5:0.025
expectSentence board
expectExit $kUsage calibrate world project.toml --board-frame 0
