# SPDX-License-Identifier: GPL-3.0-or-later
# Calibration files of other tools, from the command line alone.
. "$(dirname "$0")/common.sh"
golden="$(dirname "$0")/../calibration/golden"

# Every format that is written, from Caliscope's three cameras and back.
for to in dewpoint.toml anipose.toml pose2sim.toml caliscope.toml kalibr.yaml mc-calib.yml \
  qualisys.qca.txt; do
  expectExit 0 calibration convert "$golden/camera_array.toml" "out/$to" --to "${to%%.*}"
  expectText out.txt "Read as Caliscope" "largest reprojection difference" "out/$to"
done
for to in opencv ros mrcal; do
  expectExit 0 calibration convert "$golden/camera_array.toml" "out/$to" --to "$to"
  expectText out.txt "cam_2"
done
[[ -s out/ros/static_transforms.yaml && -s out/mrcal/cam_1.cameramodel ]] || fail "$(find out)"

# The lens that Pose2Sim cannot hold is refitted, and that is reported.
expectExit 0 calibration convert "$golden/camera_array.toml" out/four.toml --to pose2sim
expectText out.txt "refitted" "least squares"
expectExit 0 calibration convert "$golden/camchain.yaml" out/same.toml
! grep -q "refitted" out.txt || fail "radtan is held as it is"

# What a file leaves open is asked for, with the likely answer.
expectExit $kBadInput calibration convert "$golden/anipose_mm.toml" out/mm.toml
expectSentence anipose_mm.toml unit "probably mm"
expectExit 0 calibration convert "$golden/anipose_mm.toml" out/mm.toml --unit mm
expectExit $kBadInput calibration convert "$golden/intrinsics.yml" out/pair.toml --unit 0.025
expectSentence image_width --size
expectExit 0 calibration convert "$golden/intrinsics.yml" out/pair.toml --unit 0.025 --size 1280x720

# Mixed-up requests.
expectExit $kBadInput calibration convert "$golden/camchain.yaml" out/x.toml --from mrcal
expectSentence camchain.yaml Kalibr
expectExit $kBadInput calibration convert "$golden/camchain.yaml" out/x.toml --to nothing
expectExit $kOutput calibration convert "$golden/camchain.yaml" out/same.toml
expectSentence out/same.toml --force
expectExit $kUsage calibration convert "$golden/camchain.yaml" out/x.toml --unit parsec

# A project takes any of them that leaves nothing open.
expectExit 0 simulate demo --frames 3 --out made
expectExit 0 calibration convert made/calibration.toml made/ros --to ros
expectExit 0 new ros.toml --camera "camera 1=made/camera-1.mkv" --camera "camera 2=made/camera-2.mkv" \
  --calibration made/ros
expectText ros.toml '[camera.calibration]'
expectExit 0 calibration convert made/calibration.toml made/any.toml --to anipose
expectExit $kBadInput new other.toml --camera made/camera-1.mkv --calibration made/any.toml
expectSentence any.toml unit

# A camera that is a copy of the other is noted, not refused.
awk '/^rotation/ { if (!r) r = $0; $0 = r } /^translation/ { if (!t) t = $0; $0 = t } { print }' \
  made/calibration.toml >copied.toml
expectExit 0 calibration convert copied.toml out/copied.toml
expectText err.txt 'camera 1 and camera 2 have the same pose'
expectExit 0 new copied_project.toml --camera "camera 1=made/camera-1.mkv" \
  --camera "camera 2=made/camera-2.mkv" --calibration copied.toml
expectText err.txt 'camera 1 and camera 2 have the same pose'
