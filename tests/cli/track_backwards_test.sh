# SPDX-License-Identifier: GPL-3.0-or-later
# From a position that is said in one frame a target is followed back in time.
. "$(dirname "$0")/common.sh"

readonly kFrames=30 kSaid=20
expectExit 0 simulate demo --frames $kFrames --out made
expectExit 0 new fresh.toml --camera "camera 1=made/camera-1.mkv" \
  --camera "camera 2=made/camera-2.mkv" --calibration made/calibration.toml
expectExit 0 learn-color fresh.toml --frame 2 --pixel 157,117 --target ball --radius 0.035 --out taught.toml

# A filter that starts far from the ball never finds it.
sed -e 's/^method = .*/method = "barrera"/' -e '/^\[parameters\]/,/^$/d' \
  -e '/^\[\[target\]\]/i [parameters]\nstart_x = 3.0\nstart_y = 3.0\n' taught.toml >lost.toml

expectExit $kBadInput track-backwards lost.toml --out found.toml
expectSentence lost.toml correction

read -r x y z < <(awk -F, -v frame=$kSaid '!/^#/ && $2 == frame {print $4, $5, $6}' made/truth.csv)
cat >>lost.toml <<END

[[correction]]
frame = $kSaid
target = 1
position = [$x, $y, $z]
covariance = [1e-4, 0, 0, 1e-4, 0, 1e-4]
END

# position FOLDER FRAME: x of the ball there, millimeters.
position() {
  awk -F, -v frame="$2" '!/^#/ && $2 == frame {printf "%d\n", 1000 * $4}' "$1"
}
expectExit 0 track lost.toml --out before
readonly truth=$(position made/truth.csv 5)
off=$(($(position before/trajectory.csv 5) - truth))
((off * off > 100 * 100)) || fail "it was not lost in frame 5, $off mm off"

expectExit 0 track-backwards lost.toml --out found.toml --threads 2
expectText out.txt "ball, frame $kSaid: followed back to frame 0."
expectText found.toml "tracked_from = $kSaid"
expectExit 0 track found.toml --out after
off=$(($(position after/trajectory.csv 5) - truth))
((off * off < 30 * 30)) || fail "in frame 5 it is $off mm off"
expectText after/run.json "\"tracked_from\": $kSaid"

# Again: what was found before is replaced by the same.
expectExit 0 track-backwards found.toml --out again.toml
cmp found.toml again.toml || fail "it found something else the second time"
