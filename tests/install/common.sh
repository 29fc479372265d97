# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by every test here: "$prefix" is where Dewpoint was installed, the current folder is empty.
set -euo pipefail
prefix=$1
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
rm -rf "$2"
mkdir -p "$2"
cd "$2"

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

# The programs that are installed: a build without the window has only one.
programs() {
  local name
  for name in dewpoint-cli dewpoint; do
    [[ -x $prefix/bin/$name ]] && echo "$name"
  done
}
