// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/background_model.h"
#include "core/tracking/multi_tracker.h"
#include "core/tracking/target_belief.h"

#include <optional>
#include <vector>

namespace dewpoint {

/// The project's own method: every target is a sphere of one color, known by its outline in all
/// cameras (docs/method-dewpoint.md). Targets of one color are told apart by where they were, and
/// none may be where another is.
class DewpointTracker final : public MultiTracker {
public:
  /// `parameters` are methodParameters("dewpoint").
  DewpointTracker(const ParameterValues& parameters, const CameraRig& rig,
                  const std::vector<Target>& targets);

  /// The start acts at the next restart, everything else at the next iteration.
  void configure(const ParameterValues& parameters) override;
  void setTargets(const std::vector<Target>& targets) override;
  void restart(std::uint64_t seed) override;
  int iterationsPerFrame() const override;
  void beginFrame(FrameSetPtr frames) override;
  void iterate(ThreadTeam& team) override;
  const std::vector<TargetEstimate>& estimates() const override { return estimates_; }
  void particles(std::size_t target, int limit, Eigen::ArrayXXd& positions,
                 Eigen::ArrayXd& weights) const override;

private:
  struct Tracked {
    TargetBelief belief;
    SphereObservation observation;
    ColorClassifier classifier;
  };

  BeliefSettings settings() const;
  double secondsSinceLastFrame() const;
  void showImages(Tracked& tracked);
  void explainOthers(std::size_t index);
  std::vector<OccupiedSphere> occupiedByOthers(std::size_t index) const;
  std::vector<std::size_t> surestFirst() const;
  void resolveConflicts();
  void learnBackgrounds();
  void keepToBudget(double milliseconds);
  RandomKey keyOf(std::size_t index) const;

  ParameterValues parameters_;
  std::vector<Tracked> tracked_;
  std::vector<BackgroundModel> backgrounds_;
  CandidateSearch search_;
  FrameSetPtr frames_;
  std::optional<TimeStamp> lastTime_;
  RandomKey key_;
  std::vector<TargetEstimate> estimates_;
  double affordableParticles_ = 0.0; ///< by the time budget; 0: no limit
};

} // namespace dewpoint
