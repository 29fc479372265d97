// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/fuzzed_readers.h"

namespace dewpoint::tests {

std::span<const FuzzedReader> fuzzedReaders() {
  static constexpr FuzzedReader kReaders[] = {
      {"project", fuzzProject},
      {"scene", fuzzScene},
      {"trajectory", fuzzTrajectory},
      {"capture-times", fuzzCaptureTimes},
      {"camera-location", fuzzCameraLocation},
      {"board", fuzzBoard},
      {"calibration", fuzzCalibration},
      {"dewpoint", fuzzDewpoint},
      {"anipose", fuzzAnipose},
      {"pose2sim", fuzzPose2sim},
      {"caliscope", fuzzCaliscope},
      {"opencv", fuzzOpencv},
      {"opencv-stereo", fuzzOpencvStereo},
      {"ros", fuzzRos},
      {"kalibr", fuzzKalibr},
      {"mrcal", fuzzMrcal},
      {"mc-calib", fuzzMcCalib},
      {"qualisys", fuzzQualisys},
      {"multical", fuzzMultical},
      {"plain", fuzzPlain},
      {"opencv-extrinsics", fuzzOpencvExtrinsics},
      {"ros-transforms", fuzzRosTransforms},
      {"job-record", fuzzJobRecord},
      {"evaluation", fuzzEvaluation},
      {"live-frames", fuzzLiveFrames},
      {"take-notes", fuzzTakeNotes},
      {"clip-table", fuzzClipTable},
      {"band-cameras", fuzzBandCameras},
      {"box-truth", fuzzBoxTruth},
      {"suite-rows", fuzzSuiteRows},
      {"remote-lines", fuzzRemoteLines},
      {"web-request", fuzzWebRequest},
      {"web-socket", fuzzWebSocket},
  };
  return kReaders;
}

} // namespace dewpoint::tests
