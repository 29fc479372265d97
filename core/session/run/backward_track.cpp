// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run/backward_track.h"

#include "core/session/run/frame_loop.h"
#include "core/session/run/reversed_frames.h"
#include "core/session/run/tracking_run.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace dewpoint::session {
namespace {

// Judgments.

/// Seconds for which the target may be unseen before the track has ended.
constexpr double kLostSeconds = 0.5;
/// Seconds for which it is where it was believed to be, until the track has ended: what was
/// believed before was right as well. It could be wrong once more before a shorter time.
constexpr double kAgreementSeconds = 10.0;
/// Frames in a row: fewer in which it was believed elsewhere, or there, are chance.
constexpr int kConsecutiveFrames = 5;
/// Standard deviations of both together up to which two positions are the same.
constexpr double kSamePosition = 4.0;
/// Seconds between the corrections that are made of it: a target that is lost again on the way is
/// found again half a second later.
constexpr double kSpacingSeconds = 0.5;
/// Added along each axis, m²: a tenth of a millimeter, so that a covariance can be inverted.
constexpr double kLeastVariance = 1e-8;

/// What was believed, by frame.
class EstimatedPositions {
public:
  EstimatedPositions(const std::vector<TrajectorySample>& samples, const std::string& target) {
    for (const TrajectorySample& sample : samples) {
      if (sample.target == target && sample.isValid) {
        positions_[sample.frame] = {sample.position, sample.covariance};
      }
    }
  }
  /// Null where nothing was.
  const Gaussian3* at(std::int64_t frame) const {
    const auto found = positions_.find(frame);
    return found == positions_.end() ? nullptr : &found->second;
  }
  /// Whether a position is the one that was believed in a frame.
  bool agrees(std::int64_t frame, const Gaussian3& position) const {
    const Gaussian3* const there = at(frame);
    if (there == nullptr) {
      return false;
    }
    const Eigen::Vector3d apart = there->mean - position.mean;
    const Eigen::Matrix3d covariance = there->covariance + position.covariance;
    return apart.dot(covariance.ldlt().solve(apart)) <= kSamePosition * kSamePosition;
  }

private:
  std::map<std::int64_t, Gaussian3> positions_;
};

/// The run's definition with the correction, and what was believed of other targets there, as the
/// only ones.
RunDefinitionPtr definitionFrom(const BackwardRequest& order) {
  auto definition = std::make_shared<RunDefinition>(order.definition);
  definition->personCorrections.clear();
  definition->corrections = {order.startCorrection};
  for (std::size_t k = 0; k < definition->targets.size(); ++k) {
    for (const TrajectorySample& sample : order.estimates) {
      if (static_cast<int>(k) != order.startCorrection.target &&
          sample.frame == order.startCorrection.frame && sample.isValid &&
          sample.target == definition->targets[k].name) {
        definition->corrections.push_back({.frame = order.startCorrection.frame,
                                           .target = static_cast<int>(k),
                                           .position = sample.position,
                                           .covariance = sample.covariance});
      }
    }
  }
  return definition;
}

bool isCorrectedAt(const BackwardRequest& order, std::int64_t frame) {
  return std::ranges::any_of(order.definition.corrections, [&](const PositionCorrection& one) {
    return one.frame == frame && one.target == order.startCorrection.target && !one.trackedFrom;
  });
}

/// Where the target was in a frame, and whether that was believed.
struct BackwardPosition {
  std::int64_t frame = 0;
  Gaussian3 position;
  bool wasBelieved = false;
};

/// From the last frame to the first.
struct BackwardPositions {
  std::vector<BackwardPosition> held;
  double frameSeconds = 0.0; ///< from one to the next, on average
};

/// Follows the target from the correction back.
class BackwardFollower final : public FrameObserver {
public:
  explicit BackwardFollower(const BackwardRequest& order)
      : at_(order.startCorrection.frame),
        target_(static_cast<std::size_t>(order.startCorrection.target)),
        believed_(order.estimates, order.definition.targets[target_].name),
        common_(order.startCorrection.position) {}

