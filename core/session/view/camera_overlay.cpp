// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/view/camera_overlay.h"

#include "core/base/belief_region.h"
#include "core/base/overloaded.h"
#include "core/geometry/ellipsoid_image.h"
#include "core/geometry/small_matrices.h"
#include "core/geometry/sphere_image.h"
#include "core/session/snapshot/snapshot_state.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace dewpoint::session {
namespace {

constexpr double kJacobianStep = 1e-4; // meters, central differences

/// First-order ellipse of a Gaussian in the world, seen by a camera: J C Jᵀ.
std::optional<ImageEllipse> projectedEllipse(const Projector& projector,
                                             const Eigen::Vector3d& mean,
                                             const Eigen::Matrix3d& covariance) {
  const auto center = projector.project(mean);
  if (!center || !covariance.allFinite()) {
    return std::nullopt;
  }
  Eigen::Matrix<double, 2, 3> jacobian;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d step = kJacobianStep * Eigen::Vector3d::Unit(axis);
    const auto plus = projector.project(mean + step);
    const auto minus = projector.project(mean - step);
    if (!plus || !minus) {
      return std::nullopt;
    }
    jacobian.col(axis) = (*plus - *minus) / (2.0 * kJacobianStep);
  }
  const Eigen::Matrix2d image = jacobian * covariance * jacobian.transpose();
  const auto eigen = geometry::symmetricEigen2(image);
  const Eigen::Vector2d axis = eigen.vectors.col(1);
  const auto radius = [&](int k) {
    return std::sqrt(std::max(0.0, eigen.values[k]) * kChiSquared95TwoDof);
  };
  return ImageEllipse{*center, radius(1), radius(0), std::atan2(axis.y(), axis.x())};
}

/// The outline of an ellipsoid of this extent (m²).
std::optional<ImageEllipse> outlineOf(const Camera& camera, const Eigen::Vector3d& center,
                                      const Eigen::Matrix3d& extent) {
  const auto outline = geometry::EllipsoidProjector(camera).project({center, extent});
  if (!outline) {
    return std::nullopt;
  }
  const auto eigen = geometry::symmetricEigen2(outline->extent);
  const Eigen::Vector2d axis = eigen.vectors.col(1);
  const auto semiAxis = [&](int k) { return std::sqrt(std::max(0.0, eigen.values[k])); };
  return ImageEllipse{outline->center, semiAxis(1), semiAxis(0), std::atan2(axis.y(), axis.x())};
}

/// Centers of pixels lie at whole numbers, as in all of an overlay but its box.
void addBox(const BoxEstimate& estimate, const BoxParticles& particles, CameraOverlay& overlay) {
  const float largest = particles.weights.size() > 0 ? particles.weights.maxCoeff() : 0.0F;
  for (Eigen::Index i = 0; i < particles.centers.rows(); ++i) {
    overlay.particles.emplace_back(particles.centers(i, 0) - 0.5F, particles.centers(i, 1) - 0.5F);
    overlay.weights.push_back(largest > 0.0F ? particles.weights(i) / largest : 0.0F);
  }
  overlay.box = estimate.box;
  overlay.isBoxHidden = !isConfirmed(estimate);
}

/// Every how many of its particles one is shown, so that one image has no more than a person can
/// see, and a window can paint while it is looked at.
Eigen::Index particleStride(const TrackSnapshot& snapshot, const TargetSnapshot& target) {
  constexpr Eigen::Index kMostParticles =
      10000; // of all targets together; as many as a snapshot has of one
  const Eigen::Index all =
      target.particles.rows() * static_cast<Eigen::Index>(snapshot.targets.size());
  return std::max<Eigen::Index>(1, (all + kMostParticles - 1) / kMostParticles);
}

/// Of what has a place in the room, or had one.
void addPlace(const Camera& camera, const TargetSnapshot& target, Eigen::Index stride,
              CameraOverlay& overlay) {
  const Projector projector(camera);
  const double largest = target.weights.size() > 0 ? target.weights.maxCoeff() : 0.0;
  for (Eigen::Index i = 0; i < target.particles.rows(); i += stride) {
    const Eigen::Vector3d position = target.particles.row(i).matrix().transpose();
    if (const auto pixel = projector.project(position)) {
      overlay.particles.emplace_back(pixel->cast<float>());
      overlay.weights.push_back(largest > 0.0 ? static_cast<float>(target.weights[i] / largest)
                                              : 0.0F);
    }
  }
  const auto position = positionOf(target.estimate);
  if (position && particleCountOf(target.estimate) > 0) {
    overlay.estimate = projector.project(position->mean);
    overlay.ellipse = projectedEllipse(projector, position->mean, position->covariance);
    if (const auto extent = extentOf(target.estimate)) {
      overlay.outline = outlineOf(camera, position->mean, *extent);
    }
  }
  if (const auto best = bestParticleOf(target.estimate)) {
    overlay.bestParticle = projector.project(*best);
  }
  if (target.truth) {
    overlay.truth = projector.project(*target.truth);
  }
}

} // namespace

CameraOverlay cameraOverlay(const TrackSnapshot& snapshot, int camera,
                            const TargetSnapshot& target) {
  CameraOverlay overlay;
  const Camera* its = cameraOf(snapshot, camera);
  if (its == nullptr) {
    return overlay;
  }
  const Eigen::Index stride = particleStride(snapshot, target);
  std::visit(Overloaded{[&](const SphereEstimate&) { addPlace(*its, target, stride, overlay); },
                        [&](const BoxEstimate& box) {
                          if (box.camera == camera) {
                            addBox(box, target.boxParticles, overlay);
                          }
                        },
                        [&](const PersonEstimate&) { addPlace(*its, target, stride, overlay); },
                        [&](const AbsentEstimate&) { addPlace(*its, target, stride, overlay); }},
             target.estimate);
  return overlay;
}

double cloudRadius(const CameraOverlay& overlay) {
  constexpr double kWithin = 0.9;
  if (!overlay.estimate || overlay.particles.size() != overlay.weights.size()) {
    return 0.0;
  }
  std::vector<std::pair<double, double>> apart; // distance and weight
  double total = 0.0;
  for (std::size_t i = 0; i < overlay.particles.size(); ++i) {
    const double weight = overlay.weights[i];
    apart.emplace_back((overlay.particles[i].cast<double>() - *overlay.estimate).norm(), weight);
    total += weight;
  }
  std::ranges::sort(apart);
  double within = 0.0;
  for (const auto& [distance, weight] : apart) {
    within += weight;
    if (within >= kWithin * total) {
      return distance;
    }
  }
  return 0.0;
}

std::vector<ProposedOutline> proposedOutlines(const TrackSnapshot& snapshot, int camera,
                                              const TargetSnapshot& target) {
  std::vector<ProposedOutline> outlines;
  const Camera* its = cameraOf(snapshot, camera);
  if (its == nullptr) {
    return outlines;
  }
  const SphereProjector projector(*its);
  for (const CandidatePosition& proposed : target.positionCandidates) {
    if (const auto outline = projector.project(proposed.position, proposed.radius)) {
      outlines.push_back({outline->center, outline->radius, proposed.kind, proposed.probability});
    }
  }
  return outlines;
}

} // namespace dewpoint::session
