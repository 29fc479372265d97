# SPDX-License-Identifier: GPL-3.0-or-later
# What this computer can do, one line each.
. "$(dirname "$0")/common.sh"

expectExit 0 self-test
for subject in versions computer disk "codec FFV1" "codec PNG folder" tracking; do
  grep -qE "^(ok|note) +$subject: " out.txt || fail "$subject: $(cat out.txt)"
done
expectText out.txt "codec FFV1: written and read back, the same bytes" "RMSE"

mkdir -p scratch
export TMPDIR=$PWD/scratch
expectExit 0 self-test --json
python3 -c 'import json; assert json.load(open("out.txt"))["level"] != "problem"' || fail "$(cat out.txt)"
[[ -z $(ls scratch) ]] || fail "something was left: $(ls scratch)"
