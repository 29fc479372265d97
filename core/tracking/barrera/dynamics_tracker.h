// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_classifier.h"
#include "core/geometry/ray.h"
#include "core/tracking/barrera/random_walk_tracker.h"

#include <optional>
#include <vector>

namespace dewpoint::tracking {

/// The particle filter over 3D positions with which Barrera, Cañas and Matellán (2005, section
/// III-C) study the dynamics: an isotropic random walk, and a Gaussian around a measured position.
/// The position is that of the target's pixels in all cameras (their centers of mass,
/// triangulated), unless it is given.
class DynamicsTracker final : public RandomWalkTracker {
public:
  DynamicsTracker(const ParameterValues& parameters, const CameraRig& rig, const Target& target);

  void setTarget(const Target& target) override;
  void setCameras(const CameraRig& rig) override;
  /// Measures the position in the images.
  void beginFrame(FrameSetPtr frames) override;
  /// The position of frame `frame` from elsewhere (world, metres), in place of beginFrame();
  /// nothing when it is not known: the cloud spreads.
  void beginFrame(std::int64_t frame, const std::optional<Eigen::Vector3d>& measured);
  TargetEstimate iterate(ThreadTeam& team) override;
  std::unique_ptr<Tracker> clone() const override;
  std::vector<CameraReport> explain() const override;
  /// None: no camera has a likelihood of its own.
  std::vector<LikelihoodMap> likelihoodMaps(int reach) const override;

  const std::optional<Eigen::Vector3d>& measured() const { return measured_; }

private:
  void measure();

  std::vector<Unprojector> unprojectors_;
  ColorClassifier classifier_;
  std::vector<bool> seen_; ///< per camera: it shows the target's color
  std::optional<Eigen::Vector3d> measured_;
};

} // namespace dewpoint::tracking
