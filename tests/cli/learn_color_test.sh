# SPDX-License-Identifier: GPL-3.0-or-later
# From videos to a track without a window: the color is learned from one pixel.
. "$(dirname "$0")/common.sh"

expectExit 0 simulate demo --frames 5 --out made
expectExit 0 new fresh.toml --camera "camera 1=made/camera-1.mkv" \
  --camera "camera 2=made/camera-2.mkv" --calibration made/calibration.toml

# Both cameras look at (0.5, 0.5, 0.15) m, where the ball rests: it is at their principal points,
# (159.5, 119.5) and (119.5, 159.5). In camera 1, 0.502 m away, its radius is 350 * 0.035 / 0.502 = 24
# pixels (focal length 350): a pixel within ten of the center is on it.
expectExit 0 learn-color fresh.toml --camera "camera 1" --frame 2 --pixel 157,117 \
  --target "pink ball" --radius 0.035 --mask mask.png --out taught.toml
[[ ! -s err.txt ]] || fail "nothing was to be said: $(cat err.txt)"
expectText out.txt 'pink ball' 'Hue ' 'degrees' ' of 100 points).' 'background'
[[ $(head -c 8 mask.png | od -An -tx1 | tr -d ' \n') == 89504e470d0a1a0a ]] || fail "mask.png is no PNG"
expectText taught.toml '[[target]]' 'name = "pink ball"' '[[target.sample]]' 'pixel = [157, 117]'
# The other camera was found to show it, within ten pixels of its center too.
expectText out.txt 'Found in camera 2 at '
read -r x y < <(sed -nE 's/^Found in camera 2 at ([0-9]+),([0-9]+)\.$/\1 \2/p' out.txt)
(((x - 119) ** 2 + (y - 159) ** 2 < 24 ** 2)) || fail "camera 2 does not show it at $x,$y"
expectText taught.toml 'found = true'
! grep -q 'Its radius' out.txt || fail "the radius fits: $(cat out.txt)"
# A diameter given as radius, a radius that nothing has, and none.
expectExit 0 learn-color fresh.toml --camera "camera 1" --frame 2 --pixel 157,117 --radius 0.07
expectText out.txt "The target's radius seems to be about 0.03" 'but 0.07 m is given. Is the given value the diameter?'
expectExit 0 learn-color fresh.toml --camera "camera 1" --frame 2 --pixel 157,117 --radius 100
expectText out.txt "The target's radius seems to be about 0.03" 'but 100 m is given.'
expectExit 0 learn-color fresh.toml --camera "camera 1" --frame 2 --pixel 157,117
expectText out.txt "The target's radius seems to be about 0.03"
! grep -q target fresh.toml || fail "the project itself was changed"

expectExit 0 track taught.toml --out run
[[ $(rowCount run/trajectory.csv) == 5 ]] || fail "$(rowCount run/trajectory.csv) rows, not 5"

# By number and with a box; more clicks; the only target is the one that is taught again.
expectExit 0 learn-color taught.toml --camera 2 --box 95,135,50,50 --more "camera 1:4:160,120" \
  --exclude 1:0:10,10 --out again.toml
expectText again.toml 'name = "pink ball"' 'box = [95, 135, 50, 50]' 'excluded = true'
[[ $(grep -c '^\[\[target\]\]' again.toml) == 1 ]] || fail "a second target was made"
expectExit 0 learn-color taught.toml --pixel 157,117 --target other --out two.toml
[[ $(grep -c '^\[\[target\]\]' two.toml) == 2 ]] || fail "no second target was made"

# Pictures of the empty room are kept in the project and read; a missing file is one sentence.
expectExit 0 new empty.toml --camera "camera 1=made/camera-1.mkv" \
  --camera "camera 2=made/camera-2.mkv" --calibration made/calibration.toml \
  --empty-room "camera 2=made/camera-2.mkv"
expectExit 0 learn-color empty.toml --pixel 157,117 --out known.toml
expectText known.toml 'empty_room'
expectExit 0 track known.toml --out known
[[ $(rowCount known/trajectory.csv) == 5 ]] || fail "$(rowCount known/trajectory.csv) rows, not 5"
sed 's/^empty_room.*/empty_room = "gone.png"/' known.toml >gone.toml
expectExit $kBadInput track gone.toml --out gone
expectSentence gone.png "camera 2"

# Among balls alike the click says which one is meant: the position where the cameras see it goes
# into the project, half a meter in front of camera 1, and the run is there from its first frame on.
expectExit 0 simulate look-alikes --frames 5 --out alike
expectExit 0 new alike.toml --camera "camera 1=alike/camera-1.mkv" \
  --camera "camera 2=alike/camera-2.mkv" --calibration alike/calibration.toml
expectExit 0 learn-color alike.toml --pixel 157,117 --radius 0.035 --out meant.toml
expectText meant.toml '[[correction]]' 'frame = 0'
expectExit 0 track meant.toml --out meant
awk -F, '/^[0-9]/ { d = sqrt(($4 - 0.5) ^ 2 + ($5 - 0.5) ^ 2 + ($6 - 0.15) ^ 2); n++; if (d > 0.02) exit 1 }
         END { if (n != 5) exit 1 }' meant/trajectory.csv || fail "it is not the ball that was clicked"

# Each of the others can be a target, too: one image shows two more about as large as this one.
expectExit 0 learn-color alike.toml --pixel 157,117 --radius 0.035 --follow-all --out all.toml
expectText out.txt 'Targets added for other objects of this color and size: 2.'
expectText all.toml 'name = "target 2"' 'name = "target 3"'
[[ $(grep -c '^\[\[target\]\]' all.toml) == 3 ]] || fail "not every ball is a target"
expectExit 0 learn-color fresh.toml --frame 2 --pixel 157,117 --radius 0.035 --follow-all --out one.toml
expectText out.txt 'Targets added for other objects of this color and size: 0.'
[[ $(grep -c '^\[\[target\]\]' one.toml) == 1 ]] || fail "there is one ball"

# One sentence says what is wrong, and nothing is written.
expectExit $kBadInput learn-color two.toml --pixel 157,117 --out no.toml
expectSentence two.toml --target
expectExit $kBadInput learn-color fresh.toml --pixel 400,10 --out no.toml
expectSentence fresh.toml pixel 320x240
expectExit $kBadInput learn-color fresh.toml --frame 5 --pixel 157,117 --out no.toml
expectSentence fresh.toml --frame 5
expectExit $kUsage learn-color fresh.toml --camera 3 --pixel 157,117 --out no.toml
expectSentence --camera 3
expectExit $kUsage learn-color fresh.toml --pixel 157 --out no.toml
expectSentence --pixel X,Y 157
expectExit $kUsage learn-color fresh.toml --pixel 1,1 --more 1:0 --out no.toml
expectSentence --more CAMERA:FRAME:X,Y
expectExit $kUsage learn-color fresh.toml --out no.toml
expectExit $kOutput learn-color fresh.toml --pixel 157,117 --mask nowhere/mask.png
expectSentence nowhere/mask.png
[[ ! -e no.toml ]] || fail "a project was written in spite of an error"
