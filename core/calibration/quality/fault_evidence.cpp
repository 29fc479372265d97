// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/quality/fault_evidence.h"

#include "core/base/statistics.h"
#include "core/geometry/ray.h"
#include "core/geometry/rotation_vector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace dewpoint::calibration {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
/// Points that a rig is fitted to.
constexpr std::size_t kMostPoints = 240;
/// Instants, and points, that a fit needs.
constexpr std::size_t kFewestComparedPoints = 8;
constexpr double kMostRigSigmas = 5.0;   ///< that a camera is off the initial rig
constexpr double kUnseenPx2 = 1e6;       ///< pixels², of a point the camera cannot see
constexpr double kMedianSquare = 0.4549; ///< of chi-square with one freedom
constexpr std::array<double, 3> kWidths{40.0, 8.0, 2.0}; ///< of the loss, pixels, far to near

using SeenBy = std::vector<std::pair<std::size_t, Eigen::Vector2d>>;

/// Who sees each point, by instant and id.
std::vector<std::vector<SeenBy>> seenBy(const ImagePoints& imagePoints,
                                        const std::vector<bool>& use) {
  std::vector<std::vector<SeenBy>> table(imagePoints.times.size(),
                                         std::vector<SeenBy>(imagePoints.maxPointsPerState));
  for (std::size_t c = 0; c < imagePoints.pointsPerCamera.size(); ++c) {
    if (!use[c]) {
      continue;
    }
    for (const ImagePoint& imagePoint : imagePoints.pointsPerCamera[c]) {
      table[imagePoint.instant][imagePoint.id].emplace_back(c, imagePoint.pixel);
    }
  }
  return table;
}

BundleProblem pointProblem(const CameraRig& initialRig, const ImagePoints& imagePoints,
                           const std::vector<bool>& use, const InitialRigSigma& sigma,
                           bool centersFree) {
  BundleProblem problem;
  std::vector<std::size_t> renamed(initialRig.size(), 0);
  for (std::size_t c = 0; c < initialRig.size(); ++c) {
    if (use[c]) {
      renamed[c] = problem.cameras.size();
      problem.cameras.push_back({.camera = initialRig[c],
                                 .isPrincipalPointFree = centersFree,
                                 .posePrior = PosePrior{sigma.rotation, sigma.position}});
    }
  }
  problem.bodies.push_back({.name = "point"});
  std::vector<SeenBy> points;
  for (auto& instant : seenBy(imagePoints, use)) {
    for (SeenBy& seen : instant) {
      if (seen.size() >= 2) {
        points.push_back(std::move(seen));
      }
    }
  }
  for (const SeenBy& seen : selectEvenly(points, kMostPoints)) {
    for (const auto& [camera, pixel] : seen) {
      problem.observations.push_back(
          {.camera = renamed[camera], .state = problem.states.size(), .pixel = pixel});
    }
    problem.states.push_back({.time = static_cast<double>(problem.states.size())});
  }
  problem.loss = RobustLoss::SoftL1;
  problem.isDraft = true;
  problem.maxIterations = 60;
  return problem;
}

/// Adjusted with the loss narrowed step by step.
Result<BundleResult> narrowed(BundleProblem& problem, std::size_t firstWidth) {
  Result<BundleResult> now = failure(ErrorCode::Undetermined, "", "", "");
  for (std::size_t w = firstWidth; w < kWidths.size(); ++w) {
    problem.lossWidth = kWidths[w];
    now = adjustBundle(problem);
    if (!now) {
      return now;
    }
    if (w + 1 < kWidths.size()) { // the prior stays about the initial rig in the last step only
      for (std::size_t c = 0; c < problem.cameras.size(); ++c) {
        problem.cameras[c].camera.intrinsics = now->cameras[c].intrinsics;
      }
      for (std::size_t s = 0; s < problem.states.size(); ++s) {
        problem.states[s] = now->states[s];
        problem.states[s].isPositionKnown =
            problem.states[s].isPositionKnown && !problem.states[s].isFixed;
      }
    }
  }
  return now;
}

std::vector<double> squaresOf(const BundleResult& now) {
  std::vector<double> squares;
  for (const Eigen::Vector2d& residual : now.residuals) {
    for (const double value : residual) {
      squares.push_back(std::isfinite(value) ? value * value : kUnseenPx2);
    }
  }
  return squares;
}

/// Whether a camera is where the initial rig allows it: else it fits by standing elsewhere, which
/// is no explanation.
bool plausible(const Camera& initial, const Camera& found, const InitialRigSigma& sigma) {
  const double turn =
      angleBetween(found.cameraFromWorld.linear(), initial.cameraFromWorld.linear());
  return turn < kMostRigSigmas * sigma.rotation &&
         (found.center() - initial.center()).norm() < kMostRigSigmas * sigma.position;
}

} // namespace

