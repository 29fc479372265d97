# SPDX-License-Identifier: GPL-3.0-or-later
# The accuracy suite: list, run, resume, threads, bad input.
. "$(dirname "$0")/common.sh"

expectExit 0 suite --help
expectText out.txt --list --scenario --method --grade --seeds --first-seed --threads --out --merge --part
expectExit 0 suite --list
expectText out.txt S0-slow triangulation-kalman camshift barrera

readonly -a few=(--scenario S0-slow --grade ideal --first-seed 1 --method triangulation,camshift)
# rows FILE: everything but the measured time, which is the last but one column.
rows() { sed 's/,[^,]*,\([^,]*\)$/,\1/' "$1"; }

expectExit 0 suite "${few[@]}" --seeds 2 --threads 2 --out both
for file in report.html runs.csv summary.csv belief.csv report.json traces.csv skipped.csv; do
  [[ -s both/$file ]] || fail "$file is missing"
done
[[ $(wc -l <both/runs.csv) == 5 ]] || fail "a header and four rows expected: $(cat both/runs.csv)"
expectText both/runs.csv scenario,grade,method,seed,rmse_mm S0-slow,ideal,triangulation,2,
expectText both/report.html TUNING '<svg' S0-slow

# In two parts, with a last row that was cut, one thread: the same.
expectExit 0 suite "${few[@]}" --seeds 1 --out parts
cp parts/runs.csv whole.csv
head -c -4 whole.csv >parts/runs.csv
expectExit 0 suite "${few[@]}" --seeds 2 --out parts
cmp <(rows both/runs.csv) <(rows parts/runs.csv) || fail "resumed, it gives something else"
cmp both/traces.csv parts/traces.csv || fail "resumed, its traces are others"
before=$(md5sum parts/runs.csv)
expectExit 0 suite "${few[@]}" --seeds 2 --out parts
[[ $before == $(md5sum parts/runs.csv) ]] || fail "nothing was left to do, but the rows have changed"

# Run apart and put together: the same.
expectExit 0 suite "${few[@]}" --seeds 1 --out first
expectExit 0 suite --scenario S0-slow --grade ideal --first-seed 2 --seeds 1 \
  --method triangulation,camshift --out second
before=$(md5sum first/runs.csv)
expectExit 0 suite --merge first second --out merged
cmp <(rows both/runs.csv) <(rows merged/runs.csv) || fail "merged, it gives something else"
cmp both/traces.csv merged/traces.csv || fail "merged, its traces are others"
[[ $before == $(md5sum first/runs.csv) ]] || fail "a folder that was merged has changed"
expectText merged/report.json '"reporting_seeds": false'
expectExit $kBadInput suite --merge first nowhere --out merged
expectSentence nowhere
[[ ! -e nowhere ]] || fail "a folder that is not there was made"
expectExit $kUsage suite --merge first --seeds 2 --out merged

# A run that its scenario cannot make is skipped, once and for all; the others are run. Nothing at all
# of a scenario is an error, but not of a part.
readonly none='is skipped: no position.'
mkdir one two
printf 'scenario,grade,seed,reason\nS0-slow,ideal,1,"no position"\n' | tee one/skipped.csv >two/skipped.csv
expectExit $kBadInput suite "${few[@]}" --seeds 1 --out one
expectText err.txt "S0-slow, grade ideal, seed 1 $none" 'S0-slow, grade ideal: every run was skipped'
expectExit 0 suite "${few[@]}" --seeds 1 --part --out one
expectText err.txt "S0-slow, grade ideal, seed 1 $none"
[[ $(wc -l <one/runs.csv) == 1 ]] || fail "a skipped run was run: $(cat one/runs.csv)"
expectExit 0 suite "${few[@]}" --seeds 2 --out two
expectText err.txt "S0-slow, grade ideal, seed 1 $none" 'Skipped runs: 1.'
[[ $(wc -l <two/runs.csv) == 3 ]] || fail "two rows of seed 2 expected: $(cat two/runs.csv)"
expectText two/report.html 'Skipped runs: 1.' 'seed 1 is skipped'
expectText two/report.json '"reason": "no position"'
expectExit 0 suite --merge one second --out gaps
expectText err.txt "seed 1 $none"
cmp one/skipped.csv gaps/skipped.csv || fail "the merged folder has other skipped runs"
expectExit $kBadInput suite --merge one --out alone
expectText err.txt 'S0-slow, grade ideal: every run was skipped'

expectExit $kUsage suite --out o --scenario S99
expectSentence S99 --list
# Clips whose recordings are not there are skipped by name.
expectExit 0 suite --list --recordings none
expectText out.txt 'R1-hand is skipped: ' none/hand2_desk 'Recording ball9_arena is not measured' csrt
expectExit $kUsage suite --out o --grade real --recordings none --scenario R1-hand
expectText err.txt 'R1-hand is skipped: ' --recordings
expectExit 0 suite --scenario S0-slow,R1-hand --grade both,real --first-seed 1 --seeds 1 --method triangulation \
  --recordings none --out clips
[[ $(wc -l <clips/runs.csv) == 3 ]] || fail "S0-slow in two grades expected: $(cat clips/runs.csv)"
expectText err.txt 'R1-hand is skipped: '
expectText clips/report.html 'R1-hand is skipped: '
expectExit $kUsage suite --out o --method magic
expectSentence magic camshift
expectExit $kUsage suite --out o --grade bright
expectExit $kUsage suite --out o --seeds 0
expectExit $kUsage suite
printf 'some,thing\n' >both/runs.csv
expectExit $kBadInput suite "${few[@]}" --out both
expectSentence runs.csv
: >file
expectExit $kOutput suite "${few[@]}" --out file/o
expectSentence file/o
