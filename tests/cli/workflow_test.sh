# SPDX-License-Identifier: GPL-3.0-or-later
# The workflow of packaging/workflow on this machine: two cores give the same bytes as single runs; a job that
# fails is named, and done when the same command comes again; the accuracy suite; GNU parallel.
workflow=$(cd "$(dirname "$0")/../../packaging/workflow" && pwd)
. "$(dirname "$0")/common.sh"

python3 -B "$workflow/self_test.py" || fail "the table of jobs"
command -v snakemake >/dev/null || {
  echo 'SKIPPED: snakemake is not installed (script/setup figures)'
  exit 77
}
export XDG_CACHE_HOME=$PWD/cache PYTHONDONTWRITEBYTECODE=1

cat >table.csv <<'END'
recording,project,truth,methods,seeds,settings,frames
smooth ball,smooth,simulated,,1 2,,0:6
jumps,jump,simulated,barrera,,particles=50 motion_sigma=0.02,0:6
no truth,fast,,dewpoint,,,0:4
END
cat >lab.yaml <<END
table: table.csv
program: $cli
methods: [dewpoint, barrera]
seeds: [1]
suite: {scenarios: [S0-slow], grades: [ideal], methods: [triangulation], first_seed: 1, seeds: 2, seeds_per_shard: 1}
END
# flow FOLDER ARGUMENTS...
flow() {
  local folder=$1
  shift
  snakemake "$@" --snakefile "$workflow/Snakefile" --configfile lab.yaml --directory "$folder" --cores 2 \
    --scheduler greedy --quiet all >flow.txt 2>&1 </dev/null
}
flow made || fail "the workflow: $(cat flow.txt)"
expectText made/gathered/report.md '6 runs of 3 recordings; 0 missing, 0 unfinished'
[[ $(wc -l <made/gathered/results.csv) == 7 ]] || fail "six rows expected: $(cat made/gathered/results.csv)"
[[ $(wc -l <made/jobs.txt) == 6 ]] || fail "six jobs expected: $(cat made/jobs.txt)"

# One after the other, without the workflow: the same bytes.
mkdir single
cd single
single() {
  local folder=$1 truth=$2
  shift 2
  expectExit 0 track "$@" --out "$folder"
  [[ $truth == no ]] || expectExit 0 evaluate "$folder" "$folder/truth.csv" --save
}
for seed in 2 1; do
  single "runs/smooth-ball/barrera/seed-$seed-frames-0-6" yes smooth --label 'smooth ball' --method barrera \
    --seed $seed --frames 0:6
  single "runs/smooth-ball/dewpoint/seed-$seed-frames-0-6" yes smooth --label 'smooth ball' --method dewpoint \
    --seed $seed --frames 0:6
done
single runs/no-truth/dewpoint/seed-1-frames-0-4 no fast --label 'no truth' --method dewpoint --seed 1 --frames 0:4
single runs/jumps/barrera-particles=50-motion_sigma=0.02/seed-1-frames-0-6 yes jump --label jumps --method barrera \
  --seed 1 --frames 0:6 --set particles=50 --set motion_sigma=0.02
expectExit 0 gather runs/*/*/* --out gathered
cd ..
for file in gathered/results.csv gathered/report.md $(cd single && find runs -name '*.csv' -o -name evaluation.json); do
  cmp "single/$file" "made/$file" || fail "$file is not the same"
done

# One is lost: only it is made again.
rm -r made/runs/no-truth
touch mark
flow made || fail "the workflow again: $(cat flow.txt)"
[[ $(find made/runs -name done.json -newer mark) == made/runs/no-truth/dewpoint/seed-1-frames-0-4/done.json ]] ||
  fail "made again: $(find made/runs -name done.json -newer mark)"
cmp single/gathered/results.csv made/gathered/results.csv || fail "the table has changed"

# One fails: the others are gathered, it is named, and nothing half done counts.
sed -i 's/^no truth,fast/no truth,not-there.toml/; s/^jumps/hops/' table.csv
! flow made --keep-going || fail "a project that is not there: $(cat flow.txt)"
expectText made/gathered/report.md '5 runs of 2 recordings; 0 missing, 1 unfinished' no-truth
expectText made/logs/no-truth/*/*.log not-there.toml

flow made suite || fail "the suite: $(cat flow.txt)"
expectExit 0 suite --scenario S0-slow --grade ideal --method triangulation --first-seed 1 --seeds 2 --out suite
# Everything but the measured time, which is the last but one column.
rows() { sed 's/,[^,]*,\([^,]*\)$/,\1/' "$1"; }
cmp <(rows suite/runs.csv) <(rows made/suite/runs.csv) || fail "the suite gives something else"

sed -i 's/^recording,project/recording,movie/' table.csv
! flow made || fail "a wrong table"
expectText flow.txt 'there is no movie'

# GNU parallel, as the documentation says it.
command -v parallel >/dev/null || exit 0
export HOME=$PWD
mkdir recordings
for name in smooth still; do
  expectExit 0 simulate $name --frames 3 --images --out "recordings/$name"
done
parallel --will-cite --jobs 2 --joblog jobs.log "$cli" track {} --label {//} --out runs/{//} \
  ::: recordings/*/project.toml >parallel.txt 2>&1 || fail "parallel: $(cat parallel.txt)"
expectExit 0 gather runs/recordings/* --out gathered
[[ $(wc -l <gathered/results.csv) == 3 ]] || fail "two rows expected: $(cat gathered/results.csv)"
