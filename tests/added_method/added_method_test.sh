# SPDX-License-Identifier: GPL-3.0-or-later
# Method `parked` of this folder, in a command line that knows it: from a project file, by option, and
# as docs/architecture.md shows it. $3 is the product's own command line, $4 the source tree.
product=$3
sources=$4
. "$(dirname "$0")/../cli/common.sh"

expectExit 0 simulate still --frames 4 --out good
sed -e 's/^method *=.*/method = "parked"/' -e '/^\[parameters\]/,/^$/{/^\[parameters\]/!d;}' \
  good/project.toml >good/parked.toml
expectExit 0 track good/parked.toml --out run --set parked_x=0.75
expectText run/trajectory.csv 'method: parked' 'parked_x: 0.75 m'
[[ $(rowCount run/trajectory.csv) == 4 ]] || fail "$(rowCount run/trajectory.csv) rows, not 4"
# Column by name: every sample lies where the parameters say.
awk -F, '!/^#/ && !column { for (i = 1; i <= NF; ++i) name[i] = $i; column = 1; next }
         !/^#/ { for (i = 1; i <= NF; ++i) value[name[i]] = $i
                 if (value["x_m"] != 0.75 || value["y_m"] != 0.5 || value["valid"] != 1) exit 1 }' \
  run/trajectory.csv || fail "not where it is parked: $(tail -2 run/trajectory.csv)"

expectExit 0 track demo --method parked --frames 0:3 --out other
expectText other/trajectory.csv 'method: parked'
expectExit $kUsage track demo --method parked --set parked_z=1 --out other
expectSentence parked_z parked_x

# The product itself does not know it.
cli=$product
expectExit $kBadInput track good/parked.toml --out run
expectSentence method parked

# What the page shows is what is built here: each fenced block under the name of its file.
for file in parked_tracker.h parked_tracker.cpp row.txt; do
  awk -v name="\`$file\`" 'index($0, name) { wanted = 1 }
       wanted && /^```/ { if (inside) exit; inside = 1; next } inside' \
    "$sources/docs/architecture.md" >"$file.shown"
  grep -vE '^// SPDX' "$sources/tests/added_method/$file" | cmp - "$file.shown" ||
    fail "docs/architecture.md shows another $file"
done
