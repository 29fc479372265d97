# SPDX-License-Identifier: GPL-3.0-or-later
# Live cameras are recorded into a folder that opens as a project. Test patterns stand for cameras.
. "$(dirname "$0")/common.sh"

cat >live.toml <<'TOML'
format = 2
name = "desk"
method = "histogram"
[[camera]]
name = "left"
stream = "test:ball?width=320&height=240&encoding=mjpeg"
[[camera]]
name = "right"
stream = "test:smpte?width=320&height=240&rate=15"
TOML

expectExit 0 record live.toml --out takes --seconds 2 --take-notes "first one"
expectText out.txt "Take 1: " takes/take-001 "left: " "right: " "0 dropped" "times by driver"
for file in left.mkv left.csv right.mkv right.csv project.toml take.json; do
  [[ -s takes/take-001/$file ]] || fail "$file is missing"
done
expectText takes/take-001/take.json '"finished": true' '"notes": "first one"'
rows=$(rowCount takes/take-001/left.csv)
((rows >= 50 && rows <= 66)) || fail "$rows images in 2 s at 30 per second"
rows=$(rowCount takes/take-001/right.csv)
((rows >= 25 && rows <= 34)) || fail "$rows images in 2 s at 15 per second"

# It opens, every image can be read, and the times are those of the images.
"$cli" doctor takes/take-001/project.toml --every-frame --json >doctor.txt 2>/dev/null || true
! grep -qE '"recording-(missing|unreadable)"|"frame-unreadable"|"video-cut-off"|"times-' doctor.txt || fail "the doctor objects: $(cat doctor.txt)"

# The next take has the next number; a camera that is not there is reported, the others are recorded.
sed 's|^stream = "test:smpte.*|device = "/dev/video987"|' live.toml >silent.toml
expectExit $kEndedEarly record silent.toml --out takes --seconds 1
expectText err.txt "camera 'right'" "no images"
expectText out.txt "Take 2: " "right: no images"
expectText takes/take-002/project.toml left.mkv
! grep -q right takes/take-002/project.toml || fail "a camera without images is in the project"

# The end of all streams, and Ctrl+C, end a take as its time does.
sed 's|?width|?frames=20\&width|' live.toml >short.toml
expectExit 0 record short.toml --out takes
expectText takes/take-003/take.json '"finished": true'
"$cli" record live.toml --out takes >out.txt 2>err.txt &
process=$!
for _ in $(seq 100); do
  [[ -s takes/take-004/project.toml ]] && break
  sleep 0.1
done
kill -INT $process
wait $process || fail "Ctrl+C ended it with $?: $(cat err.txt)"
expectText takes/take-004/take.json '"finished": true'

# A line starts a take that begins before it; the next line stops it.
mkfifo trigger
"$cli" record live.toml --out triggered --wait --pre-roll 2 <trigger >out.txt 2>err.txt &
process=$!
exec 9>trigger
sleep 3
[[ ! -e triggered ]] || fail "a take has begun before its signal"
echo go >&9
for _ in $(seq 100); do
  [[ -s triggered/take-001/project.toml ]] && break
  sleep 0.1
done
sleep 1
echo stop >&9
wait $process || fail "a second line ended it with $?: $(cat err.txt)"
exec 9>&-
expectText out.txt "Take 1: " "Before the start: "
rows=$(rowCount triggered/take-001/left.csv)
((rows >= 75)) || fail "$rows images with 2 s at 30 per second before the start"
before=$(grep -o '"pre_roll": [0-9.]*' triggered/take-001/take.json | cut -d' ' -f2)
awk -v s="$before" 'BEGIN { exit !(s > 1.5 && s < 3) }' || fail "$before s before the start"
expectExit $kEndedEarly record live.toml --out triggered --wait </dev/null
expectText err.txt "standard input" "no line came"
expectExit $kUsage record live.toml --out triggered --pre-roll 2
expectSentence --wait

# Remote commands start and stop it as well; its token is needed.
echo "a secret word" >token.txt
"$cli" record live.toml --out remote --wait --tcp 0 --token-file token.txt </dev/null >out.txt 2>err.txt &
process=$!
python3 - out.txt <<'PYTHON' || fail "remote commands: $(cat err.txt)"
import json, pathlib, re, socket, sys, time
deadline = time.monotonic() + 60
port = None
while port is None and time.monotonic() < deadline:
    port = re.search(r":(\d+)", pathlib.Path(sys.argv[1]).read_text())
    time.sleep(0.1)
connection = socket.create_connection(("127.0.0.1", int(port[1])))
replies = connection.makefile()
def ask(**command):
    connection.sendall((json.dumps(command) + "\n").encode())
    return json.loads(replies.readline())
assert not ask(command="record", token="a guessed word")["ok"]
assert not ask(command="stop-recording", token="a secret word")["ok"]
assert not ask(command="start", token="a secret word")["ok"]
assert ask(command="record", name="jump-3", token="a secret word")["ok"]
assert not ask(command="record", token="a secret word")["ok"]
while not pathlib.Path("remote/take-001/project.toml").exists() and time.monotonic() < deadline:
    time.sleep(0.1)
assert ask(command="stop-recording", token="a secret word")["ok"]
PYTHON
wait $process || fail "stop-recording ended it with $?: $(cat err.txt)"
expectText remote/take-001/take.json '"notes": "jump-3"' '"finished": true'
expectExit $kBadInput record live.toml --out remote --wait --tcp 0
expectSentence token
expectExit $kUsage record live.toml --out remote --tcp 0
expectSentence --wait

# A take has the number that is asked for, once; the next one counts up from there.
expectExit 0 record short.toml --out takes --take 20
expectText takes/take-020/take.json '"take": 20'
expectExit $kBadInput record short.toml --out takes --take 20
expectSentence "take 20 exists"
expectExit $kUsage record short.toml --out takes --take 0
expectSentence --take

# A take in which nothing was tracked has nothing to compare.
expectExit $kBadInput take check takes/take-001
expectSentence takes/take-001 "nothing was tracked"
expectExit $kUsage take
expectExit $kUsage take check

expectExit $kBadInput record demo --out o
expectSentence "only live cameras"
expectExit $kOutput record live.toml --out /proc/none --seconds 1
expectSentence /proc/none
expectExit $kUsage record live.toml --out o --seconds 0
expectSentence --seconds
