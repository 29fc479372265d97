// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/sphere/color_window.h"
#include "core/tracking/barrera/random_walk_tracker.h"
#include "core/tracking/camera_report.h"
#include "core/tracking/target.h"
#include "core/tracking/tracker_diagnostics.h"

#include <vector>

namespace dewpoint::tracking {

/// The 3D color particle filter of Barrera, Cañas and Matellán (2005): isotropic random walk, color
/// window in every camera, multinomial resampling at every iteration. A TargetFilter.
class BarreraTracker final : public RandomWalkTracker {
public:
  BarreraTracker(const ParameterValues& parameters, const CameraRig& rig, const Target& target);

  void setTarget(const Target& target);
  /// Another calibration of the same cameras, from the next iteration on; the particles stay.
  void setCameras(const CameraRig& rig);
  void beginFrame(FrameSetPtr frames);
  SphereEstimate iterate(ThreadTeam& team);
  /// As RandomWalkTracker::correct(), with what the cameras see there.
  SphereEstimate correct(const Gaussian3& position);
  /// About how many bytes a copy takes.
  std::size_t memoryBytes() const;
  /// Why each camera does, or does not, confirm the target.
  std::vector<CameraReport> explain() const;
  /// Around the estimate, up to `reach` pixels in each direction; one per camera.
  std::vector<LikelihoodMap> likelihoodMaps(int reach) const;

private:
  void showImages();
  /// Per camera the window at a point (meters, world frame); the odds are those of its likelihood
  /// against that of a window with no matching pixel, 1/25.
  std::vector<CameraEvidence> evidence(const Eigen::Vector3d& point) const;
  /// Adds to an estimate what the cameras see at its mean.
  void addEvidence(SphereEstimate& estimate) const;

  std::vector<Projector> projectors_;
  ColorClassifier classifier_;
  ColorWindow observation_;
};

} // namespace dewpoint::tracking
