# SPDX-License-Identifier: GPL-3.0-or-later
# One seed gives the same bytes, whatever the number of threads; another seed gives others.
. "$(dirname "$0")/common.sh"

for threads in 1 2 4; do
  expectExit 0 track demo --out "t$threads" --frames 0:40 --seed 7 --particles 500 --threads $threads
done
cmp t1/trajectory.csv t2/trajectory.csv || fail "1 and 2 threads differ"
cmp t1/trajectory.csv t4/trajectory.csv || fail "1 and 4 threads differ"
expectExit 0 track demo --out other --frames 0:40 --seed 8 --particles 500 --threads 2
! cmp -s <(grep -v '^#' t1/trajectory.csv) <(grep -v '^#' other/trajectory.csv) ||
  fail "the seed has no effect"
