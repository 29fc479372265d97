// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/quality/block_jackknife.h"

#include "core/base/statistics.h"
#include "core/geometry/projector.h"
#include "core/geometry/ray.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::calibration {
namespace {

/// More blocks would be shorter than the time over which errors are alike; with fewer, their
/// scatter is hardly known.
constexpr std::size_t kMostBlocks = 10;
constexpr std::size_t kLeastSolutions = 4;
constexpr double kNormal95 = 1.96;     ///< two-sided
constexpr double kNormalOne95 = 1.645; ///< one-sided

/// The states from `first` to before `end`, or all others, with their observations.
BundleProblem statesOf(const BundleProblem& problem, std::size_t first, std::size_t end,
                       bool inside) {
  BundleProblem part = problem;
  part.states.clear();
  part.observations.clear();
  constexpr std::size_t kNone = ~std::size_t{0};
  std::vector<std::size_t> renamed(problem.states.size(), kNone);
  for (std::size_t s = 0; s < problem.states.size(); ++s) {
    const bool isInside = s >= first && s < end;
    if (isInside == inside || problem.states[s].isFixed) {
      renamed[s] = part.states.size();
      part.states.push_back(problem.states[s]);
    }
  }
  for (BundleObservation seen : problem.observations) {
    seen.state = renamed[seen.state];
    if (seen.state != kNone) {
      part.observations.push_back(seen);
    }
  }
  part.isDraft = true;
  return part;
}

/// The left-out states with cameras that did not see them: only the target is free.
Result<BundleResult> withHeldCameras(BundleProblem part, const BundleResult& without) {
  for (std::size_t c = 0; c < part.cameras.size(); ++c) {
    BundleCamera known;
    known.camera = without.cameras[c];
    known.isPoseFixed = true;
    known.timeOffset = without.timeOffsets[c];
    part.cameras[c] = known;
  }
  return adjustBundle(part);
}

} // namespace

double BlockJackknife::deviationScale() const {
  const auto count = static_cast<double>(rigs.size());
  return rigs.size() < kLeastSolutions
             ? 0.0
             : std::sqrt((count - 1.0) / count) * studentQuantile95(count - 1.0) / kNormal95;
}

BlockJackknife
leaveOutBlocks(const BundleProblem& problem, const BundleResult& result,
               const InitialCamerasWithoutStates& estimateInitialCamerasWithoutStates) {
  BlockJackknife jackknife;
  const std::size_t count = problem.states.size();
  const std::size_t blocks = std::min(kMostBlocks, count);
  for (std::size_t block = 0; block < blocks; ++block) {
    const std::size_t first = block * count / blocks;
    const std::size_t end = (block + 1) * count / blocks;
    BundleProblem rest = statesOf(problem, first, end, false);
    const CameraRig before = estimateInitialCamerasWithoutStates
                                 ? estimateInitialCamerasWithoutStates(first, end)
                                 : CameraRig{};
    for (std::size_t c = 0; c < rest.cameras.size(); ++c) {
      Camera& camera = rest.cameras[c].camera;
      camera.cameraFromWorld = result.cameras[c].cameraFromWorld;
      if (c < before.size()) {
        camera.intrinsics = before[c].intrinsics;
        camera.distortion = before[c].distortion;
      }
    }
    const auto without = adjustBundle(rest);
    if (!without) {
      continue; // too little left: says nothing about the whole
    }
    jackknife.rigs.push_back(without->cameras);
    if (const auto held = withHeldCameras(statesOf(problem, first, end, true), *without)) {
      jackknife.squaredErrorSum +=
          held->rmsPx * held->rmsPx * static_cast<double>(held->usedObservationCount);
      jackknife.leftOutPointCount += held->usedObservationCount;
    }
  }
  return jackknife;
}

Eigen::MatrixXd positionChanges(const std::vector<Eigen::Vector3d>& positions, const CameraRig& rig,
                                const std::vector<CameraRig>& solutions) {
  Eigen::MatrixXd changes = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(3 * positions.size()),
                                                  static_cast<Eigen::Index>(solutions.size()));
  const std::vector<Projector> projectors(rig.begin(), rig.end());
  for (std::size_t column = 0; column < solutions.size(); ++column) {
    const std::vector<Unprojector> unprojectors(solutions[column].begin(), solutions[column].end());
    for (std::size_t i = 0; i < positions.size(); ++i) {
      std::vector<Ray> rays;
      for (std::size_t c = 0; c < rig.size(); ++c) {
        const auto pixel = projectors[c].project(positions[i]);
        const Intrinsics& image = rig[c].intrinsics;
        if (!pixel || pixel->x() < 0.0 || pixel->y() < 0.0 || pixel->x() >= image.width ||
            pixel->y() >= image.height) {
          continue;
        }
        if (const auto ray = unprojectors[c].ray(*pixel)) {
          rays.push_back(*ray);
        }
      }
      const auto point = rays.size() < 2 ? std::nullopt : nearestPoint(rays);
      if (point) {
        changes.block<3, 1>(static_cast<Eigen::Index>(3 * i), static_cast<Eigen::Index>(column)) =
            *point - positions[i];
      }
    }
  }
  return changes;
}

Eigen::MatrixXd jackknifeDeviations(const Eigen::MatrixXd& changes, double factor) {
  return factor * (changes.colwise() - changes.rowwise().mean());
}

double lengthBound95(const Eigen::Matrix3d& covariance) {
  const double mean = covariance.trace();
  if (!(mean > 0.0)) {
    return 0.0;
  }
  const double freedoms = mean * mean / covariance.squaredNorm(); // 1 to 3
  const double spread = 2.0 / (9.0 * freedoms);
  return std::sqrt(mean * std::pow(1.0 - spread + kNormalOne95 * std::sqrt(spread), 3));
}

} // namespace dewpoint::calibration
