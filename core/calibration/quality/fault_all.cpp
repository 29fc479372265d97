// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/quality/fault_all.h"

#include <vector>

namespace dewpoint::calibration {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
/// What a fault of all cameras must gain in log-likelihood.
constexpr double kLeastGainOfAll = 25.0;

} // namespace

std::optional<DetectedFault> findCommonFault(const FaultSearchInput& input,
                                             const ImagePoints& imagePoints, const PointFit& fit) {
  const std::vector<bool> everyone(imagePoints.pointsPerCamera.size(), true);
  CameraRig initialRig;
  for (const BundleCamera& camera : input.problem.cameras) {
    initialRig.push_back(camera.camera);
  }
  const auto free =
      input.isUnsynchronized
          ? std::nullopt
          : estimateStructureAndPoses(initialRig, imagePoints, everyone, input.initialSigma, true);
  if (!free) {
    return std::nullopt;
  }
  const auto total = [&](const PointFit& one) {
    return static_cast<double>(fit.squaredResiduals.size()) *
           meanCost(one.squaredResiduals, free->sigmaPx);
  };
  std::optional<DetectedFault> best;
  for (const double shift : {-0.5, 0.5}) {
    ImagePoints shifted = imagePoints;
    for (auto& camera : shifted.pointsPerCamera) {
      for (ImagePoint& imagePoint : camera) {
        imagePoint.pixel.array() += shift;
      }
    }
    const auto now = estimateStructureAndPoses(initialRig, shifted, everyone, input.initialSigma);
    if (!now) {
      continue;
    }
    // As good as any other principal points, which have two numbers per camera to choose.
    const double worseThanFree = total(*now) - total(*free);
    const double gain = total(fit) - total(*now);
    if (gain > kLeastGainOfAll &&
        worseThanFree < 2.0 * static_cast<double>(initialRig.size()) + 8.0 &&
        (!best || gain > best->logLikelihoodGain)) {
      best = DetectedFault{CalibrationFault::HalfPixel, {}, shift, gain};
    }
  }
  return best;
}

} // namespace dewpoint::calibration