ImagePoints imagePointsOf(const BundleProblem& problem) {
  ImagePoints all;
  all.pointsPerCamera.resize(problem.cameras.size());
  for (const BundleState& state : problem.states) {
    all.times.push_back(state.time);
  }
  for (const BundleObservation& seen : problem.observations) {
    all.pointsPerCamera[seen.camera].push_back({seen.state, seen.point, seen.pixel});
    all.maxPointsPerState = std::max(all.maxPointsPerState, seen.point + 1);
  }
  return all;
}

std::optional<PointFit> estimateStructureAndPoses(const CameraRig& initialRig,
                                                  const ImagePoints& imagePoints,
                                                  const std::vector<bool>& use,
                                                  const InitialRigSigma& sigma, bool centersFree) {
  BundleProblem problem = pointProblem(initialRig, imagePoints, use, sigma, centersFree);
  if (problem.cameras.size() < 2 || problem.states.size() < kFewestComparedPoints) {
    return std::nullopt;
  }
  const auto now = narrowed(problem, 0);
  if (!now) {
    return std::nullopt;
  }
  PointFit fit;
  fit.rig = initialRig;
  std::size_t next = 0;
  for (std::size_t c = 0; c < initialRig.size(); ++c) {
    if (use[c]) {
      fit.rig[c] = now->cameras[next++];
    }
  }
  fit.squaredResiduals = squaresOf(*now);
  for (std::size_t c = 0; c < initialRig.size(); ++c) {
    if (!plausible(initialRig[c], fit.rig[c], sigma)) {
      fit.squaredResiduals.assign(fit.squaredResiduals.size(), kUnseenPx2);
    }
  }
  fit.pointCount = problem.states.size();
  const auto rows = static_cast<double>(fit.squaredResiduals.size());
  const double degreesOfFreedom = rows - 3.0 * static_cast<double>(problem.states.size()) -
                                  6.0 * static_cast<double>(problem.cameras.size());
  fit.sigmaPx = std::sqrt(upperMedian(fit.squaredResiduals) / kMedianSquare * rows /
                          std::max(degreesOfFreedom, 0.1 * rows));
  return fit;
}

PointPositions triangulatedPositions(const CameraRig& rig, const ImagePoints& imagePoints,
                                     const std::vector<bool>& use) {
  std::vector<Unprojector> unprojectors;
  for (const Camera& camera : rig) {
    unprojectors.emplace_back(camera);
  }
  PointPositions positions;
  for (const auto& instant : seenBy(imagePoints, use)) {
    auto& there = positions.emplace_back();
    for (const SeenBy& seen : instant) {
      std::vector<Ray> rays;
      for (const auto& [camera, pixel] : seen) {
        if (const auto ray = unprojectors[camera].ray(pixel)) {
          rays.push_back(*ray);
        }
      }
      there.push_back(rays.size() >= 2 ? nearestPoint(rays) : std::nullopt);
    }
  }
  return positions;
}

std::optional<CameraResection> fitCamera(const Camera& initial,
                                         const std::vector<PointCorrespondence>& correspondences,
                                         const InitialRigSigma& sigma, bool isFocalFree,
                                         bool quick) {
  BundleProblem problem;
  problem.cameras.push_back({.camera = initial,
                             .isFocalFree = isFocalFree,
                             .posePrior = PosePrior{sigma.rotation, sigma.position}});
  problem.bodies.push_back({.name = "point"});
  for (const PointCorrespondence& seen : correspondences) {
    problem.observations.push_back(
        {.camera = 0, .state = problem.states.size(), .pixel = seen.pixel});
    problem.states.push_back({.isFixed = true, .ends = {seen.position, seen.position}});
  }
  problem.loss = RobustLoss::SoftL1;
  problem.isDraft = true;
  problem.maxIterations = quick ? 8 : 40;
  const auto now = narrowed(problem, quick ? kWidths.size() - 2 : 0);
  if (correspondences.empty() || !now) {
    return std::nullopt;
  }
  CameraResection found{now->cameras[0], squaresOf(*now)};
  if (!plausible(initial, found.camera, sigma)) {
    found.squaredResiduals.assign(found.squaredResiduals.size(), kUnseenPx2);
  }
  return found;
}

double meanCost(const std::vector<double>& squares, double sigmaPx) {
  /// Of Student's distribution.
  constexpr double kFreedoms = 4.0;
  double sum = 0.0;
  for (const double square : squares) {
    sum += 0.5 * (kFreedoms + 1.0) * std::log1p(square / (kFreedoms * sigmaPx * sigmaPx));
  }
  return squares.empty() ? 0.0 : sum / static_cast<double>(squares.size());
}

} // namespace dewpoint::calibration
