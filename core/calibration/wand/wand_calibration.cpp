// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/wand/wand_calibration.h"

#include "core/base/random.h"
#include "core/calibration/bundle/bundle_cost.h"
#include "core/calibration/wand/time_offset_search.h"
#include "core/calibration/wand/wand_bundle.h"
#include "core/calibration/wand/wand_gauge.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

namespace dewpoint::calibration {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
constexpr int kInstantsOfStart = 120; ///< a start is judged on so many
constexpr double kLooseStick = 0.02;  ///< meters: while the cameras are still far off
constexpr double kTightStick = 2e-4;  ///< meters
/// Of the solver, for each start and width of the loss.
constexpr int kStartIterations = 40;
/// Rounds of dropping views.
constexpr int kMostWandRounds = 10;
constexpr double kLeastLimitPx = 1.5; ///< views nearer than this to the solution are never dropped
constexpr double kLimitMedians = 5.0; ///< and none nearer than so many median residuals
constexpr double kGoodStart = 0.02;   ///< starts whose medians differ by less agree

/// Widths of the loss in pixels, for the starts and for the whole: from far to near.
constexpr std::array<double, 3> kStartWidths{30.0, 8.0, 3.0};

/// Of an adjustment that fails as a whole: what a person can do about it.
Error withAdvice(Error error) {
  if (error.code == ErrorCode::Undetermined && error.field.empty()) {
    error.detail += "; wave through more of the volume, or calibrate fewer values at once";
  }
  return error;
}

/// One calibration on its way.
class WandSolver {
public:
  WandSolver(WandProblem problem, const WandCallback& callback)
      : given_(std::move(problem)), callback_(callback) {
    steps_ = given_.startCount * int(kStartWidths.size()) + kMostWandRounds;
  }

  Result<WandResult> run() {
    const auto begin = std::chrono::steady_clock::now();
    auto done = inTime()
                    .and_then([&] { return makeWandBundle(given_); })
                    .and_then([&](BundleProblem bundle) { return bestStart(std::move(bundle)); })
                    .and_then([&](BundleProblem bundle) { return narrow(std::move(bundle)); })
                    .and_then([&] { return intoWorld(); });
    if (!done) {
      return tl::make_unexpected(done.error());
    }
    summarize();
    result_.computationSeconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return std::move(result_);
  }

private:
  /// From far off the adjustment would not find the offsets: first roughly.
  Status inTime() {
    if (given_.estimatesTimeOffsets) {
      if (auto usable = checkViews(given_); !usable) {
        return usable;
      }
      clocks_ = searchTimeOffsets(given_);
      given_.views = shiftedInTime(std::move(given_.views), clocks_);
    }
    return {};
  }

  /// One adjustment, its progress passed on.
  Result<BundleResult> adjust(const BundleProblem& bundle) {
    const auto outcome = adjustBundle(bundle, [&](const BundleProgress& now) {
      return !callback_ || callback_({step_, steps_, now.rmsPx});
    });
    ++step_;
    return outcome;
  }

  void setStick(BundleProblem& bundle, double sigma) const {
    bundle.bodies.front().lengthSigma = sigma;
  }

  /// The initial cameras, each off by up to what they may be off; start 0 as they are.
  CameraRig startRig(int start) const {
    CameraRig rig = given_.initialRig;
    if (start == 0) {
      return rig;
    }
    const RandomStream random(given_.seed, std::uint32_t(start), 0, RandomPurpose::Start);
    for (std::size_t c = 0; c < rig.size(); ++c) {
      const auto turn = random.normal4(std::uint32_t(c));
      const auto place = random.normal4(std::uint32_t(c), 1);
      const double share = 1.0 / std::sqrt(3.0); // so that the length is about what was asked for
      const Eigen::Vector3d center =
          rig[c].center() +
          share * given_.initialPositionError * Eigen::Vector3d(place[0], place[1], place[2]);
      auto& pose = rig[c].cameraFromWorld;
      pose.linear() = rotationExponential(share * given_.initialRotationError *
                                          Eigen::Vector3d(turn[0], turn[1], turn[2])) *
                      pose.linear();
      pose.translation() = -pose.linear() * center;
    }
    return rig;
  }

