// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/background/background_model.h"
#include "core/observation/sphere/adaptive_color.h"
#include "core/tracking/dewpoint/bernoulli_track.h"
#include "core/tracking/dewpoint/sliced_search.h"
#include "core/tracking/dewpoint/time_budget.h"
#include "core/tracking/tracker_capabilities.h"

#include <memory>
#include <optional>
#include <vector>

namespace dewpoint::tracking {

/// The project's own method: every target is a sphere of one color, known by its outline in all
/// cameras (docs/method-dewpoint.md). Targets of one color are told apart by where they were, and
/// none may be where another is.
class DewpointTracker final : public Tracker,
                              public TargetFollowing,
                              public CameraCalibrated,
                              public BackgroundImages,
                              public ParticleCloud,
                              public CameraExplaining,
                              public PositionProposing,
                              public LikelihoodMapping,
                              public Copying {
public:
  /// `parameters` are dewpointParameters().
  DewpointTracker(const ParameterValues& parameters, const CameraRig& rig,
                  const std::vector<Target>& targets);

  /// The start acts at the next restart, everything else at the next iteration.
  void configure(const ParameterValues& parameters) override;
  void setTargets(const std::vector<Target>& targets) override;
  bool takesAnyNumber() const override { return false; }
  void setCameras(const CameraRig& rig) override;
  void setEmptyRooms(const std::vector<cv::Mat>& rooms) override;
  void restart(std::uint64_t seed) override;
  int iterationsPerFrame() const override;
  void beginFrame(FrameSetPtr frames) override;
  void iterate(ThreadTeam& team) override;
  std::size_t trackCount() const override { return estimates_.size(); }
  TrackEstimate estimate(std::size_t track) const override { return estimates_.at(track); }
  void particles(std::size_t target, int limit, Eigen::ArrayXXd& positions,
                 Eigen::ArrayXd& weights) const override;
  bool canBeCopied() const override { return true; }
  std::unique_ptr<Tracker> clone() const override;
  std::size_t memoryBytes() const override;
  std::vector<CameraReport> explain(std::size_t target) const override;
  std::vector<CandidatePosition> proposals(std::size_t target) const override;
  std::vector<LikelihoodMap> likelihoodMaps(std::size_t target, int reach) const override;

private:
  /// A target, or a thing that looks like one.
  struct Tracked {
    BernoulliTrack belief;
    SphereObservation observation;
    AdaptiveColor color;
    std::unique_ptr<SlicedSearch> search; ///< within a time budget, while it goes on
  };
  /// Share of a target's outline in its color where nothing covers it.
  static constexpr double kWholeShare = 0.85;

  /// A copy; its labels are made anew when they are needed.
  DewpointTracker(const DewpointTracker& other);

  BernoulliTrackSettings settings() const;
  double secondsSinceLastFrame() const;
  /// Null when there is none.
  FramePtr frameOf(std::size_t camera) const;
  /// Seconds by which a camera looked after the common instant.
  double timeOffsetOf(std::size_t camera) const;
  void showImages(SphereObservation& observation, const AdaptiveColor& color);
  CameraReport explain(std::size_t target, std::size_t camera,
                       const std::optional<OccupiedSphere>& expected) const;
  std::optional<double> gapToLookAlike(std::size_t target, std::size_t camera,
                                       const SphereImage& outline) const;
  /// Marks what belongs to others than `own`.
  void explainOthers(SphereObservation& observation, const Tracked& own);
  void updateBelief(std::size_t index, ThreadTeam& team);
  std::vector<OccupiedSphere> occupiedByOthers(std::size_t index) const;
  std::vector<std::size_t> surestFirst() const;
  /// A look-alike that came to lie on a target that is plainly there was the target itself.
  void yieldToTargets(Tracked& lookAlike);
  void resolveConflicts();
  /// Things of a target's looks that are none are tracked as well, while all targets are well seen:
  /// then none of them can be taken for a target when one hides the other.
  void watchLookAlikes(ThreadTeam& team);
  void forgetLostLookAlikes();
  bool allTargetsSure() const;
  /// Whether another target has the same looks.
  bool hasTwins(std::size_t target) const;
  bool isFirstOfItsColor(std::size_t target) const;
  /// Of the looks of a target.
  Tracked thingLike(std::size_t target) const;
  bool isNewLookAlike(const Candidate& candidate, SphereObservation& observation,
                      double logLikelihoodRatio) const;
  void addLookAlike(Tracked thing, const Candidate& place, ThreadTeam& team);
  void findLookAlikes(std::size_t target, ThreadTeam& team);
  /// Within a time budget searches go on for several frames, on the images they began with.
  std::unique_ptr<SlicedSearch> beginSearch(const Tracked& own);
  /// The places when the search is done, which it then is no more; until then none.
  std::vector<Candidate> goOn(std::unique_ptr<SlicedSearch>& search, std::size_t limit,
                              bool urgent);
  void lookAroundInSlices(ThreadTeam& team);
  /// Before the labels of a frame: the backgrounds in the light of now.
  void followLight();
  void learnBackgrounds();
  /// Parameter `color_adaptation`: the colors of targets that are surely there follow the light.
  void followColors();
  void followColor(std::size_t target, double share);
  bool isSurelyThere(std::size_t target) const;
  /// Whether a camera shows a target whole and alone, whose outline there is `outline`.
  bool showsWhole(std::size_t target, std::size_t camera, const SphereImage& outline) const;
  /// Outlines of the other things, or of those of one color only.
  std::vector<SphereImage> outlinesOfOthers(std::size_t target, std::size_t camera,
                                            bool sameColor) const;
  RandomKey keyOf(std::size_t index) const;

  ParameterValues parameters_;
  CameraRig rig_;
  std::vector<Tracked> tracked_; ///< the targets first, then look-alikes
  std::size_t targetCount_ = 0;
  std::int64_t frameCount_ = 0;        ///< since the restart
  std::uint32_t nextLookAlike_ = 0;    ///< sets their random numbers apart
  std::vector<std::uint32_t> streams_; ///< one per tracked thing
  std::vector<BackgroundModel> backgrounds_;
  CandidateSearch search_;
  FrameSetPtr frames_;
  std::optional<TimeStamp> lastTime_;
  RandomKey key_;
  std::vector<SphereEstimate> estimates_;
  TimeBudget budget_;
  std::unique_ptr<SlicedSearch> lookAround_;
  std::size_t lookAroundFor_ = 0;   ///< the target it looks for the likes of
  std::int64_t nextLookAround_ = 0; ///< not before this frame
};

} // namespace dewpoint::tracking
