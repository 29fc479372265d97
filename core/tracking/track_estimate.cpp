// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/track_estimate.h"

#include <cmath>

namespace dewpoint::tracking {
namespace {

constexpr double kHeldExistence = 0.5; ///< below it a person is searched for

struct Held {
  bool operator()(const SphereEstimate& sphere) const { return sphere.isValid; }
  /// A method that knows no hiding may follow its box out of the image, where nothing is alike.
  bool operator()(const BoxEstimate& box) const { return box.isVisible && box.similarity > 0.0; }
  bool operator()(const PersonEstimate& person) const {
    return person.existenceProbability >= kHeldExistence;
  }
  bool operator()(const AbsentEstimate& /*absent*/) const { return false; }
};

struct Existence {
  double operator()(const SphereEstimate& sphere) const { return sphere.existenceProbability; }
  double operator()(const BoxEstimate& box) const { return box.similarity; }
  double operator()(const PersonEstimate& person) const { return person.existenceProbability; }
  double operator()(const AbsentEstimate& /*absent*/) const { return 0.0; }
};

struct EffectiveSampleSize {
  template <class Estimate> double operator()(const Estimate& estimate) const {
    return estimate.effectiveSampleSize;
  }
  double operator()(const AbsentEstimate& /*absent*/) const { return 0.0; }
};

struct ParticleCount {
  template <class Estimate> int operator()(const Estimate& estimate) const {
    return estimate.particleCount;
  }
  int operator()(const AbsentEstimate& /*absent*/) const { return 0; }
};

struct Position {
  using Result = std::optional<Gaussian3>;
  Result operator()(const SphereEstimate& sphere) const {
    return Gaussian3{sphere.mean, sphere.covariance};
  }
  Result operator()(const BoxEstimate& /*box*/) const { return std::nullopt; }
  Result operator()(const PersonEstimate& person) const {
    return Gaussian3{person.position, person.covariance};
  }
  Result operator()(const AbsentEstimate& /*absent*/) const { return std::nullopt; }
};

struct Velocity {
  using Result = std::optional<Eigen::Vector3d>;
  Result operator()(const SphereEstimate& /*sphere*/) const { return std::nullopt; }
  Result operator()(const BoxEstimate& /*box*/) const { return std::nullopt; }
  Result operator()(const PersonEstimate& person) const { return person.velocity; }
  Result operator()(const AbsentEstimate& /*absent*/) const { return std::nullopt; }
};

struct Identity {
  std::size_t track;
  int operator()(const PersonEstimate& person) const { return person.identity; }
  template <class Estimate> int operator()(const Estimate& /*estimate*/) const {
    return static_cast<int>(track) + 1;
  }
};

} // namespace

double spreadOf(const Eigen::Matrix3d& covariance) {
  return std::sqrt(covariance.trace());
}

double SphereEstimate::spread() const {
  return spreadOf(covariance);
}

bool isAbsent(const TrackEstimate& estimate) {
  return std::holds_alternative<AbsentEstimate>(estimate);
}

bool isConfirmed(const TrackEstimate& estimate) {
  return std::visit(Held{}, estimate);
}

bool isAmbiguous(const TrackEstimate& estimate) {
  const auto* const sphere = std::get_if<SphereEstimate>(&estimate);
  return sphere != nullptr && sphere->isAmbiguous;
}

std::optional<Eigen::Matrix3d> extentOf(const TrackEstimate& estimate) {
  const auto* const sphere = std::get_if<SphereEstimate>(&estimate);
  return sphere != nullptr ? sphere->extent : std::nullopt;
}

double existenceProbabilityOf(const TrackEstimate& estimate) {
  return std::visit(Existence{}, estimate);
}

double effectiveSampleSizeOf(const TrackEstimate& estimate) {
  return std::visit(EffectiveSampleSize{}, estimate);
}

int particleCountOf(const TrackEstimate& estimate) {
  return std::visit(ParticleCount{}, estimate);
}

std::optional<Gaussian3> positionOf(const TrackEstimate& estimate) {
  return std::visit(Position{}, estimate);
}

std::optional<Eigen::Vector3d> velocityOf(const TrackEstimate& estimate) {
  return std::visit(Velocity{}, estimate);
}

int identityOf(const TrackEstimate& estimate, std::size_t track) {
  return std::visit(Identity{track}, estimate);
}

std::optional<Eigen::Vector3d> bestParticleOf(const TrackEstimate& estimate) {
  const auto* sphere = std::get_if<SphereEstimate>(&estimate);
  return sphere != nullptr && sphere->particleCount > 0 ? std::optional(sphere->best)
                                                        : std::nullopt;
}

const std::vector<CameraEvidence>& cameraEvidenceOf(const TrackEstimate& estimate) {
  static const std::vector<CameraEvidence> kNone;
  const auto* sphere = std::get_if<SphereEstimate>(&estimate);
  return sphere != nullptr ? sphere->cameras : kNone;
}

const std::vector<ColorRanges>& colorsOf(const TrackEstimate& estimate) {
  static const std::vector<ColorRanges> kNone;
  const auto* sphere = std::get_if<SphereEstimate>(&estimate);
  return sphere != nullptr ? sphere->colors : kNone;
}

std::vector<SphereEstimate> spheresOf(const std::vector<TrackEstimate>& estimates) {
  std::vector<SphereEstimate> spheres;
  spheres.reserve(estimates.size());
  for (const TrackEstimate& estimate : estimates) {
    const auto* sphere = std::get_if<SphereEstimate>(&estimate);
    spheres.push_back(sphere != nullptr ? *sphere : SphereEstimate{});
  }
  return spheres;
}

} // namespace dewpoint::tracking
