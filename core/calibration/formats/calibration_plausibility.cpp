// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/calibration_plausibility.h"

#include "core/base/angle.h"
#include "core/base/units.h"
#include "core/geometry/projector.h"
#include "core/geometry/ray.h"
#include "core/geometry/rotation_vector.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dewpoint::calibration {
namespace {

constexpr double kMinCameraSpread = 0.02; // meters: two cameras cannot stand closer
/// Units: a wider rig is likely in millimeters.
constexpr double kMaxSpreadInMeters = 50.0;
constexpr double kSameDirection = 0.94; // cosine of 20 degrees
/// Times, by which inverted poses miss a common point less.
constexpr double kClearlyBetter = 3.0;

constexpr double kOnePosition = 1e-4; ///< of the distance from the origin
constexpr double kOneRotation = 0.02 * base::kDegree;

bool haveOnePose(const Camera& a, const Camera& b) {
  const double apart = (a.center() - b.center()).norm();
  const double turn = angleBetween(a.cameraFromWorld.linear(), b.cameraFromWorld.linear());
  return apart <= kOnePosition * a.center().norm() && turn <= kOneRotation;
}

/// How well the cameras of a rig look at one place: the root mean square of the angles' tangents by
/// which their axes miss it. Infinite when there is no such place before all cameras, when one does
/// not have it in its image, or when all look into nearly the same direction.
double missDistance(const CameraRig& rig) {
  constexpr double kNowhere = std::numeric_limits<double>::infinity();
  std::vector<Ray> axes;
  double leastCosine = 1.0;
  for (const Camera& camera : rig) {
    axes.push_back({camera.center(), camera.opticalAxis()});
    leastCosine = std::min(leastCosine, axes.back().direction.dot(axes.front().direction));
  }
  const auto middle = nearestPoint(axes);
  if (!middle || leastCosine > kSameDirection) {
    return kNowhere;
  }
  double sum = 0.0;
  for (std::size_t k = 0; k < rig.size(); ++k) {
    const auto& in = rig[k].intrinsics;
    const auto pixel = Projector(rig[k]).project(*middle);
    if (!pixel || pixel->x() < 0.0 || pixel->y() < 0.0 || pixel->x() > in.width ||
        pixel->y() > in.height) {
      return kNowhere;
    }
    const double ratio = distanceToRay(axes[k], *middle) / (*middle - axes[k].origin).norm();
    sum += ratio * ratio;
  }
  return std::sqrt(sum / double(rig.size()));
}

Status checkPrincipalPoint(const CameraRig& rig, const std::string& file) {
  for (const Camera& camera : rig) {
    const auto& in = camera.intrinsics;
    if (in.centerX < 0.0 || in.centerY < 0.0 || in.centerX > in.width || in.centerY > in.height) {
      return failure(
          ErrorCode::Mismatch, file, camera.name + ".matrix",
          fmt::format("the principal point {:.1f}, {:.1f} lies outside the image of {} x "
                      "{} pixels; matrix and size are likely of different resolutions",
                      in.centerX, in.centerY, in.width, in.height));
    }
  }
  return {};
}

/// Also where the user says the unit: further away than this is not in any room, and our own files
/// do not take it.
Status checkReach(const CameraRig& rig, const std::string& file) {
  constexpr double kFarthest = 1e9; // meters
  for (const Camera& camera : rig) {
    if (!(camera.cameraFromWorld.translation().cwiseAbs().maxCoeff() <= kFarthest)) {
      return failure(ErrorCode::BadValue, file, camera.name + ".translation",
                     fmt::format("more than {} m", kFarthest));
    }
  }
  return {};
}

Status checkUnit(const CameraRig& rig, const std::string& file) {
  const double spread = cameraSpread(rig);
  if (spread > kMaxCameraSpread) {
    return failure(ErrorCode::BadValue, file, "translation",
                   fmt::format("the cameras would be {:.0f} m apart; the lengths are probably in "
                               "mm: convert with --unit mm",
                               spread));
  }
  // Cameras in one place are another mistake, which no unit explains.
  constexpr double kSamePlace = 1e-9; // meters: what rounding leaves
  if (rig.size() > 1 && spread < kMinCameraSpread && spread > kSamePlace) {
    return failure(ErrorCode::BadValue, file, "translation",
                   fmt::format("the cameras would be {:.2g} mm apart; the lengths are probably "
                               "already in meters: convert with --unit m",
                               inMillimeters(spread)));
  }
  return {};
}

Status checkPoseDirection(const CameraRig& rig, const std::string& file) {
  if (rig.size() >= 2 &&
      kClearlyBetter * missDistance(withInvertedPoses(rig)) < missDistance(rig)) {
    return failure(ErrorCode::BadValue, file, "rotation",
                   "the lines of sight diverge, but with inverted poses they meet: the poses are "
                   "probably world from camera; convert with --poses world-from-camera, or with "
                   "--poses camera-from-world if they are right");
  }
  return {};
}

} // namespace

double cameraSpread(const CameraRig& rig) {
  double spread = 0.0;
  if (rig.size() == 1) {
    return rig.front().center().norm();
  }
  for (std::size_t i = 0; i < rig.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      spread = std::max(spread, (rig[i].center() - rig[j].center()).norm());
    }
  }
  return spread;
}

const char* likelyUnit(double spread) {
  return spread > kMaxSpreadInMeters ? "mm" : "m";
}

std::vector<std::array<std::size_t, 2>> camerasWithSamePose(const CameraRig& rig) {
  std::vector<std::array<std::size_t, 2>> pairs;
  for (std::size_t i = 0; i < rig.size(); ++i) {
    for (std::size_t j = i + 1; j < rig.size(); ++j) {
      if (haveOnePose(rig[i], rig[j])) {
        pairs.push_back({i, j});
      }
    }
  }
  return pairs;
}

CameraRig withInvertedPoses(CameraRig rig) {
  for (Camera& camera : rig) {
    camera.cameraFromWorld = camera.cameraFromWorld.inverse();
  }
  return rig;
}

Status checkPlausibility(const ParsedCalibration& calibration, const CalibrationHints& hints,
                         const std::string& file) {
  const CameraRig& rig = calibration.rig;
  Status status = checkPrincipalPoint(rig, file);
  if (status && !hints.metersPerUnit && calibration.hasPoses) {
    status = checkUnit(rig, file);
  }
  if (status && calibration.hasPoses) {
    status = checkReach(rig, file);
  }
  if (status && !hints.posesAreWorldFromCamera && calibration.hasPoses) {
    status = checkPoseDirection(rig, file);
  }
  return status;
}

} // namespace dewpoint::calibration
