# SPDX-License-Identifier: GPL-3.0-or-later
# A disk that is full: one sentence names the file that could not be written, what was written can be
# read, and nothing half-written lies around. Needs a small file system of its own, in a namespace of
# its own: where the system allows none, the test is skipped.
. "$(dirname "$0")/common.sh"

mkdir small
if [[ -z ${DEWPOINT_SMALL_DISK:-} ]]; then
  unshare --user --map-root-user --mount true 2>/dev/null || {
    echo 'SKIPPED: no namespace for a small file system'
    exit 77
  }
  DEWPOINT_SMALL_DISK=1 exec unshare --user --map-root-user --mount bash "$0" "$cli" "$PWD"
fi
mount -t tmpfs -o size=80k tmpfs small || exit 77

expectExit $kOutput track demo --out small/run --frames 0:2000 --set iterations_per_frame=1
expectSentence small/run/trajectory.csv
[[ ! -e small/run/run.json.part ]] || fail "half a file is left"
expectText small/run/run.json '"finished": false'
rows=$(rowCount small/run/trajectory.csv)
((rows > 50 && rows < 300)) || fail "$rows rows fit"
cp -r small/run kept
expectExit 0 evaluate kept/trajectory.csv kept/truth.csv

rm -r small/run

# People: what is said is what failed first, not the picture that found no room either (libpng says
# something of its own about that). Hulls and curves of 40 frames take twice the room there is: about
# 10 of the 23 rows of the trajectory fit.
printf 'format = 1\nmethod = "people"\nscene = "office"\n[parameters]\nparticles = 50\n' >office.toml
expectExit $kOutput people office.toml --out small/people --frames 0:40 --person 0,0,1 --overlay 3
sed -i '/^libpng /d' err.txt
expectSentence small/people/ .csv
[[ ! -s small/people/overlay.png ]] || fail "part of a picture is left"
rows=$(rowCount small/people/trajectory.csv)
((rows > 5 && rows < 20)) || fail "$rows rows fit"
rm -r small/people

# No room at all.
expectExit 0 simulate demo --frames 4 --images --out scene
head -c 200k /dev/zero >small/filler 2>/dev/null || true
expectExit $kOutput track demo --out small --frames 0:2
expectSentence small/unfinished
expectExit $kOutput people office.toml --out small --frames 0:2
expectSentence small/unfinished
expectExit $kOutput track-box scene/camera-1 --box 150,100,30,30 --out small/boxes
expectSentence small/boxes/boxes.csv
expectExit $kOutput simulate still --frames 30 --out small
expectSentence small/camera-1.mkv 'cannot be written'

# A take of a live camera: what was recorded before can be opened.
rm -rf small/*
printf 'format = 2\nmethod = "histogram"\n[[camera]]\nname = "left"\nstream = "%s"\n' \
  'test:ball?width=160&height=120&rate=15&encoding=mjpeg' >live.toml
expectExit $kOutput record live.toml --out small/takes --seconds 30
expectSentence small/takes/take-001/left "pace left"
[[ $(rowCount small/takes/take-001/left.csv) -gt 3 ]] || fail "nothing was recorded"
cp -r small/takes kept-takes
"$cli" doctor kept-takes/take-001/project.toml --every-frame --json >doctor.txt 2>/dev/null || true
! grep -qE '"recording-(missing|unreadable)"|"frame-unreadable"|"video-cut-off"|"times-' doctor.txt || fail "the doctor objects: $(cat doctor.txt)"
