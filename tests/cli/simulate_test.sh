# SPDX-License-Identifier: GPL-3.0-or-later
# What simulate writes is a project that track can run, with the truth beside it.
. "$(dirname "$0")/common.sh"

printf 'frame_count = 12\n' >short.toml
expectExit 0 simulate short.toml --out scene --seed 3
for file in scene/project.toml scene/truth.csv; do
  [[ -s $file ]] || fail "$file is missing"
done
expectExit 0 track scene/project.toml --out run --seed 1
[[ $(rowCount run/trajectory.csv) == 12 ]] || fail "$(rowCount run/trajectory.csv) rows, not 12"
expectExit 0 evaluate run/trajectory.csv scene/truth.csv

# The same folder again is fine, as is a track of image folders instead of videos.
expectExit 0 simulate short.toml --out scene --seed 3
expectExit 0 simulate smooth --out folders --images --frames 6
expectExit 0 track folders/project.toml --out run
[[ $(rowCount run/trajectory.csv) == 6 ]] || fail "$(rowCount run/trajectory.csv) rows, not 6"

# The same seed gives the same files.
expectExit 0 simulate short.toml --out one --images --seed 3
expectExit 0 simulate short.toml --out again --images --seed 3
diff -r one again >/dev/null || fail "two simulations with one seed differ"

expectExit $kBadInput simulate no-such-scene --out nowhere
expectSentence no-such-scene
printf 'frame_cuont = 12\n' >typo.toml
expectExit $kBadInput simulate typo.toml --out nowhere
expectSentence typo.toml frame_cuont

# The scene with people: tracked as it comes, by a method for people, with the empty room beside it.
expectExit 0 simulate office --frames 45 --out office
expectText office/project.toml 'method = "people"' camera-4.mkv empty-1
expectExit 0 people office/project.toml --out people
expectExit $kUsage simulate office --occluder --out nowhere
expectSentence --occluder

# A board to calibrate from: in the first position it lies on the floor and makes the world.
expectExit 0 simulate board --frames 75 --out board
expectText out.txt chessboard:9x6:0.025 'frame 0'
expectExit 0 new board.toml --camera left=board/left.mkv --camera right=board/right.mkv \
  --calibration board/truth.toml
expectExit 0 calibrate extrinsics board.toml --board chessboard:9x6:0.025 --world-frame 0 \
  --out found.toml
! grep -q Fault out.txt || fail "$(cat out.txt)"
# The cameras are found where they stand, to 3 mm: of six numbers, none is farther off.
paste <(grep ^translation found.toml) <(grep ^translation board/truth.toml) | tr -d '[],=' |
  awk '{ for (k = 2; k <= 4; ++k) if (($k - $(k + 4)) ^ 2 > 0.003 ^ 2) far = 1 }
    END { exit far || NR != 2 }' ||
  fail "$(cat found.toml board/truth.toml)"
expectExit $kUsage simulate board --occluder --out nowhere
expectSentence --occluder
