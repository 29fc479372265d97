// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/dewpoint/clock_estimator.h"
#include "core/tracking/dewpoint/distractor_search.h"
#include "core/tracking/dewpoint/frame_images.h"
#include "core/tracking/dewpoint/search/candidate_search.h"
#include "core/tracking/dewpoint/search/time_budget.h"
#include "core/tracking/dewpoint/tracked_objects.h"
#include "core/tracking/tracker_capabilities.h"

#include <memory>
#include <optional>
#include <vector>

namespace dewpoint::tracking {

/// The `dewpoint` method, developed for this project. Every target is detected by its outline in
/// all cameras, as a sphere of one color (docs/method-dewpoint.md). Targets of the same color are
/// distinguished by their former positions, and no two targets can be at one position.
class DewpointTracker final : public Tracker,
                              public Configurable,
                              public TargetTracking,
                              public FixedTargetCount,
                              public RigConfigurable,
                              public VolumeBounded,
                              public PositionCorrecting,
                              public BackgroundImageConfigurable,
                              public ParticleCloud,
                              public CameraReporting,
                              public ClockEstimating,
                              public CandidateReporting,
                              public LikelihoodMapping,
                              public Copyable {
public:
  /// Creates a tracker. `parameters` must be declared by dewpointParameters().
  DewpointTracker(const ParameterValues& parameters, const CameraRig& rig,
                  const std::vector<Target>& targets);
  DewpointTracker& operator=(const DewpointTracker&) = delete;
  ~DewpointTracker() override = default;

  /// Sets the parameters. The start volume takes effect at the next restart, everything else at the
  /// next iteration.
  void configure(const ParameterValues& parameters) override;
  void setTargets(const std::vector<Target>& targets) override;
  std::size_t targetCount() const override { return objects_.targetCount(); }
  void setCameras(const CameraRig& rig) override;
  /// Limits the positions of targets to a volume. Distractors are tracked everywhere, because
  /// pixels that show a distractor must not count as evidence for a target inside the volume.
  void setVolumeOfInterest(const std::optional<WorldBox>& volume) override;
  void correctPosition(std::size_t target, const Gaussian3& position, ThreadTeam& team) override;
  void setBackgroundImages(const std::vector<cv::Mat>& images) override;
  void restart(std::uint64_t seed) override;
  int iterationsPerFrame() const override;
  void beginFrame(FrameSetPtr frames) override;
  void iterate(ThreadTeam& team) override;
  std::size_t trackCount() const override { return estimates_.size(); }
  TrackEstimate estimate(std::size_t track) const override { return estimates_.at(track); }
  void copyParticles(std::size_t target, int limit, Eigen::ArrayXXd& positions,
                     Eigen::ArrayXd& weights) const override;
  bool canBeCopied() const override { return true; }
  std::unique_ptr<Tracker> clone() const override;
  std::size_t memoryBytes() const override;
  std::vector<CameraReport> cameraReports(std::size_t target) const override;
  std::vector<ClockEstimate> clockEstimates() const override { return clocks_.estimates(); }
  std::vector<CandidatePosition> positionCandidates(std::size_t target) const override;
  std::vector<LikelihoodMap> likelihoodMaps(std::size_t target, int reach) const override;

private:
  DewpointTracker(const DewpointTracker&) = default;

  BernoulliTrackSettings trackSettings() const;
  double secondsSinceLastFrame() const;
  void predictTracks();
  /// Adapts the colors of targets that are not tracked to the current light.
  void extendColorsToLight();
  void searchDistractors(ThreadTeam& team);
  void updateEstimates();
  void updateEstimate(std::size_t target);
  void learnClocks();
  void adaptTargetColors();
  void learnBackgrounds();

  ParameterValues parameters_;
  TrackedObjects objects_;
  FrameImages images_;
  ClockEstimator clocks_;
  CandidateSearch search_;
  DistractorSearch distractors_;
  TimeBudget budget_;
  std::optional<TimeStamp> lastTime_; ///< time of the last tracked frame
  RandomKey key_;
  std::vector<SphereEstimate> estimates_; ///< one per target
};

} // namespace dewpoint::tracking
