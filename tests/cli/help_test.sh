# SPDX-License-Identifier: GPL-3.0-or-later
. "$(dirname "$0")/common.sh"

expectExit 0 --help
expectText out.txt track track-box evaluate simulate
expectExit 0 track --help
expectText out.txt --out --method --seed --threads --frames --particles --set
expectExit 0 evaluate --help
expectText out.txt --json
expectExit 0 simulate --help
expectText out.txt --out --seed
expectExit 0 --version
grep -qE '[0-9]+\.[0-9]+\.[0-9]+' out.txt || fail "no version in: $(cat out.txt)"
