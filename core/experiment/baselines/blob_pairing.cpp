// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/baselines/blob_pairing.h"

#include "core/geometry/image_bounds.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace dewpoint::experiment {
namespace {

/// Blobs per camera that are paired beyond the number of targets: the smallest are noise, and the
/// number of pairs grows with the square.
constexpr std::size_t kSpareBlobs = 16;
/// Meters, small against all distances, for the magnification at a position where the target's
/// radius is not known.
constexpr double kProbeRadius = 0.01;
/// Puts what is outside a gate behind everything inside it.
constexpr double kOutsideGate = 1e6;

double allowedPx(const Bearing& bearing) {
  return std::max(kMaxResidualPx, kMaxResidualRadii * bearing.radiusPx);
}

double distanceCost(const PairedBlobs& pair, const ExpectedPosition& expected) {
  const Eigen::Vector3d off = pair.point.position - expected.mean;
  const Eigen::LDLT<Eigen::Matrix3d> spread(expected.covariance + pair.point.covariance);
  const double squared = off.dot(spread.solve(off));
  if (!std::isfinite(squared)) {
    return kOutsideGate;
  }
  if (!expected.gate) {
    return std::min(squared, kFarSquared);
  }
  return squared > *expected.gate ? kOutsideGate + squared : squared;
}

} // namespace

double relativeResidual(const std::vector<Bearing>& bearings, const Eigen::Vector3d& position) {
  double share = 0.0;
  for (const Bearing& bearing : bearings) {
    share = std::max(share, residualPx(bearing, position) / allowedPx(bearing));
  }
  return share;
}

BlobPairing::BlobPairing(const CameraRig& rig)
    : rig_(rig), unprojectors_(rig.begin(), rig.end()), projectors_(rig.begin(), rig.end()) {}

std::optional<Bearing> BlobPairing::makeBearing(std::size_t camera, std::size_t blob,
                                                const Eigen::Vector2d& pixel,
                                                double radiusPx) const {
  const auto ray = unprojectors_[camera].ray(pixel);
  if (!ray) {
    return std::nullopt;
  }
  const Intrinsics& intrinsics = rig_[camera].intrinsics;
  return Bearing{camera, blob, *ray, std::sqrt(intrinsics.focalX * intrinsics.focalY), radiusPx};
}

std::vector<std::vector<Bearing>> BlobPairing::bearingsOf(const std::vector<CameraBlobs>& cameras,
                                                          std::size_t limit) const {
  std::vector<std::vector<Bearing>> bearings(rig_.size());
  for (std::size_t camera = 0; camera < std::min(cameras.size(), rig_.size()); ++camera) {
    const std::vector<Blob>& blobs = cameras[camera].blobs;
    for (std::size_t k = 0; k < std::min(blobs.size(), limit); ++k) {
      if (const auto seen = makeBearing(camera, k, blobs[k].center, blobs[k].radiusPx())) {
        bearings[camera].push_back(*seen);
      }
    }
  }
  return bearings;
}

std::optional<double> BlobPairing::impliedRadius(const Bearing& bearing,
                                                 const Eigen::Vector3d& position,
                                                 double radius) const {
  const double probe = radius > 0.0 ? radius : kProbeRadius;
  const auto image = projectors_[bearing.camera].project(position, probe);
  if (!image || !(image->radius > 0.0) || !(bearing.radiusPx > 0.0)) {
    return std::nullopt;
  }
  return probe * bearing.radiusPx / image->radius;
}

std::optional<double> BlobPairing::sizeCost(const std::vector<Bearing>& bearings,
                                            const Eigen::Vector3d& position, double radius) const {
  std::vector<double> logarithms;
  logarithms.reserve(bearings.size());
  double mean = 0.0;
  for (const Bearing& bearing : bearings) {
    const auto implied = impliedRadius(bearing, position, radius);
    if (!implied) {
      return std::nullopt;
    }
    logarithms.push_back(std::log(*implied));
    mean += logarithms.back() / static_cast<double>(bearings.size());
  }
  const double expected = radius > 0.0 ? std::log(radius) : mean;
  double cost = 0.0;
  for (const double logarithm : logarithms) {
    const double off = logarithm - expected;
    if (std::abs(off) > std::log(kMaxSizeRatio)) {
      return std::nullopt;
    }
    cost += off * off / (kSizeSigma * kSizeSigma);
  }
  return cost;
}

double BlobPairing::missingCost(const TriangulatedPoint& point,
                                const std::vector<CameraBlobs>& cameras) const {
  double cost = 0.0;
  for (std::size_t camera = 0; camera < std::min(cameras.size(), rig_.size()); ++camera) {
    const bool sees = std::ranges::any_of(
        point.bearings, [&](const Bearing& bearing) { return bearing.camera == camera; });
    if (sees || !cameras[camera].hasImage) {
      continue;
    }
    const auto pixel = projectors_[camera].projector().project(point.position);
    cost += pixel && isInImage(rig_[camera].intrinsics, *pixel) ? kMissingCost : 0.0;
  }
  return cost;
}

