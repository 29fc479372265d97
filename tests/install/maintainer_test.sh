# SPDX-License-Identifier: GPL-3.0-or-later
# Name and address in the packages: of whoever makes them, else one that is recognizably none.
set -euo pipefail
cmake=$1
script=$(mktemp)
trap 'rm -f "$script"' EXIT
printf 'include(%s/packaging/maintainer.cmake)\nmessage("${maintainer}")\n' "$2" >"$script"
unset DEBEMAIL DEBFULLNAME

# expect TEXT COMMAND...: what the command says contains the text.
expect() {
  local said
  said=$("${@:2}" 2>&1) || true
  [[ $said == *"$1"* ]] || { echo "expected '$1', found: $said" >&2 && exit 1; }
}

expect 'The Dewpoint authors <no-address@dewpoint.invalid>' "$cmake" -P "$script"
expect 'Ada Lab <ada@lab.org>' env DEBEMAIL=ada@lab.org DEBFULLNAME='Ada Lab' "$cmake" -P "$script"
expect 'Ada Lab <ada@lab.org>' env DEBEMAIL='Ada Lab <ada@lab.org>' "$cmake" -P "$script"
expect 'Ben Lab <ben@lab.org>' env DEBEMAIL='Ada Lab <ada@lab.org>' "$cmake" -DDEWPOINT_MAINTAINER='Ben Lab <ben@lab.org>' -P "$script"
expect "maintainer of the packages is 'ada@lab.org'" env DEBEMAIL=ada@lab.org "$cmake" -P "$script"
