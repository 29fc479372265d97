# SPDX-License-Identifier: GPL-3.0-or-later
# A program outside of this tree finds the package, compiles against it, and says what is true.
. "$(dirname "$0")/common.sh"

cmake -S "$here/consumer" -B build -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_PREFIX_PATH="$prefix" >configure.txt 2>&1 ||
  fail "$(cat configure.txt)"
cmake --build build >build.txt 2>&1 || fail "$(cat build.txt)"
build/consumer >said.txt

# The same scene, written by the installed command line: a folder for each camera, and where the ball is.
"$prefix/bin/dewpoint-cli" simulate still --out still --frames 2 --images >/dev/null
cameras=$(find still -mindepth 1 -maxdepth 1 -type d | wc -l)
grep -qx "still: $cameras cameras" said.txt || fail "$cameras cameras, not: $(cat said.txt)"
position=$(grep -v '^[#a-z]' still/truth.csv | head -n 1 | cut -d , -f 4-6)
grep -qxF "ball at $position" said.txt || fail "the ball is at $position, not: $(cat said.txt)"