  /// Poses only, on a part of the views, the loss narrowed step by step.
  Result<BundleResult> solveStart(BundleProblem bundle, int start) {
    const CameraRig rig = startRig(start);
    Result<BundleResult> now =
        failure(ErrorCode::Undetermined, "", "", "no initial guess led to a solution");
    for (std::size_t c = 0; c < rig.size(); ++c) {
      bundle.cameras[c].camera = rig[c];
    }
    setStick(bundle, kLooseStick);
    bundle.loss = RobustLoss::SoftL1;
    bundle.isDraft = true;
    bundle.maxIterations = kStartIterations;
    for (const double width : kStartWidths) {
      bundle.lossWidth = width;
      now = adjust(bundle);
      if (!now) {
        return now;
      }
      for (std::size_t c = 0; c < rig.size(); ++c) {
        bundle.cameras[c].camera = now->cameras[c];
      }
      updateOutlineShifts(given_.ballRadii, *now, bundle);
    }
    return now;
  }

  /// What the starts are judged on: instants from all over the path. Too far apart to be followed
  /// in time, they are taken as simultaneous; the loss bears what free cameras are off by that.
  static BundleProblem forStarts(const BundleProblem& bundle) {
    BundleProblem part = subsampledBundle(bundle, kInstantsOfStart, false);
    for (BundleObservation& seen : part.observations) {
      seen.timeAfterState = 0.0;
    }
    return part;
  }

  Result<BundleProblem> bestStart(BundleProblem bundle) {
    const BundleProblem part = forStarts(bundle);
    std::optional<BundleResult> best;
    double bestMedian = 0.0;
    Error why;
    for (int start = 0; start < given_.startCount; ++start) {
      auto now = solveStart(part, start);
      if (!now && now.error().code == ErrorCode::Canceled) {
        return tl::make_unexpected(now.error());
      }
      WandStart report{now.has_value(), now ? medianResidual(part, *now) : 0.0};
      result_.starts.push_back(report);
      if (!now) {
        why = start == 0 ? now.error() : why;
        continue;
      }
      // Few views used is no good fit either: what cannot be triangulated has no residual.
      const double median = report.medianResidualPx * double(part.observations.size()) /
                            double(std::max<std::size_t>(now->usedObservationCount, 1));
      const bool agrees = best && std::abs(median - bestMedian) < kGoodStart * bestMedian;
      if (!best || median < bestMedian) {
        best = std::move(*now);
        bestMedian = median;
      }
      if (agrees) {
        break; // found twice from different places
      }
    }
    if (!best) {
      return tl::make_unexpected(why);
    }
    for (std::size_t c = 0; c < bundle.cameras.size(); ++c) {
      bundle.cameras[c].camera = best->cameras[c];
    }
    return bundle;
  }

  void freeRequested(BundleProblem& bundle) const {
    for (std::size_t c = 0; c < bundle.cameras.size(); ++c) {
      BundleCamera& camera = bundle.cameras[c];
      camera.isTimeOffsetFree = given_.estimatesTimeOffsets && c > 0;
      camera.isFocalFree = given_.estimatesFocalLengths;
      camera.isDistortionFree[0] = given_.estimatesDistortion;
    }
  }

  bool followsInTime(const BundleProblem& bundle) const {
    return given_.estimatesTimeOffsets ||
           std::any_of(bundle.observations.begin(), bundle.observations.end(),
                       [](const BundleObservation& seen) { return seen.timeAfterState != 0.0; });
  }

