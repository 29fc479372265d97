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

# No room at all.
rm -r small/run
head -c 200k /dev/zero >small/filler 2>/dev/null || true
expectExit $kOutput track demo --out small --frames 0:2
expectSentence small/t
expectExit $kOutput simulate still --frames 30 --out small
expectSentence small/camera-1.mkv 'cannot be written'
