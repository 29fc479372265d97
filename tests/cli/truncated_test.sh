# SPDX-License-Identifier: GPL-3.0-or-later
# A video that breaks off: the results so far are kept, and the exit code says so.
. "$(dirname "$0")/common.sh"

expectExit 0 simulate smooth --out scene --frames 40
video=$(ls -S scene/*.mkv | head -n 1)
size=$(stat -c %s "$video")
# Matroska announces the number of frames at its start, so half a file ends before its own end.
truncate -s $((size / 2)) "$video"
expectExit $kEndedEarly track scene/project.toml --out run
expectSentence "$(basename "$video")"
rows=$(rowCount run/trajectory.csv)
((rows > 5 && rows < 40)) || fail "$rows rows from half of 40 frames"
expectExit 0 evaluate run/trajectory.csv scene/truth.csv

# No frame at all is bad input, not an early end.
: >"$video"
expectExit $kBadInput track scene/project.toml --out run2
expectSentence "$(basename "$video")"
rm "$video"
expectExit $kBadInput track scene/project.toml --out run3
expectSentence "$(basename "$video")"