std::optional<PairedBlobs> BlobPairing::evaluatePair(std::vector<Bearing> bearings,
                                                     const std::vector<CameraBlobs>& cameras,
                                                     double radius) const {
  auto point = triangulate(std::move(bearings));
  if (!point) {
    return std::nullopt;
  }
  const double share = relativeResidual(point->bearings, point->position);
  const auto size =
      share <= 1.0 ? sizeCost(point->bearings, point->position, radius) : std::optional<double>();
  if (!size) {
    return std::nullopt;
  }
  // What is just allowed is two standard deviations off.
  const double cost = 4.0 * share * share + *size + missingCost(*point, cameras);
  return PairedBlobs{std::move(*point), cost};
}

std::vector<Bearing> BlobPairing::extendPair(std::vector<Bearing> members,
                                             const Eigen::Vector3d& position,
                                             const std::vector<std::vector<Bearing>>& all) const {
  const std::size_t first = members[0].camera;
  const std::size_t second = members[1].camera;
  for (std::size_t camera = 0; camera < all.size(); ++camera) {
    if (camera == first || camera == second || all[camera].empty()) {
      continue;
    }
    const Bearing& nearest =
        *std::ranges::min_element(all[camera], {}, [&](const Bearing& bearing) {
          return relativeResidual({bearing}, position);
        });
    members.push_back(nearest);
    const auto more = triangulate(members);
    if (!more || relativeResidual(members, more->position) > 1.0) {
      members.pop_back();
    }
  }
  return members;
}

std::vector<PairedBlobs> BlobPairing::pairBlobs(const std::vector<CameraBlobs>& cameras,
                                                double radius, std::size_t targetCount) const {
  const auto bearings = bearingsOf(cameras, kSpareBlobs + targetCount);
  std::vector<PairedBlobs> pairs;
  for (std::size_t a = 0; a < bearings.size(); ++a) {
    for (std::size_t b = a + 1; b < bearings.size(); ++b) {
      for (const Bearing& first : bearings[a]) {
        for (const Bearing& second : bearings[b]) {
          auto two = evaluatePair({first, second}, cameras, radius);
          if (!two) {
            continue;
          }
          auto all = extendPair(two->point.bearings, two->point.position, bearings);
          if (all.size() > 2) {
            if (auto more = evaluatePair(std::move(all), cameras, radius)) {
              pairs.push_back(std::move(*more));
            }
          }
          pairs.push_back(std::move(*two));
        }
      }
    }
  }
  return pairs;
}

std::optional<std::size_t> BlobPairing::blobAt(std::size_t camera, const std::vector<Blob>& blobs,
                                               const Eigen::Vector3d& position,
                                               double radius) const {
  std::optional<std::size_t> best;
  double least = 1.0;
  for (std::size_t k = 0; k < blobs.size(); ++k) {
    const auto seen = makeBearing(camera, k, blobs[k].center, blobs[k].radiusPx());
    if (!seen) {
      continue;
    }
    const double share = relativeResidual({*seen}, position);
    if (share <= least && (radius <= 0.0 || sizeCost({*seen}, position, radius))) {
      least = share;
      best = k;
    }
  }
  return best;
}

std::vector<std::optional<TriangulatedPoint>>
assignPairs(const std::vector<PairedBlobs>& pairs, const std::vector<ExpectedPosition>& expected) {
  Eigen::MatrixXd cost(static_cast<Eigen::Index>(expected.size()),
                       static_cast<Eigen::Index>(pairs.size()));
  for (std::size_t target = 0; target < expected.size(); ++target) {
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      cost(static_cast<Eigen::Index>(target), static_cast<Eigen::Index>(k)) =
          pairs[k].cost + distanceCost(pairs[k], expected[target]);
    }
  }
  constexpr double kTaken = std::numeric_limits<double>::infinity();
  std::set<std::pair<std::size_t, std::size_t>> used; // camera and blob
  std::vector<std::optional<TriangulatedPoint>> result(expected.size());
  for (std::size_t round = 0; round < expected.size() && !pairs.empty(); ++round) {
    Eigen::Index target = 0;
    Eigen::Index chosen = 0;
    if (!std::isfinite(cost.minCoeff(&target, &chosen))) {
      break;
    }
    const TriangulatedPoint& point = pairs[static_cast<std::size_t>(chosen)].point;
    result[static_cast<std::size_t>(target)] = point;
    for (const Bearing& bearing : point.bearings) {
      used.insert({bearing.camera, bearing.blob});
    }
    cost.row(target).setConstant(kTaken);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      if (std::ranges::any_of(pairs[k].point.bearings, [&](const Bearing& bearing) {
            return used.contains({bearing.camera, bearing.blob});
          })) {
        cost.col(static_cast<Eigen::Index>(k)).setConstant(kTaken);
      }
    }
  }
  return result;
}

} // namespace dewpoint::experiment
