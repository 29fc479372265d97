# SPDX-License-Identifier: GPL-3.0-or-later
# Every bad input: one sentence that names file and field, and the exit code for bad input.
. "$(dirname "$0")/common.sh"

expectExit $kBadInput track missing.toml --out o
expectSentence missing.toml
expectExit $kBadInput evaluate missing.csv missing.csv
expectSentence missing.csv

expectExit 0 simulate still --frames 4 --out good

# broken NAME SED-SCRIPT WORDS...: a copy of a good project, changed, is refused with these words.
broken() {
  local name=$1 change=$2
  shift 2
  sed "$change" good/project.toml >"good/$name.toml"
  ! cmp -s good/project.toml "good/$name.toml" || fail "'$change' changes nothing"
  expectExit $kBadInput track "good/$name.toml" --out o
  expectSentence "$@"
}
broken syntax '1s/^/[[[/'
broken unknown_key '1s/^/flavor = 1\n/' flavor
broken wrong_type 's/^seed *=.*/seed = "one"/' seed
broken newer 's/^format *=.*/format = 99/' format newer
broken method 's/^method *=.*/method = "magic"/' method barrera
broken range 's/^particles *=.*/particles = 3/' particles
broken no_target '/^\[\[target/,/^$/d' target
broken no_camera '/^\[\[camera/,$d' camera
broken empty_color 's/^saturation *=.*/saturation = [0.8, 0.2]/' saturation
broken nan '0,/^translation/s/^translation *=.*/translation = [nan, 0.0, 0.0]/' translation
broken zero_focal '0,/^matrix/s/^matrix *=.*/matrix = [[0.0, 0.0, 9.0], [0.0, 0.0, 9.0], [0.0, 0.0, 1.0]]/' matrix focal
broken no_rotation '0,/^rotation/s/^rotation *=.*/rotation = [[2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]/' rotation
broken size '0,/^size/s/^size *=.*/size = [64, 48]/'
broken no_video '0,/^video/s/^video *=.*/video = "nowhere.mkv"/' nowhere.mkv

printf 'name = "x"\n' >none.toml
expectExit $kBadInput track none.toml --out o
expectSentence none.toml

printf 'frame,x_m\n1,2\n' >columns.csv
expectExit $kBadInput evaluate columns.csv good/truth.csv
expectSentence columns.csv
printf 'frame,x_m,y_m,z_m\n1,two,3,4\n' >number.csv
expectExit $kBadInput evaluate number.csv good/truth.csv
expectSentence number.csv x_m

# An output folder that cannot be made: its parent is a file.
: >file
expectExit $kOutput track demo --out file/o
expectSentence file/o
expectExit $kOutput simulate demo --out file/o
expectSentence file/o
