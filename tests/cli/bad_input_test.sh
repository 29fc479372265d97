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
broken nan '0,/^translation/s/^translation *=.*/translation = [nan, 0.0, 0.0]/' translation finite
broken zero_focal '0,/^matrix/s/^matrix *=.*/matrix = [[0.0, 0.0, 9.0], [0.0, 0.0, 9.0], [0.0, 0.0, 1.0]]/' matrix focal
broken no_rotation '0,/^rotation/s/^rotation *=.*/rotation = [[2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]/' rotation
broken size '0,/^size/s/^size *=.*/size = [64, 48]/'
broken infinite '0,/^distortions/s/^distortions *=.*/distortions = [inf, 0.0, 0.0, 0.0, 0.0]/' distortions finite
broken mirror '0,/^rotation/s/^rotation *=.*/rotation = [[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]/' rotation mirrors
broken unknown_in_camera '0,/^video/s/^video/vidoe/' good/unknown_in_camera.toml 'camera 1.vidoe'
broken one_table 's/^\[\[target\]\]/[target]/' target
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

# A file where a folder is expected, and the other way round.
expectExit $kBadInput track good --out o
expectSentence good folder
mkdir -p taken/trajectory.csv
expectExit $kOutput track demo --out taken --frames 0:2
expectSentence taken/trajectory.csv

# Videos of another size, or of another length: the first is refused, the second is noted.
sed 's/camera-2.mkv/camera-1.mkv/' good/project.toml >good/same.toml
expectExit $kBadInput track good/same.toml --out o
expectSentence camera-1.mkv "'camera 2'" '320 x 240' '240 x 320'
expectExit 0 simulate still --frames 3 --out short
sed 's|camera-2.mkv|../short/camera-2.mkv|' good/project.toml >good/lengths.toml
expectExit 0 track good/lengths.toml --out lengths
expectSentence short/camera-2.mkv 'first 3'
[[ $(rowCount lengths/trajectory.csv) == 3 ]] || fail "$(rowCount lengths/trajectory.csv) rows, not 3"