  Status onFrameTracked(const TrackingRun& run) override {
    begin_ = begin_.value_or(run.frames()->time);
    const double before = seconds(run.frames()->time - *begin_); // the correction
    const std::int64_t frame = 2 * at_ - run.frames()->index;
    const TrackEstimate estimate = run.estimate(target_);
    const auto position = positionOf(estimate);
    const bool isHeldThere = isConfirmed(estimate) && position.has_value();
    lastHeld_ = isHeldThere ? before : lastHeld_;
    hasEnded_ = before - lastHeld_ > kLostSeconds;
    if (!hasEnded_ && isHeldThere && frame != at_) { // at that frame it was said where it is
      compare(frame, before, *position);
    }
    return {};
  }

  /// Whether the frames before tell no more.
  bool hasEnded() const { return hasEnded_; }
  BackwardPositions take() && { return std::move(found_); }

private:
  void compare(std::int64_t frame, double before, const Gaussian3& position) {
    const bool agrees = believed_.agrees(frame, position);
    const Gaussian3* const there = believed_.at(frame);
    if (!agrees && hasCommon_ && there != nullptr &&
        (there->mean - common_).norm() < (position.mean - common_).norm()) {
      hasEnded_ = true;
      return;
    }
    common_ = position.mean;
    hasCommon_ = agrees;
    found_.held.push_back({frame, position, agrees});
    found_.frameSeconds = before / static_cast<double>(at_ - frame);
    lastWrong_ = agrees ? lastWrong_ : before;
    hasEnded_ = before - lastWrong_ > kAgreementSeconds;
  }

  std::int64_t at_;
  std::size_t target_;
  EstimatedPositions believed_;
  BackwardPositions found_;
  std::optional<TimeStamp> begin_;
  double lastHeld_ = 0.0;  ///< seconds before the correction
  double lastWrong_ = 0.0; ///< the same
  /// Where both have it: where they part, the one that stays nearer to this has not jumped.
  Eigen::Vector3d common_;
  bool hasCommon_ = true;
  bool hasEnded_ = false;
};

Result<BackwardPositions> positionsBefore(FrameSetSource& source, const BackwardRequest& order,
                                          int threads, const BackwardProgress& progress) {
  auto run = TrackingRun::create(definitionFrom(order), threads);
  if (!run) {
    return tl::make_unexpected(run.error());
  }
  const auto target = static_cast<std::size_t>(order.startCorrection.target);
  if (!run->supportsCorrections<PositionCorrecting>() ||
      target >= order.definition.targets.size()) {
    return BackwardPositions();
  }
  const std::int64_t at = order.startCorrection.frame;
  BackwardFollower follower(order);
  ReversedFrames reversed(source, at);
  const std::array<FrameObserver*, 1> observers{&follower};
  bool wanted = true;
  const auto shouldContinue = [&] {
    const std::int64_t frame = reversed.nextFrame();
    if (follower.hasEnded() || frame < 0 || (frame < at && isCorrectedAt(order, frame))) {
      return false;
    }
    wanted = progress(static_cast<double>(at - frame) / static_cast<double>(at + 1));
    return wanted;
  };
  const auto tracked = trackFrames(reversed, {}, *run, observers, shouldContinue);
  if (!tracked) {
    return tl::make_unexpected(tracked.error());
  }
  if (!wanted) {
    return failure(ErrorCode::Canceled, "", "", "");
  }
  return std::move(follower).take();
}

/// Makes of single frames what those around them are; not of those at the beginning of the track.
void smooth(std::vector<BackwardPosition>& positions) {
  for (const bool kind : {true, false}) {
    for (auto begin = positions.begin(); begin != positions.end();) {
      const auto end = std::find_if(begin, positions.end(), [&](const BackwardPosition& one) {
        return one.wasBelieved != begin->wasBelieved;
      });
      // Agreement in passing first: then what is left of disagreement is as long as it is.
      if (begin->wasBelieved == kind && end - begin < kConsecutiveFrames &&
          end != positions.end()) {
        std::for_each(begin, end, [&](BackwardPosition& one) { one.wasBelieved = !kind; });
      }
      begin = end;
    }
  }
}

std::vector<PositionCorrection> correctionsFrom(BackwardPositions positions,
                                                const PositionCorrection& from) {
  smooth(positions.held);
  const auto spacing = static_cast<std::int64_t>(
      std::max(1.0, kSpacingSeconds / std::max(1e-6, positions.frameSeconds)));
  std::vector<PositionCorrection> corrections;
  std::optional<std::int64_t> last;
  for (auto one = positions.held.rbegin(); one != positions.held.rend(); ++one) {
    if (one->wasBelieved) {
      last.reset(); // where it is believed elsewhere next, the first frame counts
      continue;
    }
    if (last && one->frame < *last + spacing) {
      continue;
    }
    last = one->frame;
    const Eigen::Matrix3d& covariance = one->position.covariance;
    corrections.push_back({.frame = one->frame,
                           .target = from.target,
                           .position = one->position.mean,
                           .covariance = 0.5 * (covariance + covariance.transpose()) +
                                         kLeastVariance * Eigen::Matrix3d::Identity(),
                           .clicks = {},
                           .trackedFrom = from.frame});
  }
  return corrections;
}

/// What a run believes in each of the frames up to one.
Result<std::vector<TrajectorySample>> estimatesUpTo(FrameSetSource& source,
                                                    const RunDefinition& definition,
                                                    std::int64_t last, int threads,
                                                    const BackwardProgress& progress) {
  class Samples final : public FrameObserver {
  public:
    std::vector<TrajectorySample> all;
    Status onFrameTracked(const TrackingRun& run) override {
      const auto samples = run.samples();
      all.insert(all.end(), samples.begin(), samples.end());
      return {};
    }
  };
  auto run = TrackingRun::create(std::make_shared<const RunDefinition>(definition), threads);
  if (!run) {
    return tl::make_unexpected(run.error());
  }
  if (const auto sought = source.seek(0); !sought) {
    return tl::make_unexpected(sought.error());
  }
  Samples samples;
  const std::array<FrameObserver*, 1> observers{&samples};
  std::int64_t done = 0;
  bool wanted = true;
  const auto shouldContinue = [&] {
    wanted = progress(static_cast<double>(done++) / static_cast<double>(last + 1));
    return wanted;
  };
  const auto tracked = trackFrames(source, {0, last + 1}, *run, observers, shouldContinue);
  if (!tracked) {
    return tl::make_unexpected(tracked.error());
  }
  if (!wanted) {
    return failure(ErrorCode::Canceled, "", "", "");
  }
  return std::move(samples.all);
}

} // namespace

