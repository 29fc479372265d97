# SPDX-License-Identifier: GPL-3.0-or-later
# A tracked run goes into every format; wrong wishes are one sentence.
. "$(dirname "$0")/common.sh"

expectExit 0 track demo --out run --frames 0:40
expectText run/trajectory.csv ',ess,cameras,valid,seen_x_m,'

declare -A suffix=([csv]=csv [csv-wide]=csv [tum]=tum [trc]=trc [c3d]=c3d [npz]=npz [vtp]=vtp [pvd]=pvd
  [jsonl]=jsonl)
for format in "${!suffix[@]}"; do
  file=out-$format.${suffix[$format]}
  expectExit 0 export run --format "$format" --out "$file"
  [[ -s $file ]] || fail "$file is empty"
  expectText out.txt '40 rows of 1 target'
  expectExit 0 export run --format "$format" --preview
  expectText out.txt 'right-handed' '40 rows at 30 per second'
done
[[ $(rowCount out-csv.csv) == 40 ]] || fail "$(rowCount out-csv.csv) rows"
expectText out-csv.csv '# method: dewpoint' '# exported: 20' 'estimates: live' 'valid,filled,best_x_m'
expectText out-jsonl.jsonl '"best":['
[[ $(find out-pvd-frames -name '*.vtp' | wc -l) == 40 ]] || fail 'not one file per row'

expectExit 0 export run/trajectory.csv --smooth --from 10f --to 0.9s --rate 60 --unit mm --axes y-up \
  --gaps fill --no-header --targets 'pink ball' --out part.csv
[[ $(head -c 21 part.csv) == time_s,frame,target,x ]] || fail "$(head -1 part.csv)"
[[ $(rowCount part.csv) == 35 ]] || fail "$(rowCount part.csv) rows, not those from 0.333 s to 0.9 s at 60 Hz"
# The smoothed file can be judged like any other.
expectExit 0 export run --smooth --out smooth.csv
expectExit 0 evaluate smooth.csv run/truth.csv
# So can one without notes.
expectExit 0 export run --no-header --out plain.csv
[[ $(head -c 21 plain.csv) == time_s,frame,target,x ]] || fail "$(head -1 plain.csv)"
expectExit 0 evaluate plain.csv run/truth.csv
expectExit 0 evaluate run run/truth.csv

# The figure of what is chosen, alone or beside an export.
expectExit 0 export run --figure run.svg
expectText run.svg '<svg ' 'time (s)' 'from above' 'pink ball' 'demo'
expectExit 0 export run --smooth --unit mm --figure smooth.svg --out figure.csv
expectText smooth.svg 'x (mm)'
[[ -s figure.csv ]] || fail 'no export beside the figure'
expectExit $kUsage export run --figure run.png
expectSentence --figure svg

expectExit 0 export run --out by-ending.npz
[[ $(head -c 2 by-ending.npz) == PK ]] || fail 'the ending does not choose the format'
expectExit $kUsage export run --format csv --out x.c3d
expectSentence c3d csv
expectExit $kUsage export run --out x.doc
expectSentence doc format
expectExit $kUsage export run --format doc --out x
expectExit $kUsage export run
expectExit $kUsage export run --from soon --out x
expectSentence soon seconds
expectExit $kBadInput export nowhere --out x.csv
expectSentence nowhere
expectExit $kBadInput export run --targets dog --out x.csv
expectSentence dog ball
expectExit $kBadInput export run --from 99 --out x.csv
expectSentence run span
sed '0,/^0.1,/s/^0.1,3,pink ball,[^,]*/0.1,3,pink ball,nan/' run/trajectory.csv >nan.csv
expectExit $kBadInput export nan.csv --out x.csv
expectSentence nan.csv 'frame 3' finite
expectExit $kOutput export run --out no/folder/x.csv
expectSentence no/folder/x.csv
[[ ! -e x.csv ]] || fail 'something was written'
