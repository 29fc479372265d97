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

# As a project: one video without any calibration, a box in the project file.
expectExit 0 simulate demo --frames 20 --out film
expectExit 0 new one.toml --camera film/camera-1.mkv
[[ ! -s err.txt ]] || fail "nothing was to be said: $(cat err.txt)"
expectText one.toml 'method = "histogram"'
expectExit $kBadInput track one.toml --out none
expectSentence target
printf '\n[[target]]\nname = "ball"\nbox = {camera = 1, frame = 2, x = 150, y = 100, width = 30, height = 30}\n' >>one.toml
for threads in 1 3; do
  expectExit 0 track one.toml --threads $threads --out project$threads
done
cmp project1/boxes.csv project3/boxes.csv || fail "the number of threads changed the result"
expectText project1/boxes.csv '# method: histogram' '# target 1: ball, box 150 100 30 30 px at frame 2'
[[ $(rowCount project1/boxes.csv) == 18 ]] || fail "not frames 2 to 19: $(cat project1/boxes.csv)"
[[ -s project1/boxes_mot.txt && -s project1/run.json ]] || fail "no MOT file or report"
[[ ! -e project1/trajectory.csv ]] || fail "a trajectory in space of a box in an image"
printf 'format = 2\nname = "bare"\nmethod = "sugandi"\n[[target]]\nname = "ball"\nbox = {camera = 1, x = 150, y = 100, width = 30, height = 30}\n[[camera]]\nname = "only"\nvideo = "film/camera-1.mkv"\n' >bare.toml
expectExit 0 track bare.toml --out bare
[[ $(rowCount bare/boxes.csv) == 20 ]] || fail "not 20 rows: $(cat bare/boxes.csv)"
# A scene brings its cameras only when it is opened.
printf 'format = 2\nname = "far"\nmethod = "histogram"\nscene = "occluder"\n[[target]]\nname = "ball"\nbox = {camera = 1, x = 900, y = 97, width = 46, height = 46}\n' >far.toml
expectExit $kBadInput track far.toml --out far
expectSentence far.toml 'target 1.box'
[[ ! -e far/boxes.csv ]] || fail "boxes of a target that is not in the image"
sed -i 's/x = 150/x = 1500/' bare.toml
expectExit $kBadInput track bare.toml --out bare2
expectSentence box
expectSentence bare.toml 'target 1.box'
