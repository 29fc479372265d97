// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/sphere/color_window.h"
#include "core/tracking/barrera/random_walk_tracker.h"

namespace dewpoint::tracking {

/// The 3D color particle filter of Barrera, Cañas and Matellán (2005): isotropic random walk, color
/// window in every camera, multinomial resampling at every iteration.
class BarreraTracker final : public RandomWalkTracker {
public:
  BarreraTracker(const ParameterValues& parameters, const CameraRig& rig, const Target& target);

  void setTarget(const Target& target) override;
  void setCameras(const CameraRig& rig) override;
  void beginFrame(FrameSetPtr frames) override;
  TargetEstimate iterate(ThreadTeam& team) override;
  std::unique_ptr<Tracker> clone() const override;
  std::size_t memoryBytes() const override;
  std::vector<CameraReport> explain() const override;
  std::vector<LikelihoodMap> likelihoodMaps(int reach) const override;

private:
  void showImages();
  CameraReport explain(std::size_t camera) const;
  /// Per camera the window at the point; the odds are those of its likelihood against that of a
  /// window with no more than chance, 1/25.
  std::vector<CameraEvidence> evidence(const Eigen::Vector3d& point) const;

  std::vector<Projector> projectors_;
  ColorClassifier classifier_;
  ColorWindow observation_;
};

} // namespace dewpoint::tracking
