# SPDX-License-Identifier: GPL-3.0-or-later
# The best place for one more camera, without a window.
. "$(dirname "$0")/common.sh"

expectExit 0 plan demo --volume -1 -1 0 1 1 1 --out rig.toml
expectText out.txt "cameras                 2" "best new position" "% of the volume"
expectText rig.toml 'camera 3'
# The new camera is on a wall or on the ceiling, and sees more: the second share is the larger one.
mapfile -t shares < <(grep -o '[0-9.]* % of the volume' out.txt | cut -d' ' -f1)
[[ ${#shares[@]} == 2 ]] || fail "$(cat out.txt)"
awk -v a="${shares[0]}" -v b="${shares[1]}" 'BEGIN { exit !(b >= a && b <= 100) }' || fail "$(cat out.txt)"
expectText out.txt "% of the volume, ${shares[0]} % before"
cp out.txt first.txt
expectExit 0 plan demo --volume -1 -1 0 1 1 1
cmp out.txt first.txt || fail "the same input gave another place"

expectExit $kUsage plan demo --volume 0 0 0 1 1 0
expectSentence --volume
expectExit $kUsage plan demo --volume 1 2 3
expectExit $kBadInput plan nowhere.toml
expectSentence nowhere.toml