  /// Everything that is asked for, on all views; gross errors are dropped round after round.
  Status narrow(BundleProblem bundle) {
    const bool inTime = followsInTime(bundle); // then an instant costs far more
    bundle = subsampledBundle(bundle, given_.maxInstants / (inTime ? 2 : 1), inTime);
    freeRequested(bundle);
    setStick(bundle, kTightStick);
    result_.droppedViewCounts.assign(bundle.cameras.size(), 0);
    bundle.loss = RobustLoss::SoftL1;
    bundle.lossWidth = 3.0;
    bundle.isDraft = true;
    for (int round = 0; round < kMostWandRounds; ++round) {
      auto now = adjust(bundle);
      if (!now) {
        return tl::make_unexpected(withAdvice(now.error()));
      }
      const double median = medianResidual(bundle, *now);
      const double limit = std::max(kLeastLimitPx, kLimitMedians * median);
      bundle.lossWidth = std::clamp(3.0 * median, 0.5, 3.0);
      result_.problem = bundle;
      result_.bundle = std::move(*now);
      if (!bundle.isDraft) {
        break;
      }
      const bool clean =
          dropWorstObservations(result_.bundle, limit, bundle, result_.droppedViewCounts) == 0;
      for (std::size_t c = 0; c < bundle.cameras.size(); ++c) {
        bundle.cameras[c].camera = result_.bundle.cameras[c];
        bundle.cameras[c].timeOffset = result_.bundle.timeOffsets[c];
      }
      updateOutlineShifts(given_.ballRadii, result_.bundle, bundle);
      bundle.isDraft = !(clean && round > 0) && round + 2 < kMostWandRounds;
    }
    return {};
  }

  /// Size, then the initial rig's world or what floor and fall say.
  Status intoWorld() {
    const bool sized = given_.scaleMethod == WandScale::InitialRig && given_.stickLength <= 0.0;
    const Similarity back = fitRigSimilarity(result_.bundle.cameras, given_.initialRig, sized);
    moveWorld(back, result_.bundle);
    const auto scale = estimateScale(given_, result_.problem, result_.bundle);
    if (!scale) {
      return tl::make_unexpected(scale.error());
    }
    Similarity larger;
    larger.scale = scale->scaleFactor;
    moveWorld(larger, result_.bundle);
    if (!sized) { // the size is right now: place it where the initial rig was
      moveWorld(fitRigSimilarity(result_.bundle.cameras, given_.initialRig, false), result_.bundle);
    }
    result_.scaleMethod = given_.stickLength > 0.0 ? WandScale::Stick : given_.scaleMethod;
    result_.scaleFactor =
        1.0 / fitRigSimilarity(result_.bundle.cameras, given_.initialRig, true).scale;
    result_.scaleSigma = scale->relativeSigma;
    return changeToUprightWorld(given_, result_.bundle, result_)
        .map([&](const Similarity& upright) {
          moveWorld(upright, result_.bundle);
          for (std::size_t c = 0; c < result_.problem.cameras.size(); ++c) {
            result_.problem.cameras[c].camera = result_.bundle.cameras[c];
            result_.problem.cameras[c].timeOffset = result_.bundle.timeOffsets[c];
          }
        });
  }

  void summarize() {
    result_.cameras = result_.bundle.cameras;
    result_.timeOffsets = result_.bundle.timeOffsets;
    for (std::size_t c = 0; c < clocks_.size(); ++c) {
      result_.timeOffsets[c] += clocks_[c];
    }
    result_.medianResidualPx = medianResidual(result_.problem, result_.bundle);
    result_.usedViewCounts.assign(result_.cameras.size(), 0);
    for (std::size_t i = 0; i < result_.problem.observations.size(); ++i) {
      if (std::isfinite(result_.bundle.residuals[i].norm())) {
        ++result_.usedViewCounts[result_.problem.observations[i].camera];
      }
    }
    for (std::size_t c = 0; c < result_.cameras.size(); ++c) {
      result_.cameraMedianResidualPx.push_back(
          medianResidual(result_.problem, result_.bundle, static_cast<int>(c)));
    }
  }

  WandProblem given_;          ///< its views put together by the clocks, as far as these are known
  std::vector<double> clocks_; ///< seconds that were added to the views' times for that
  const WandCallback& callback_;
  WandResult result_;
  int step_ = 0;
  int steps_ = 0;
};

} // namespace

Result<WandResult> calibrateFromWand(const WandProblem& problem, const WandCallback& callback) {
  return WandSolver(problem, callback).run();
}

} // namespace dewpoint::calibration
