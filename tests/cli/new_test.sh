# SPDX-License-Identifier: GPL-3.0-or-later
# A project from recordings and a calibration file, from the command line alone.
. "$(dirname "$0")/common.sh"

expectExit 0 simulate demo --frames 5 --out made
cameras=(--camera "camera 2=made/camera-2.mkv" --camera "camera 1=made/camera-1.mkv")

expectExit 0 new waved.toml "${cameras[@]}" --calibration made/calibration.toml --name waved
expectExit 0 new deep/er/waved.toml "${cameras[@]}" --calibration made/calibration.toml
expectText waved.toml 'name = "waved"' 'video = "made/camera-1.mkv"' '[camera.calibration]'
[[ ! -s err.txt ]] || fail "nothing was to be said: $(cat err.txt)"
# By name, not by order: camera 2 is the one that stands upright (simulate's demo: 240x320).
grep -A4 'name = "camera 2"' waved.toml | grep -qF 'size = [240, 320]' || fail "$(cat waved.toml)"

# Files called differently than the calibration's cameras: by order, and that is said.
expectExit 0 new ordered.toml --camera made/camera-1.mkv --camera made/camera-2.mkv \
  --calibration made/calibration.toml
expectText err.txt order

# Nothing is replaced unasked.
expectExit $kOutput new waved.toml "${cameras[@]}"
expectSentence waved.toml --force
expectExit 0 new waved.toml "${cameras[@]}" --force
expectText err.txt "guesses"

# A folder of recordings: cameras in the order of their names, numbers by value.
mkdir -p shots
cp made/camera-1.mkv "shots/cam 10.mkv"
cp made/camera-1.mkv "shots/cam 2.mkv"
expectExit 0 new shots.toml --footage shots
[[ $(grep '^name = "cam' shots.toml | tr '\n' ' ') == 'name = "cam 2" name = "cam 10" ' ]] ||
  fail "$(cat shots.toml)"
mkdir -p none
expectExit $kBadInput new none.toml --footage none
expectSentence none --footage
expectExit $kUsage new none.toml
expectSentence --camera --footage

# Its color is still to be learned.
expectExit $kBadInput track waved.toml --out out
expectSentence waved.toml target

expectExit $kBadInput new other.toml --camera a=nowhere.mp4
expectSentence nowhere.mp4
[[ ! -e other.toml ]] || fail "a project of nothing"

# Pictures of the empty room: a video will do; what is wrong is one sentence with file and camera.
expectExit 0 new empty.toml "${cameras[@]}" --calibration made/calibration.toml \
  --empty-room "camera 1=made/camera-1.mkv"
expectText empty.toml 'empty_room = "made/camera-1.mkv"'
[[ $(grep -c empty_room empty.toml) == 1 ]] || fail "$(cat empty.toml)"
expectExit $kBadInput new no.toml "${cameras[@]}" --empty-room "camera 1=nowhere.png"
expectSentence nowhere.png "camera 1"
expectExit $kBadInput new no.toml "${cameras[@]}" --calibration made/calibration.toml \
  --empty-room "camera 2=made/camera-1.mkv"
expectSentence camera-1.mkv "camera 2" "320 x 240"
expectExit $kBadInput new no.toml "${cameras[@]}" --empty-room nobody=made/camera-1.mkv
expectSentence --empty-room nobody
[[ ! -e no.toml ]] || fail "a project was written in spite of an error"

# A calibration of other names, or of images of another size, is refused with a way out.
expectExit 0 calibration convert made/calibration.toml renamed.toml --map "eye=camera 2"
sed 's/\[320, 240\]/[320, 248]/' renamed.toml >taller.toml
expectExit $kBadInput new fitted.toml "${cameras[@]}" --calibration taller.toml
expectSentence taller.toml "'camera 1', 'eye'" "'camera 2', 'camera 1'" --map
expectExit $kBadInput new fitted.toml "${cameras[@]}" --calibration taller.toml --map "camera 2=eye"
expectSentence taller.toml 'camera 1' '320 x 248' '320 x 240' --fit
expectExit 0 new fitted.toml "${cameras[@]}" --calibration taller.toml --map "camera 2=eye" --fit trim
expectText err.txt 'camera 1: cropped from 320 x 248 to 320 x 240 pixels'
expectText fitted.toml 'size = [320, 240]' 'size = [240, 320]'
expectExit $kUsage new other.toml "${cameras[@]}" --calibration taller.toml --map "camera 2"
expectSentence --map 'camera 2'
expectExit $kUsage new other.toml "${cameras[@]}" --fit crop
expectExit 0 calibration convert made/calibration.toml small.toml --fit crop --to-size 200x200
expectText out.txt 'camera 1: cropped from 320 x 240 to 200 x 200 pixels'
expectExit $kUsage calibration convert made/calibration.toml other.toml --fit crop
expectSentence --to-size
