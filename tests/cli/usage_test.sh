# SPDX-License-Identifier: GPL-3.0-or-later
. "$(dirname "$0")/common.sh"

expectExit $kUsage
expectExit $kUsage fly
expectExit $kUsage track
expectExit $kUsage track demo
expectExit $kUsage track demo --out o --sed 1
expectExit $kUsage track demo --out o --seed one
expectExit $kUsage track demo --out o --threads 0
expectExit $kUsage track demo --out o --frames 9
expectExit $kUsage track demo --out o --frames 9:3
expectExit $kUsage track demo --out o --method magic
expectText err.txt magic
expectExit $kUsage track demo --out o --set colour=3
expectSentence colour
expectExit $kUsage track demo --out o --method barrera --set motion_sigma=wide
expectSentence motion_sigma wide
expectExit $kUsage track demo --out o --set motion_sigma
expectSentence --set motion_sigma
expectExit $kUsage track demo --out o --particles 3
expectSentence particles 3
expectExit $kUsage simulate demo
expectExit $kUsage simulate demo --out o --look-alikes 99
expectExit $kUsage evaluate only_one.csv
[[ ! -e o ]] || fail "a refused command left its output folder behind"
