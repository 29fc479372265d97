# SPDX-License-Identifier: GPL-3.0-or-later
# What is wrong with a project, one line each.
. "$(dirname "$0")/common.sh"

# Built-in scenes are fine.
expectExit 0 doctor demo
! grep -qE '^(note|problem)' out.txt || fail "$(cat out.txt)"
expectText out.txt "Simulated cameras: 2"

# A recording with a project is fine, too.
expectExit 0 simulate demo --frames 30 --out made
project=made/project.toml
expectExit 0 doctor "$project"
! grep -q '^problem' out.txt || fail "$(cat out.txt)"

# Without one of its videos it is not: exit code 1, and the line says file and field.
mv made/camera-1.mkv gone.mkv
expectExit 1 doctor "$project"
expectText out.txt "problem  The recording of 'camera 1' is missing" "camera 1.video" "Put the missing file or folder back"
[[ ! -s err.txt ]] || fail "nothing was to be said: $(cat err.txt)"

# The same for programs.
expectExit 1 doctor "$project" --json
python3 - <<'PY' || fail "$(cat out.txt)"
import json
found = json.load(open("out.txt"))
assert found["level"] == "problem", found
assert any(f["check"] == "recording-missing" and f["field"] == "camera 1.video"
           for f in found["findings"]), found
PY
mv gone.mkv made/camera-1.mkv

# All frames.
expectExit 0 doctor "$project" --every-frame

# What is no project at all.
printf 'format = 2\nname = \n' >broken.toml
expectExit 1 doctor broken.toml
expectText out.txt "problem  The project cannot be read" broken.toml
expectExit 1 doctor nowhere.toml
expectText out.txt "problem" nowhere.toml
