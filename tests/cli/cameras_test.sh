# SPDX-License-Identifier: GPL-3.0-or-later
# Cameras that are connected are listed, whether there are any or not; those of a project are locked.
. "$(dirname "$0")/common.sh"

expectExit 0 cameras
[[ -s out.txt ]] || expectSentence "no camera is connected"
expectExit 0 cameras --json
python3 -c 'import json, sys; assert isinstance(json.load(open("out.txt")), list)' || fail "no JSON array"
expectExit 0 cameras --controls --json
expectExit 0 cameras lock --help
expectText out.txt PROJECT CAMERA --seconds --out

cat >live.toml <<'TOML'
format = 2
name = "desk"
method = "histogram"
[[camera]]
name = "left"
device = "/dev/video987"
[camera.identity]
serial = "no such number"
name = "Webcam of nobody"
[[camera]]
name = "right"
device = "/dev/video986"
[[camera]]
name = "far"
stream = "test:ball"
TOML
cp live.toml before.toml

expectExit $kBadInput cameras lock live.toml
expectSentence live.toml "camera 'left'" "'Webcam of nobody' (serial number no such number) is not connected"
expectExit $kBadInput cameras lock live.toml right
expectSentence "camera 'right'" "/dev/video986"
expectExit $kBadInput cameras lock live.toml far
expectSentence live.toml "'far'"
expectExit $kBadInput cameras lock missing.toml
expectSentence missing.toml
cmp -s live.toml before.toml || fail "a failed lock has changed the project"
expectExit $kUsage cameras lock live.toml --seconds 0
expectSentence --seconds

# A missing device is named when the project is recorded or checked, too.
expectExit $kEndedEarly record live.toml --out takes --seconds 1
expectText err.txt "camera 'left'" "'Webcam of nobody'" "is not connected"
"$cli" doctor live.toml >doctor.txt 2>/dev/null || true
expectText doctor.txt "'Webcam of nobody'"

# What a device cannot be is one sentence with the field.
sed 's|^serial = .*|serial = 5|' before.toml >wrong.toml
expectExit $kBadInput record wrong.toml --out takes
expectSentence wrong.toml "camera 1.identity.serial"