Result<std::vector<PositionCorrection>> trackBackwards(FrameSetSource& source,
                                                       const BackwardRequest& order, int threads,
                                                       const BackwardProgress& progress) {
  if (source.isLive()) {
    return std::vector<PositionCorrection>();
  }
  return positionsBefore(source, order, threads, progress).map([&](BackwardPositions positions) {
    return correctionsFrom(std::move(positions), order.startCorrection);
  });
}

Result<Project> withBackwardCorrections(const Project& project, FrameSetSource& source,
                                        const std::vector<cv::Mat>& backgroundImages, int threads,
                                        const BackwardProgress& progress) {
  Project result = project;
  std::erase_if(result.corrections,
                [](const PositionCorrection& one) { return one.trackedFrom.has_value(); });
  const std::vector<PositionCorrection> said = result.corrections;
  for (std::size_t k = 0; k < said.size(); ++k) {
    const auto part = [&](double from, double share) {
      return [&progress, &said, k, from, share](double done) {
        return progress((static_cast<double>(k) + from + share * done) /
                        static_cast<double>(said.size()));
      };
    };
    const RunDefinition definition = RunDefinition::fromProject(result, backgroundImages);
    auto believed = estimatesUpTo(source, definition, said[k].frame, threads, part(0.0, 0.5));
    if (!believed) {
      return tl::make_unexpected(believed.error());
    }
    const auto found = trackBackwards(source, {definition, said[k], std::move(*believed)}, threads,
                                      part(0.5, 0.5));
    if (!found) {
      return tl::make_unexpected(found.error());
    }
    for (const PositionCorrection& one : *found) {
      addCorrection(result, one);
    }
  }
  return result;
}

} // namespace dewpoint::session
