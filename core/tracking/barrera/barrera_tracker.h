// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/sphere/color_window.h"
#include "core/tracking/barrera/random_walk_tracker.h"
#include "core/tracking/camera_report.h"
#include "core/tracking/target.h"
#include "core/tracking/tracker_diagnostics.h"

#include <vector>

namespace dewpoint::tracking {

/// The `barrera` method: the 3D color particle filter of Barrera, Cañas and Matellán (2005), with
/// an isotropic random walk, a color window in every camera, and multinomial resampling at every
/// iteration. The class is a TargetFilter (it tracks one target).
class BarreraTracker final : public RandomWalkTracker {
public:
  BarreraTracker(const ParameterValues& parameters, const CameraRig& rig, const Target& target);

  void setTarget(const Target& target);
  /// Sets another calibration of the same cameras from the next iteration on; the particles are
  /// kept.
  void setCameras(const CameraRig& rig);
  void beginFrame(FrameSetPtr frames);
  SphereEstimate iterate(ThreadTeam& team);
  /// Draws the particles again from a Gaussian given by the user (world frame, m, m²). Returns the
  /// new estimate, with the values for each camera filled in (SphereEstimate::cameras).
  SphereEstimate correct(const Gaussian3& position);
  /// Returns the approximate size of a copy of this tracker in bytes.
  std::size_t memoryBytes() const;
  /// Returns for each camera whether the camera confirms the target, and the reason if not.
  std::vector<CameraReport> cameraReports() const;
  /// Returns a map of the log likelihood around the estimate for each camera. Each map extends up
  /// to `reach` pixels in each direction.
  std::vector<LikelihoodMap> likelihoodMaps(int reach) const;

private:
  void passImages();
  /// Returns the evidence in each camera's image for a target at a point (meters, world frame). The
  /// existence probability compares the likelihood of the color window at the point with 1/25, the
  /// likelihood of a window without matching pixels.
  std::vector<CameraEvidence> evidence(const Eigen::Vector3d& point) const;
  /// Fills in SphereEstimate::cameras for the mean of an estimate.
  void addEvidence(SphereEstimate& estimate) const;

  std::vector<Projector> projectors_;
  ColorClassifier classifier_;
  ColorWindow observation_;
};

} // namespace dewpoint::tracking
