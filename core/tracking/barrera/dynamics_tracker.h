// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_classifier.h"
#include "core/geometry/ray.h"
#include "core/tracking/barrera/random_walk_tracker.h"
#include "core/tracking/camera_report.h"
#include "core/tracking/target.h"

#include <optional>
#include <vector>

namespace dewpoint::tracking {

/// The particle filter over 3D positions with which Barrera, Cañas and Matellán (2005, section
/// III-C) study the dynamics: an isotropic random walk, and a Gaussian around a measured position.
/// The position is that of the target's pixels in all cameras (their centers of mass,
/// triangulated), unless it is given. A TargetFilter; no camera has a likelihood of its own.
class DynamicsTracker final : public RandomWalkTracker {
public:
  DynamicsTracker(const ParameterValues& parameters, const CameraRig& rig, const Target& target);

  void setTarget(const Target& target);
  void setCameras(const CameraRig& rig);
  /// Measures the position in the images.
  void beginFrame(FrameSetPtr frames);
  /// The position of frame `frame` from elsewhere (world, meters), in place of beginFrame();
  /// nothing when it is not known: the cloud spreads.
  void beginFrame(std::int64_t frame, const std::optional<Eigen::Vector3d>& measured);
  SphereEstimate iterate(ThreadTeam& team);
  /// What each camera has to say on the target being held or not.
  std::vector<CameraReport> explain() const;

  const std::optional<Eigen::Vector3d>& measured() const { return measured_; }

private:
  void measure();

  std::vector<Unprojector> unprojectors_;
  ColorClassifier classifier_;
  std::vector<bool> seen_; ///< per camera: it shows the target's color
  std::optional<Eigen::Vector3d> measured_;
};

} // namespace dewpoint::tracking
