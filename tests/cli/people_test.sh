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
