// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/multi_tracker.h"

namespace dewpoint::tracking {

/// One tracker per target, none knowing of the others. Target k starts from derivedSeed(seed, k).
class IndependentTrackers final : public MultiTracker {
public:
  explicit IndependentTrackers(std::vector<std::unique_ptr<Tracker>> trackers);

  void configure(const ParameterValues& parameters) override;
  void setTargets(const std::vector<Target>& targets) override;
  void setCameras(const CameraRig& rig) override;
  void restart(std::uint64_t seed) override;
  int iterationsPerFrame() const override;
  void beginFrame(FrameSetPtr frames) override;
  void iterate(ThreadTeam& team) override;
  const std::vector<TargetEstimate>& estimates() const override { return estimates_; }
  void particles(std::size_t target, int limit, Eigen::ArrayXXd& positions,
                 Eigen::ArrayXd& weights) const override;
  std::unique_ptr<MultiTracker> clone() const override;
  std::size_t memoryBytes() const override;
  std::vector<CameraReport> explain(std::size_t target) const override;
  std::vector<LikelihoodMap> likelihoodMaps(std::size_t target, int reach) const override;

private:
  std::vector<std::unique_ptr<Tracker>> trackers_;
  std::vector<TargetEstimate> estimates_;
};

} // namespace dewpoint::tracking
