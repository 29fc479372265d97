// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/particle_filter.h"
#include "core/observation/color_window.h"
#include "core/tracking/tracker.h"

#include <cstdint>

namespace dewpoint {

/// The 3D color particle filter of Barrera, Cañas and Matellán (2005): isotropic random walk, color
/// window in every camera, multinomial resampling at every iteration.
class BarreraTracker final : public Tracker {
public:
  BarreraTracker(const ParameterValues& parameters, const CameraRig& rig, const Target& target);

  /// Particle count, motion and iterations act at the next iteration; the start at the next
  /// restart.
  void configure(const ParameterValues& parameters) override;
  void setTarget(const Target& target) override;
  void setCameras(const CameraRig& rig) override;
  void restart(std::uint64_t seed) override;
  int iterationsPerFrame() const override;
  void beginFrame(FrameSetPtr frames) override;
  TargetEstimate iterate(ThreadTeam& team) override;
  void particles(int limit, Eigen::ArrayXXd& positions, Eigen::ArrayXd& weights) const override;
  std::unique_ptr<Tracker> clone() const override;
  std::size_t memoryBytes() const override;
  std::vector<CameraReport> explain() const override;
  std::vector<LikelihoodMap> likelihoodMaps(int reach) const override;

private:
  Eigen::ArrayXXd drawStart() const;
  void showImages();
  /// The image a camera shows; empty when there is none.
  cv::Mat imageOf(std::size_t camera) const;
  CameraReport explain(std::size_t camera) const;
  /// Per camera the window at the point; the odds are those of its likelihood against that of a
  /// window with no more than chance, 1/25.
  std::vector<CameraEvidence> evidence(const Eigen::Vector3d& point) const;

  ParameterValues parameters_;
  std::vector<Projector> projectors_;
  ColorClassifier classifier_;
  ColorWindow observation_;
  ParticleFilter filter_;
  RandomKey key_;
  FrameSetPtr frames_;
  TargetEstimate estimate_;
  bool started_ = false; ///< an iteration has run since the last restart
};

} // namespace dewpoint
