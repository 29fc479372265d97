# SPDX-License-Identifier: GPL-3.0-or-later
# What script/figures is made of, and that it understands what this program says of itself.
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
. "$(dirname "$0")/common.sh"
# tomllib came with Python 3.11, which Debian 12 has.
python3 -c 'import tomllib' 2>/dev/null || exit 77

python3 "$root/script/tables/self_test.py" >out.txt 2>&1 || fail "$(cat out.txt)"

# The plan of the real program: every scenario and method, reporting seeds.
python3 - "$root/script/tables" "$cli" >out.txt 2>err.txt <<'END' || fail "$(cat err.txt)"
import sys
sys.path.insert(0, sys.argv[1])
sys.dont_write_bytecode = True
import pathlib
import plan
declared = plan.read_plan()
catalog = plan.read_catalog(sys.argv[2], declared)
costs = plan.Costs.read(pathlib.Path(sys.argv[1]) / "costs.csv")
print(plan.plan_table(plan.make_plan(declared, costs, catalog)))
print(*catalog.scenarios, *catalog.methods, *catalog.grades, *catalog.people, catalog.first_seed)
END
expectText out.txt S0-slow S4-desk-cloud S10-clean dewpoint-smoothed triangulation-kalman ideal room \
  people-crossing people-enter-leave 1006001 "of one core"
! grep "^figure .* does not have it" out.txt || fail "a figure of the plan has another name"
