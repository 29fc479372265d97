// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera_motion/agreement/rig_check.h"

#include "core/base/angle.h"
#include "core/calibration/formats/calibration_plausibility.h"
#include "core/geometry/rotation_vector.h"

#include <array>
#include <cmath>

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

// Two calibrations of one camera differ by more; copies differ by nothing but rounding.
constexpr double kSamePosition = 1e-4; ///< of the distance from the origin
constexpr double kSameAxes = 0.02 * base::kDegree;

bool haveSamePose(const Camera& a, const Camera& b) {
  const double apart = (a.center() - b.center()).norm();
  const double turn = angleBetween(a.cameraFromWorld.linear(), b.cameraFromWorld.linear());
  return apart <= kSamePosition * a.center().norm() && turn <= kSameAxes;
}

} // namespace

double unitFromRatio(double ratio) {
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
    found.push_back({.fault = CameraFault::Unit, .scale = isNarrow ? kCentimeter : kMillimeter});
  }
  for (std::size_t i = 0; i < rig.size(); ++i) {
    for (std::size_t j = i + 1; j < rig.size(); ++j) {
      if (haveSamePose(rig[i], rig[j])) {
        found.push_back({.fault = CameraFault::SamePose, .cameras = {i, j}});
      }
    }
  }
  return found;
}

} // namespace dewpoint::camera_motion
