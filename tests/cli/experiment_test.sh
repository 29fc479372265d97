# SPDX-License-Identifier: GPL-3.0-or-later
# The papers' experiments: names, reports, what is refused.
. "$(dirname "$0")/common.sh"

# A folder that cannot be made is said before anything is computed: in no time, and without progress.
: >file
for name in barrera-fig3 barrera-fig4 barrera-fig5 drift starts dynamics-fig6 dynamics-fig7 dynamics-fig8 mohedano-fig1 \
  sugandi-rmse people-crossing people-enter-leave apart; do
  expectExit $kOutput experiment $name --out file/o
  expectSentence file/o "cannot be written"
  mkdir -p taken/report.html taken/sugandi-rmse.html
  expectExit $kOutput experiment $name --out taken
  expectSentence taken/ "cannot be written"
done

# Short names of the people's scenarios.
expectExit 0 experiment apart --seed 1 --seeds 1 --clothes similar --method people --out apart
expectText apart/report.html "People: apart" similar-people-1.jpg "so far yes" "silhouette recall" "TUNING seeds"
expectText apart/people.csv height_m,found,silhouette_recall
expectText out.txt "1 to 1, 1 in all: TUNING"
expectText apart/runs.csv "apart,ideal,similar,people,1,"
expectExit 0 experiment apart --seed 1 --seeds 1 --clothes similar --method people --grade room --out room
expectText room/report.html "Grade room:"
expectText room/runs.csv "apart,room,similar,people,1,"
expectExit $kUsage experiment apart --grade dim
[[ -s apart/similar-people-1.jpg && -s apart/runs.csv ]] || fail "files are missing"
for name in crossing meet-and-turn side-by-side enter-leave heights sitting carrying crowd \
  two-cameras contact furniture-moved room-clothes patterned-clothes; do
  expectExit $kUsage experiment $name --set foo=1
  expectSentence foo "unknown key"
done
expectExit $kUsage experiment people-apart --method mohedano-ms --set body_points=200
expectSentence body_points
expectExit $kUsage experiment people-apart --set particles=0.5
expectSentence particles
expectExit $kUsage experiment people-apart --record office --set particles=50
expectExit $kUsage experiment people-apart --record office --grade room
[[ ! -e office ]] || fail "a refused command left its folder behind"

# Every figure has its numbers beside it.
expectExit 0 experiment drift --runs 1 --out drift
expectText drift/drift.csv iteration,moved_m
expectText drift/report.html "reporting seeds"
expectExit 0 experiment drift --runs 1 --seed 1 --out drift
expectText drift/report.html "TUNING seeds"
expectExit 0 experiment barrera-fig5 --out cone
expectText cone/cone.csv step_m
expectExit 0 experiment barrera-fig4 --out above
[[ $(wc -l <above/particles.csv) == 801 ]] || fail "not four instants of 200 particles"
expectExit 0 experiment dynamics-fig8 --out clouds
[[ $(wc -l <clouds/clouds.csv) == 2401 ]] || fail "not twice six instants of 200 particles"

# The numbers of the table in docs/fidelity.md.
expectExit 0 experiment convergence --runs 1 --out convergence
expectText out.txt "over the first 5" "over the first 40" "reporting seeds"
expectText convergence/convergence.csv ,converged,within,
[[ $(wc -l <convergence/convergence.csv) == 9 ]] || fail "not a row for each of eight cases"
[[ $(wc -l <convergence/drift.csv) == 3 ]] || fail "not a row for 5 and for 40 iterations"
expectExit $kOutput experiment convergence --runs 1 --out file/o
expectSentence file/o "cannot be written"

# The state of a method: eight digits, the same each time.
expectExit 0 experiment fingerprint --method triangulation
[[ $(sed -n 2p out.txt) =~ ^triangulation,[0-9a-f]{8}$ ]] || fail "no fingerprint: $(cat out.txt)"
cp out.txt fingerprint.csv
expectExit 0 experiment fingerprint --method triangulation
cmp out.txt fingerprint.csv || fail "the fingerprint is another one each time"
expectExit $kUsage experiment fingerprint --method magic

expectExit 0 experiment seeds
expectText out.txt block,first,last tuning,0, reporting,1006001,1007000, reserve,
