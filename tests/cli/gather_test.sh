# SPDX-License-Identifier: GPL-3.0-or-later
# One of many jobs: done once, killed, repeated, gathered.
. "$(dirname "$0")/common.sh"

# Done: the same command does nothing, and says so; what changes the result does it again.
readonly -a job=(track smooth --frames 0:12 --label 'smooth, first' --out a)
expectExit 0 "${job[@]}"
[[ -s a/done.json && ! -e a/unfinished ]] || fail "no done.json: $(ls a)"
expectText a/done.json '"recording": "smooth, first"' '"frame_range": "0:12"' trajectory.csv truth.csv
cp a/trajectory.csv first.csv
stamp() { stat -c '%Y %i' a/trajectory.csv a/done.json; }
before=$(stamp)
expectExit 0 "${job[@]}"
expectText out.txt 'Nothing to do' --force
[[ $(stamp) == "$before" ]] || fail "it was done again"
expectExit 0 "${job[@]}" --threads 2
expectText out.txt 'Nothing to do'
expectExit 0 "${job[@]}" --force
! grep -q Nothing out.txt || fail "--force did nothing"
cmp a/trajectory.csv first.csv || fail "repeated, it gives something else"
expectExit 0 "${job[@]}" --set kld_error=0
! grep -q Nothing out.txt || fail "another parameter changed nothing"
expectText a/done.json '"settings": "kld_error=0"'
expectExit 0 "${job[@]}"
cmp a/trajectory.csv first.csv || fail "back again, it gives something else"
head -c 100 first.csv >a/trajectory.csv
expectExit 0 "${job[@]}"
cmp a/trajectory.csv first.csv || fail "a file that was cut is taken for a result"
# A run that fails is not done.
expectExit $kUsage "${job[@]}" --set nothing=1
expectExit 0 simulate smooth --frames 12 --images --out scene
expectExit 0 track scene/project.toml --out recorded
expectExit 0 track scene/project.toml --out recorded
expectText out.txt 'Nothing to do'
touch -d '+5 seconds' scene/camera-1/*5.png
expectExit 0 track scene/project.toml --out recorded
! grep -q Nothing out.txt || fail "other images changed nothing"
rm scene/camera-1/*5.png
expectExit 0 track scene/project.toml --out recorded --frames 0:4
head -c 100 scene/camera-1/*3.png >cut.png
mv cut.png "$(ls scene/camera-1/*3.png)"
expectExit $kEndedEarly track scene/project.toml --out recorded
[[ -e recorded/unfinished && ! -e recorded/done.json ]] || fail "half a run is done: $(ls recorded)"

# Killed half way: not taken for finished; the same command completes it.
readonly -a long=(track smooth --frames 0:40 --seed 3 --set iterations_per_frame=30 --out killed)
"$cli" "${long[@]}" >log.txt 2>&1 &
process=$!
for _ in $(seq 600); do
  [[ -s killed/trajectory.csv && $(rowCount killed/trajectory.csv) -ge 3 ]] && break
  kill -0 $process 2>/dev/null || fail "it ended by itself: $(cat log.txt)"
  sleep 0.1
done
kill -9 $process 2>/dev/null || fail "it ended before it could be killed"
wait $process 2>/dev/null || true
[[ -e killed/unfinished && ! -e killed/done.json ]] || fail "killed, but: $(ls killed)"
expectExit 0 evaluate a a/truth.csv --save
expectExit $kEndedEarly gather killed a nowhere --out gathered
expectText err.txt 'killed is unfinished' 'nowhere is missing'
expectText gathered/report.md '1 runs of 1 recordings; 1 missing, 1 unfinished' '- `killed`' '- `nowhere`'
[[ $(wc -l <gathered/results.csv) == 2 ]] || fail "more than one row: $(cat gathered/results.csv)"
expectExit 0 "${long[@]}"
expectExit 0 "${long[@]::6}" --set iterations_per_frame=30 --out whole
cmp killed/trajectory.csv whole/trajectory.csv || fail "completed after a kill, it is something else"

# Gathered: each result once, in one order.
expectExit 0 gather killed a --out one
printf 'a\nwhole\nkilled\n' >list.txt
expectExit 0 gather a --list list.txt --out two
expectText err.txt 'counted once'
cmp one/results.csv two/results.csv || fail "the order of the folders changes the table"
cmp one/report.md two/report.md || fail "the order of the folders changes the report"
[[ $(wc -l <two/results.csv) == 3 ]] || fail "two rows expected: $(cat two/results.csv)"
expectText two/results.csv '"smooth, first",track,dewpoint,,0:12,1,' 'smooth,track,dewpoint,iterations_per_frame=30,0:40,3,'
expectText two/times.csv seconds

expectExit $kUsage gather --out o
expectExit $kUsage evaluate a/trajectory.csv a/truth.csv --save
expectSentence --save
expectExit $kBadInput gather --list nothing.txt --out o
expectSentence nothing.txt
: >file
expectExit $kOutput gather a --out file/o
expectSentence file/o
echo '{' >a/done.json
expectExit $kBadInput gather a --out o
expectSentence a/done.json
# The same job with two results.
cp -r whole other
expectExit 0 track smooth --frames 0:6 --out other
sed -i 's/"frame_range": "0:6"/"frame_range": "0:40"/; s/"seed": 1/"seed": 3/; s/"settings": ""/"settings": "iterations_per_frame=30"/' other/done.json
expectExit $kBadInput gather whole other --out o
expectSentence whole other
[[ ! -e o ]] || fail "a table was written all the same"

# People.
printf 'format = 1\nmethod = "people"\nscene = "office"\n[parameters]\nparticles = 50\n' >office.toml
expectExit 0 people office.toml --frames 0:3 --person 0,0,1 --out people
[[ -s people/done.json && ! -e people/unfinished ]] || fail "people are not done: $(ls people)"
expectExit 0 people office.toml --frames 0:3 --person 0,0,1 --out people
expectText out.txt 'Nothing to do'
expectExit 0 gather people --out o
expectText o/results.csv 'office.toml,people,people,'
