# SPDX-License-Identifier: GPL-3.0-or-later
# From a recording of a moving ball to a calibration, and what is said when that cannot be.
. "$(dirname "$0")/common.sh"

expectExit 0 calibrate --help
expectText out.txt wand
expectExit 0 calibrate wand --help
expectText out.txt --target --stick --length --offsets --focal --floor --drop --out --apply --report

# The demo's cameras are where its images were made from: they stay there, to a few centimeters (two
# cameras and a path of 0.2 m say little more).
expectExit 0 calibrate wand demo --frames 60:200 --out found.toml
expectText out.txt 'camera 1' 'camera 2' 'Median reprojection error' 'Size:' 'World:'
expectText out.txt 'note: ' # five seconds in a small volume: what is missing is named
expectText found.toml '[cam_0]' '[cam_1]' 'name = "camera 1"'
cp found.toml first.toml
expectExit 0 calibrate wand demo --frames 60:200 --out found.toml --report page.html
expectText page.html 'In this volume' 'camera 2' 'aria-label="residuals"' 'from above'
cmp -s first.toml found.toml || fail "twice the same, but two results"

expectExit 0 simulate demo --frames 240 --out made
cp made/project.toml kept.toml
expectExit 0 calibrate wand made/project.toml --diameter --apply
expectText out.txt 'diameter'
! cmp -s kept.toml made/project.toml || fail "--apply left the project as it was"

# A camera that is said to be late by three images but is not: found, and kept.
awk '{ print } /camera-2/ && /video/ { print "late_by = 0.1" }' kept.toml >made/late.toml
expectExit 0 calibrate wand made/late.toml --frames 60: --offsets --apply
expectText out.txt 'delay ms'
awk '/^late_by/ { found = 1; if ($3 > 0.002 || $3 < -0.002) exit 1 } END { exit !found }' made/late.toml ||
  fail "the camera is not late, but $(grep late_by made/late.toml)"

# One sentence each.
expectExit $kBadInput calibrate wand demo --target "green ball"
expectSentence target "green ball"
expectExit $kUsage calibrate wand demo --stick "pink ball" "pink ball"
expectSentence --stick --length
# A stick's length is the size: nothing else can be.
expectExit $kUsage calibrate wand demo --stick a b --length 0.5 --distance 1 2 1.5
expectSentence --length --distance
expectExit $kUsage calibrate wand demo --diameter --stick a b --length 0.5
expectSentence --length --diameter
expectExit $kUsage calibrate wand demo --diameter --distance 1 2 0.5
expectSentence --distance --diameter
expectExit $kUsage calibrate wand demo --apply
expectSentence --apply
expectExit $kBadInput calibrate wand demo --frames 60:200 --floor 99
expectSentence floor 99.00
expectExit $kBadInput calibrate wand demo --frames :30 # the ball is at rest there
expectSentence converge
expectExit $kOutput calibrate wand demo --frames 60:200 --out nowhere/found.toml
expectSentence nowhere/found.toml
