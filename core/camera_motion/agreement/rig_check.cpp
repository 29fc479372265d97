// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera_motion/agreement/rig_check.h"

#include "core/calibration/formats/calibration_plausibility.h"

#include <array>

namespace dewpoint::camera_motion {
namespace {

constexpr double kMillimeter = 0.001; ///< meters
constexpr double kCentimeter = 0.01;
constexpr double kInch = 0.0254;
/// A rig that is narrower than this in millimeters (meters) is rather one in centimeters: judged by
/// what stands in rooms.
constexpr double kNarrowestInMillimeters = 0.3;
/// A ratio of lengths within this factor is that of a unit: balls seem smaller or larger by light
/// and color range by up to some 20 %, and units are a factor of 2.5 apart.
constexpr double kUnitTolerance = 1.3;

} // namespace

double lengthUnitFromRatio(double ratio) {
  for (const double unit : std::array{kMillimeter, kCentimeter, kInch}) {
    const double off = ratio * unit;
    if (off < kUnitTolerance && off > 1.0 / kUnitTolerance) {
      return unit;
    }
  }
  return 0.0;
}

std::vector<CameraDisagreement> checkRig(const CameraRig& rig) {
  std::vector<CameraDisagreement> found;
  const double spread = calibration::cameraSpread(rig);
  if (spread > calibration::kMaxCameraSpread) {
    const bool isNarrow = kMillimeter * spread < kNarrowestInMillimeters;
    found.push_back(
        {.fault = CameraFault::Unit, .metersPerUnit = isNarrow ? kCentimeter : kMillimeter});
  }
  for (const auto& [first, second] : calibration::camerasWithSamePose(rig)) {
    found.push_back({.fault = CameraFault::SamePose, .cameras = {first, second}});
  }
  return found;
}

} // namespace dewpoint::camera_motion
