# SPDX-License-Identifier: GPL-3.0-or-later
# People from a written recording to judged identities.
. "$(dirname "$0")/common.sh"

expectExit 0 experiment people-apart --record office --seed 3
for file in office/project.toml office/truth.csv office/calibration.toml office/camera-4.mkv; do
  [[ -s $file ]] || fail "$file is missing"
done
expectExit 0 people office/project.toml --out run --seed 1 --overlay 3
for file in run/trajectory.csv run/volumes.csv run/hulls.csv run/ground.csv run/overlay.png; do
  [[ -s $file ]] || fail "$file is missing"
done
# The same bits with other numbers of threads.
expectExit 0 people office/project.toml --out again --seed 1 --threads 3
for file in trajectory.csv volumes.csv hulls.csv ground.csv; do
  cmp -s "run/$file" "again/$file" || fail "$file differs between 1 and 3 threads"
done
expectExit 0 evaluate run/trajectory.csv office/truth.csv --identities --ground --gate 0.5
expectText out.txt MOTA HOTA GOSPA ' 0 switches'

expectExit 0 people --list
expectText out.txt mohedano-ms mohedano-msc hue_floor acceleration_sigma
expectExit $kUsage people office/project.toml --out run --set no_such=1
expectSentence no_such
expectExit $kUsage people office/project.toml --out run --person 1,2
expectSentence --person
expectExit $kUsage people office/project.toml --out run --person 99,99,1
expectSentence --person "99,99,1" "-3.4 to 3.4"
expectExit $kUsage people office/project.toml --out run --person 0,0,9
expectSentence --person "0,0,9"
expectExit $kUsage people office/project.toml
expectExit $kBadInput people missing.toml --out run

# A project may name the method, and the built-in office; track sends such a project here.
printf 'format = 1\nmethod = "mohedano-ms"\nscene = "office"\n[parameters]\nparticles = 50\n' >office.toml
expectExit $kBadInput track office.toml --out tracked
expectSentence method "dewpoint-cli people"
expectExit 0 people office.toml --out named --frames 0:3
expectText named/trajectory.csv mohedano-ms "particles: 50"

# As track does, it says when cameras cannot agree: lengths of a thousand times are no meters...
awk '/^translation = / { gsub(/[][,]/, "")
       printf "translation = [%.9g, %.9g, %.9g]\n", 1000 * $3, 1000 * $4, 1000 * $5; next } 1' \
  office/project.toml >office/far.toml
expectExit 0 people office/far.toml --out far --frames 0:2
[[ $(grep -c 'note: the calibration seems to be in units of 0.001 m' err.txt) == 1 ]] ||
  fail "it is to be said once: $(cat err.txt)"
expectExit 0 people office/project.toml --out near --frames 0:2
[[ ! -s err.txt ]] || fail "nothing was to be said: $(cat err.txt)"

# ... and when one was moved: from frame 30 on camera 1 looks 6 cm beside where it did, at 2.24 m.
scene() {
  printf 'frames_per_second = 10\nframe_count = 30\nclutter = true\n'
  printf '[[camera]]\nwidth = 320\nheight = 240\nfocal = [250, 250]\nposition = [%s]\ntarget = [%s]\n' \
    '0.0, -2.0, 1.0' "$1" '-2.0, 0.0, 1.0' '0.0, 0.0, 0.0'
}
scene '0.0, 0.0, 0.0' >before.toml
scene '0.06, 0.0, 0.0' >after.toml
expectExit 0 simulate before.toml --images --out moved
expectExit 0 simulate after.toml --images --out after
for camera in camera-1 camera-2; do
  for frame in {0..29}; do
    cp "after/$camera/$(printf %06d "$frame").png" "moved/$camera/$(printf %06d $((frame + 30))).png"
  done
done
expectExit 0 people moved/project.toml --method people --out still
[[ $(grep -c 'note: camera 1: .* was rotated by' err.txt) == 1 ]] ||
  fail "it is to be said once: $(cat err.txt)"
