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

/// The `dynamics` method: the particle filter with which Barrera, Cañas and Matellán (2005, section
/// III-C) study how a particle cloud moves. The filter has an isotropic random walk, and a Gaussian
/// likelihood around a measured position. The caller gives this position, or it is triangulated
/// from the centroids of the target's pixels in all cameras. The class is a TargetFilter (it tracks
/// one target), and provides no likelihoods for single cameras.
class DynamicsTracker final : public RandomWalkTracker {
public:
  DynamicsTracker(const ParameterValues& parameters, const CameraRig& rig, const Target& target);

  void setTarget(const Target& target);
  void setCameras(const CameraRig& rig);
  /// Sets the images of a frame and measures the target's position in these images.
  void beginFrame(FrameSetPtr frames);
  /// Sets the position measured in frame `frame` (world frame, meters), in place of images. Without
  /// a position, the particles only move at random, so the cloud spreads.
  void beginFrame(std::int64_t frame, const std::optional<Eigen::Vector3d>& measured);
  SphereEstimate iterate(ThreadTeam& team);
  /// Returns for each camera whether the camera confirms the target, and the reason if not.
  std::vector<CameraReport> cameraReports() const;

  /// Returns the measured position of this frame (world frame, meters), or nothing if no position
  /// was measured.
  const std::optional<Eigen::Vector3d>& measuredPosition() const { return measured_; }

private:
  void measure();

  std::vector<Unprojector> unprojectors_;
  ColorClassifier classifier_;
  std::vector<bool> seen_; ///< per camera: true if it shows the target's color
  std::optional<Eigen::Vector3d> measured_;
};

} // namespace dewpoint::tracking
