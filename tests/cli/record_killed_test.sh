# SPDX-License-Identifier: GPL-3.0-or-later
# Killed while it records: at most the last 2 s are missing, and what is there opens as a project. More
# kills: DEWPOINT_KILLS=200.
. "$(dirname "$0")/common.sh"

cat >live.toml <<'TOML'
format = 2
method = "histogram"
[[camera]]
name = "left"
stream = "test:ball?width=320&height=240&encoding=mjpeg"
[[camera]]
name = "middle"
stream = "test:ball?width=320&height=240&encoding=h264"
[[camera]]
name = "right"
stream = "test:smpte?width=320&height=240&rate=15"
TOML

# milliseconds NUMBER: seconds with a fraction as whole milliseconds
milliseconds() { awk -v s="$1" 'BEGIN { printf "%d", s * 1000 }'; }

worst=0
for kill in $(seq "${DEWPOINT_KILLS:-5}"); do
  rm -rf takes
  "$cli" record live.toml --out takes >log.txt 2>&1 &
  process=$!
  for _ in $(seq 300); do
    [[ $(grep -c "video = " takes/take-001/project.toml 2>/dev/null) == 3 ]] && break
    kill -0 $process 2>/dev/null || fail "it ended by itself: $(cat log.txt)"
    sleep 0.05
  done
  sleep "$((RANDOM % 3)).$((RANDOM % 10))$((RANDOM % 10))"
  # The take begins when take.json is written; it is written again only at its end.
  began=$(milliseconds "$(stat -c %.Y takes/take-001/take.json)")
  killed=$(milliseconds "$(date +%s.%N)")
  kill -9 $process
  wait $process 2>/dev/null || true
  expectText takes/take-001/take.json '"finished": false'
  for camera in left middle right; do
    last=$(grep -v '^#' takes/take-001/$camera.csv | awk -F, 'NF == 3 { t = $2 } END { print t }')
    missing=$((killed - began - $(milliseconds "$last")))
    ((missing <= 2000)) || fail "kill $kill: $missing ms of $camera are missing in the times"
    ((worst >= missing)) || worst=$missing
  done
  # Every image can be read, and there are as many of them as times, but for the last ones.
  "$cli" doctor takes/take-001/project.toml --every-frame --json >doctor.txt 2>/dev/null || true
  ! grep -qE '"recording-(missing|unreadable)"|"frame-unreadable"|"video-cut-off"|"times-' doctor.txt || fail "kill $kill: $(cat doctor.txt)"
done
echo "at most $worst ms were missing"
