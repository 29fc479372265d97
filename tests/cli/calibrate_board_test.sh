# SPDX-License-Identifier: GPL-3.0-or-later
# Lenses and poses from a board.
. "$(dirname "$0")/common.sh"

# Boards to print: one page of A4 is 595 x 842 points.
expectExit 0 calibration print-board chessboard:9x6:0.025 --paper A4 board.pdf
[[ $(head -c 5 board.pdf) == %PDF- ]] || fail "board.pdf is no PDF"
grep -aq 'MediaBox *\[ *0 0 841.*595' board.pdf || fail "not A4 lengthwise"
expectExit $kUsage calibration print-board chessboard:9x6:25 no.pdf
expectSentence BOARD millimeters
expectExit $kUsage calibration print-board chessboard:9x6:0.025 --paper B5 no.pdf
expectSentence --paper A4
expectExit 0 calibration print-board chessboard:9x6:0.05 --paper A3 sheets.pdf
expectText out.txt '2 sheets' 'page 1'
grep -aq '/Count 3' sheets.pdf || fail "not a plan and two sheets"
expectExit $kBadInput calibration print-board chessboard:9x6:0.9 no.pdf
expectSentence --paper '64 sheets'
expectExit $kOutput calibration print-board chessboard:9x6:0.025 nowhere/board.pdf
expectSentence nowhere/board.pdf

# One sentence says what is wrong, and nothing is written.
expectExit $kUsage calibrate intrinsics demo
expectExit $kUsage calibrate intrinsics demo --board checker:9x6:0.025 --out no.toml
expectSentence --board checker
expectExit $kBadInput calibrate intrinsics none.jpg --board chessboard:9x6:0.025 --out no.toml
expectSentence none.jpg
printf 'no picture' >bad.jpg
expectExit $kBadInput calibrate intrinsics bad.jpg --board chessboard:9x6:0.025 --out no.toml
expectSentence bad.jpg image
expectExit $kBadInput calibrate intrinsics demo --looks 3 --board chessboard:9x6:0.025 --out no.toml
expectSentence 'camera 1' 'board'
expectExit $kBadInput calibrate extrinsics demo --looks 3 --board chessboard:9x6:0.025 --out no.toml
expectSentence 'camera 2' 'board'
expectExit $kUsage calibrate intrinsics demo --frames 9:3 --board chessboard:9x6:0.025 --out no.toml
expectSentence --frames 9:3
expectExit $kUsage calibrate intrinsics bad.jpg --frames 0:3 --board chessboard:9x6:0.025 --out no.toml
expectSentence --frames 'image files'
expectExit $kBadInput calibrate intrinsics demo --frames 1000000: --board chessboard:9x6:0.025 --out no.toml
expectSentence --frames 'the recording has only'
# A board that is not the described one is found, and the sentence says how to go on.
expectExit 0 simulate board --frames 60 --out shown
expectExit 0 new shown.toml --camera left=shown/left.mkv --camera right=shown/right.mkv
expectExit 0 calibrate find-board shown.toml --square 0.025
expectText out.txt 'chessboard:9x6:0.025' '9 x 6 inner corners' 'images'
! grep -q 'Replace' out.txt || fail "the square is known: $(cat out.txt)"
expectExit $kBadInput calibrate intrinsics shown.toml --board charuco:7x5:0.025:0.019:DICT_4X4_50 --out no.toml
expectSentence charuco:7x5 'not found' '--board chessboard:9x6:0.025'
expectExit $kBadInput calibrate extrinsics shown.toml --board charuco:7x5:0.025:0.019:DICT_4X4_50 --out no.toml \
  --search-all
expectSentence '--board chessboard:9x6:0.025'
expectExit $kBadInput calibrate find-board demo --looks 2
expectSentence board 'images searched'
expectExit $kBadInput calibrate find-board none.jpg
expectSentence none.jpg
expectExit $kUsage calibrate find-board demo --square 0
expectExit $kUsage calibrate intrinsics bad.jpg --mend-mirrored --board chessboard:9x6:0.025 --out no.toml
expectSentence --mend-mirrored 'image files'
[[ ! -e no.toml && ! -e no.pdf ]] || fail "something was written in spite of an error"

pictures=${DEWPOINT_DATA:-}/opencv_left13
[[ -d $pictures ]] || exit 77

# The published calibration of OpenCV's sample pictures: rms 0.39259, f 535.916.
expectExit 0 calibrate intrinsics --board chessboard:9x6:0.025 "$pictures"/left*.jpg --out left.toml \
  --report left.html
expectText out.txt 'RMS 0.3926 px' 'K [[535.9' 'distortion [-0.266' 'doubtful: left02.jpg'
expectText left.toml 'size = [640, 480]' 'matrix = [[535.9'
expectText left.html '<svg' 'left02.jpg'
cp left.toml first.toml
expectExit 0 calibrate find-board "$pictures"/left*.jpg
expectText out.txt 'chessboard:9x6:' '12 images' 'Replace 0.025'
expectExit 0 calibrate intrinsics --board chessboard:9x6:0.025 "$pictures"/left*.jpg --out left.toml
cmp first.toml left.toml || fail "a second run gives other numbers"

# Ctrl-C: the previous calibration stays as it was.
"$cli" calibrate intrinsics --board chessboard:8x5:0.025 "$pictures"/left*.jpg "$pictures"/left*.jpg \
  "$pictures"/left*.jpg --corners exact --out left.toml >out.txt 2>err.txt &
process=$!
# As soon as the program, not the shell before it, heeds Ctrl-C: signal 2, the second bit of those that
# are caught. Progress it shows on terminals only.
heedsCtrlC() {
  [[ $(cat /proc/$process/comm) != bash ]] && grep -q '^SigCgt:.*[2367abef]$' /proc/$process/status
}
for _ in $(seq 600); do
  heedsCtrlC && break
  kill -0 $process 2>/dev/null || fail "it ended by itself: $(cat out.txt err.txt)"
  sleep 0.1
done
kill -INT $process 2>/dev/null || fail "it ended before it could be stopped: $(cat out.txt err.txt)"
code=0
wait $process || code=$?
[[ $code == 130 ]] || fail "after Ctrl-C it ended with $code: $(cat out.txt err.txt)"
expectText err.txt 'the previous calibration is kept'
cmp first.toml left.toml || fail "an interrupted calibration changed the file"
