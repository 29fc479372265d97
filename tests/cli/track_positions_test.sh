# SPDX-License-Identifier: GPL-3.0-or-later
. "$(dirname "$0")/common.sh"

# Frames alone: times come from a rate, and the result can be exported.
printf 'frame,x_m,y_m,z_m\n0,0.1,0.2,0.3\n1,0.1,0.2,0.3\n3,0.1,,\n' >frames.csv
expectExit 0 track-positions frames.csv --out tracked.csv
expectText out.txt "3 rows" "30 per second"
expectText tracked.csv "# times: frames at 30 per second" start_half_x
! grep -q -e nan -e '^# start_[xyz]' tracked.csv || fail "$(cat tracked.csv)"
grep -q '^0.1,3,' tracked.csv || fail "frame 3 at 30 per second is 0.1 s: $(cat tracked.csv)"
expectExit 0 export tracked.csv --format tum --out tracked.tum
expectExit 0 track-positions frames.csv --out fast.csv --rate 300
grep -q '^0.01,3,' fast.csv || fail "frame 3 at 300 per second is 0.01 s: $(cat fast.csv)"
expectExit $kUsage track-positions frames.csv --out no.csv --rate 0

# Times alone: the instants are numbered.
printf 'time_s,x_m,y_m,z_m\n0.5,0.1,0.2,0.3\n0.75,0.1,0.2,0.3\n' >times.csv
expectExit 0 track-positions times.csv --out tracked.csv
grep -q '^0.75,1,' tracked.csv || fail "the second instant is frame 1: $(cat tracked.csv)"
! grep -q '# times' tracked.csv || fail "these times were measured"

# Some have a time, some not.
printf 'frame,time_s,x_m,y_m,z_m\n0,0.5,0.1,0.2,0.3\n1,,0.1,0.2,0.3\n' >mixed.csv
expectExit $kBadInput track-positions mixed.csv --out no.csv
expectSentence mixed.csv time_s

# Every target starts at its own first position.
expectExit $kUsage track-positions times.csv --out no.csv --set start_x=1
expectSentence start_x "first position"
[[ ! -e no.csv ]] || fail "a refused command wrote"

# Millimeters are no meters: nothing may start so far away.
printf 'frame,x_m,y_m,z_m\n0,1000,20,30\n1,1010,20,30\n' >far.csv
expectExit $kBadInput track-positions far.csv --out no.csv
expectSentence far.csv x_m 1000 meters
