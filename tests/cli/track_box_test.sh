# SPDX-License-Identifier: GPL-3.0-or-later
. "$(dirname "$0")/common.sh"

expectExit 0 track-box --help
expectText out.txt --box --click --out --method --set --seed --threads --frames --draw
expectExit $kUsage track-box
expectExit $kUsage track-box pictures --out o
expectSentence --box
expectExit $kUsage track-box pictures --box 1,2,3 --out o
expectSentence --box 1,2,3
expectExit $kUsage track-box pictures --box 1,2,3,4 --out o --method magic
expectExit $kUsage track-box pictures --box 1,2,3,4 --out o --set colour=3
expectSentence colour
expectExit $kBadInput track-box pictures --box 1,2,30,30 --out o
expectSentence pictures
[[ ! -e o ]] || fail "a refused command left its output folder behind"

expectExit 0 simulate demo --frames 20 --images --out scene
pictures=$(find scene -type d | while read -r folder; do
  compgen -G "$folder/*.png" >/dev/null && echo "$folder" || true
done | sort | head -n 1)
[[ -n $pictures ]] || fail "simulate left no pictures: $(find scene)"
expectExit $kBadInput track-box "$pictures" --box 5000,2,30,30 --out wrong
expectSentence box
for threads in 1 3; do
  expectExit 0 track-box "$pictures" --box 150,100,30,30 --method sugandi --seed 4 --threads $threads \
    --out o$threads --draw
done
cmp o1/boxes.csv o3/boxes.csv || fail "the number of threads changed the result"
expectText o1/boxes.csv '# method: sugandi' '# particles: 300' center_x_px
[[ $(rowCount o1/boxes.csv) == 20 ]] || fail "not 20 rows: $(cat o1/boxes.csv)"
[[ $(wc -l <o1/boxes_mot.txt) == 20 ]] || fail "not 20 rows: $(cat o1/boxes_mot.txt)"
[[ -s o1/boxes.mkv ]] || fail "no video was drawn"
expectExit 0 track-box "$pictures" --box 150,100,30,30 --box 50,50,20,20 --frames 5:9 --out two
[[ $(wc -l <two/boxes_mot.txt) == 8 ]] || fail "not 4 frames of 2 targets: $(cat two/boxes_mot.txt)"
