# SPDX-License-Identifier: GPL-3.0-or-later
# Killed while writing: what was written so far can be read and evaluated.
. "$(dirname "$0")/common.sh"

expectExit 0 track demo --out truth --frames 0:2
"$cli" track demo --out run --set iterations_per_frame=200 --particles 2000 >log.txt 2>&1 &
process=$!
# As soon as some rows exist, but long before 300 frames with 200 iterations are done.
for _ in $(seq 600); do
  [[ -s run/trajectory.csv && $(rowCount run/trajectory.csv) -ge 3 ]] && break
  kill -0 $process 2>/dev/null || fail "it ended by itself: $(cat log.txt)"
  sleep 0.1
done
kill -9 $process 2>/dev/null || fail "it ended before it could be killed: $(cat log.txt)"
wait $process 2>/dev/null || true
rows=$(rowCount run/trajectory.csv)
((rows >= 3)) || fail "only $rows rows were on disk"
((rows < 300)) || fail "it was not killed while writing"
expectExit 0 evaluate run/trajectory.csv truth/truth.csv
