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

# A page of the manual; only script/manual asks for it, so that it is not listed.
expectExit 0 --help
! grep -q reference out.txt || fail "a command that is not for users is listed: $(cat out.txt)"
expectExit 0 reference methods
expectText out.txt "### barrera" '| `motion_sigma` |'
expectExit $kUsage reference poetry
expectSentence PAGE methods poetry
