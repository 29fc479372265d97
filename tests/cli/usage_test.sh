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
expectExit $kUsage track demo --out o --volume 0,0,0,1,1
expectSentence --volume 0,0,0,1,1 meters
expectExit $kUsage track demo --out o --volume 0,0,0,1,0,1
expectSentence --volume 0,0,0,1,0,1
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
expectSentence --out "dewpoint-cli simulate --help"

# What is unknown is said by its name, and before what is missing; a slip of the finger is guessed.
expectExit $kUsage --frobnicate
expectSentence "unknown option --frobnicate"
expectExit $kUsage trakc demo
expectSentence "unknown command trakc" "did you mean track?"
expectExit $kUsage track --frobnicate demo
expectSentence "dewpoint-cli track: unknown option --frobnicate"
expectExit $kUsage track demo --out o --sed 1
expectSentence --sed "did you mean --seed?"
expectExit $kUsage track demo more --out o
expectSentence more

# Ranges and choices in plain words.
expectExit $kUsage new p.toml --camera a=a.mkv --rate -5
expectSentence "--rate must be 0.1 to 10000, not -5"
expectExit $kUsage export t.csv --out t.tum --rate -5
expectSentence "--rate must be a number above 0, not -5"
expectExit $kUsage export t.csv --out t.tum --gaps hide
expectSentence "--gaps must be one of leave, fill, not hide"
expectExit $kUsage track demo --out o --seed one
expectSentence --seed one

# Two cameras of one name.
expectExit $kUsage new p.toml --camera a=a.mkv --camera a=b.mkv
expectSentence --camera "'a'"
expectExit $kUsage simulate demo --out o --look-alikes 99
expectExit $kUsage evaluate only_one.csv
[[ ! -e o ]] || fail "a refused command left its output folder behind"
