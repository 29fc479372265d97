// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/quality/fault_camera.h"

#include "core/base/statistics.h"
#include "core/geometry/image_symmetry.h"
#include "core/geometry/projector.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace dewpoint::calibration {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
/// Correspondences that a hypothesis is weighed on, at most, ...
constexpr std::size_t kMostCorrespondences = 150;
/// ... while time offsets are searched, ...
constexpr std::size_t kQuickCorrespondences = 40;
/// ... and at least.
constexpr std::size_t kFewestCorrespondences = 12;
/// Gain in log-likelihood per number measured, ...
constexpr double kLeastGainShare = 0.1;
/// ... and when the cameras run freely.
constexpr double kLeastGainShareUnsynchronized = 0.5;
constexpr double kWellExplained = 3.0; ///< residuals against those of the cameras that agree
constexpr double kLeastMove = 3.0;     ///< standard deviations of an image point
/// Most that meanCost() may be when two places explain a camera. Normal noise alone gives 0.49 (its
/// expectation); 2.0 is as if every residual were 2.2 standard deviations. A judgment, made with
/// the recording charuco4 at hand, whose cameras stood still: halves of its late camera cost 3.3
/// to 4.2.
constexpr double kMovedCost = 2.0;
/// Times the gain that two poses have for alternating parts of the recording.
constexpr double kOverChance = 2.0;
constexpr double kLeastZoom = 0.03;  ///< lenses are rarely known better when others calibrated
constexpr int kMaxDelayFrames = 120; ///< frames
/// Frames that a late camera is late by, at least.
constexpr int kMinDelayFrames = 2;
constexpr double kPositionNoise = 1.5; ///< noise of the positions adds to that of the image points
/// Ratios of the sizes of videos and lens data that occur.
constexpr std::array<double, 8> kResolutions{2.0, 0.5,       1.5,       2.0 / 3.0,
                                             3.0, 1.0 / 3.0, 4.0 / 3.0, 0.75};

/// How well a hypothesis explains the camera.
struct Explained {
  double cost = 0.0;   ///< mean, per number
  double median = 0.0; ///< pixels, per axis
};

class CameraSuspicion {
public:
  CameraSuspicion(const FaultSearchInput& input, const SuspectCamera& suspect)
      : input_(input), suspect_(suspect), initial_(input.problem.cameras[suspect.camera].camera),
        sigma_(kPositionNoise * std::max(suspect.sigmaPx, 1e-3)) {}

  std::optional<DetectedFault> run() {
    const auto correspondences = selectEvenly(known(0.0), kMostCorrespondences);
    const auto asIs = correspondences.size() < kFewestCorrespondences
                          ? std::nullopt
                          : explain(initial_, correspondences, false);
    if (!asIs) {
      return std::nullopt;
    }
    base_ = *asIs;
    numbers_ = 2.0 * static_cast<double>(correspondences.size());
    tryFlips(correspondences);
    tryResolutions(correspondences);
    tryZoom(correspondences);
    tryMoved(correspondences);
    if (base_.median > kWellExplained * sigma_) {
      tryDelay();
    }
    return best_;
  }

private:
  /// Looks of the camera at points the others place, as they were `shift` seconds before.
  std::vector<PointCorrespondence> known(double shift) const {
    std::vector<PointCorrespondence> correspondences;
    const auto& times = suspect_.imagePoints->times;
    for (const ImagePoint& seen : suspect_.imagePoints->pointsPerCamera[suspect_.camera]) {
      const auto instant =
          shift == 0.0 ? std::optional(seen.instant) : instantAt(times[seen.instant] - shift);
      if (!instant) {
        continue;
      }
      if (const auto& position = (*suspect_.positions)[*instant][seen.id]) {
        correspondences.push_back({*position, seen.pixel, times[seen.instant]});
      }
    }
    return correspondences;
  }

  std::optional<std::size_t> instantAt(double time) const {
    const auto after = byTime_.lower_bound(time - 0.3 * period_);
    return after != byTime_.end() && after->first < time + 0.3 * period_
               ? std::optional(after->second)
               : std::nullopt;
  }

  std::optional<Explained> explain(const Camera& initial,
                                   const std::vector<PointCorrespondence>& correspondences,
                                   bool isFocalFree, bool quick = false,
                                   Camera* found = nullptr) const {
    const auto one = fitCamera(initial, correspondences, input_.initialSigma, isFocalFree, quick);
    if (!one) {
      return std::nullopt;
    }
    if (found != nullptr) {
      *found = one->camera;
    }
    return Explained{meanCost(one->squaredResiduals, sigma_),
                     std::sqrt(upperMedian(one->squaredResiduals))};
  }

  /// Keeps the hypothesis if it is clearly better than none and than the best so far.
  void considerHypothesis(CalibrationFault fault, double value, const std::optional<Explained>& now,
                          double penalty) {
    if (!now) {
      return;
    }
    const double share = input_.isUnsynchronized ? kLeastGainShareUnsynchronized : kLeastGainShare;
    const double gain = numbers_ * (base_.cost - now->cost) - penalty;
    if (gain > std::max(kMinGain, share * numbers_) && now->median < kWellExplained * sigma_ &&
        (!best_ || gain > best_->logLikelihoodGain)) {
      best_ = DetectedFault{fault, {suspect_.camera}, value, gain};
    }
  }

  void tryFlips(const std::vector<PointCorrespondence>& correspondences) {
    const Intrinsics& in = initial_.intrinsics;
    for (const ImageSymmetry symmetry :
         {ImageSymmetry{0, true}, ImageSymmetry{180, false}, ImageSymmetry{180, true}}) {
      std::vector<PointCorrespondence> flipped = correspondences;
      for (PointCorrespondence& seen : flipped) {
        seen.pixel = transformed(symmetry, seen.pixel, in.width, in.height);
      }
      considerHypothesis(CalibrationFault::VideoFlipped, 0.0, explain(initial_, flipped, false),
                         1.0);
    }
  }

  void tryResolutions(const std::vector<PointCorrespondence>& correspondences) {
    for (const double ratio : kResolutions) {
      std::vector<PointCorrespondence> scaled = correspondences;
      for (PointCorrespondence& seen : scaled) { // edges of pixels scale, not centers
        seen.pixel = (seen.pixel.array() + 0.5) / ratio - 0.5;
      }
      auto now = explain(initial_, scaled, false);
      considerHypothesis(CalibrationFault::WrongResolution, ratio, now, 2.0);
    }
  }

  void tryZoom(const std::vector<PointCorrespondence>& correspondences) {
    if (input_.isFocalUnknown) {
      return;
    }
    for (const double start : {1.0, 0.7, 1.4}) { // far off, the pose's prior would hold it back
      Camera begin = initial_;
      begin.intrinsics.focalX *= start;
      begin.intrinsics.focalY *= start;
      Camera found;
      const auto now = explain(begin, correspondences, true, false, &found);
      const double ratio = now ? found.intrinsics.focalX / initial_.intrinsics.focalX : 1.0;
      if (std::abs(std::log(ratio)) > kLeastZoom) {
        considerHypothesis(CalibrationFault::ZoomChanged, ratio, now, 0.5 * std::log(numbers_));
      }
    }
  }

  /// Another place from some time on.
  void tryMoved(const std::vector<PointCorrespondence>& correspondences) {
    std::optional<double> byChance; // found only when it is needed
    for (int tenth = 2; tenth <= 8; ++tenth) {
      const std::size_t split = correspondences.size() * static_cast<std::size_t>(tenth) / 10;
      const auto two = twoPoses(
          correspondences, [&](std::size_t index) { return index >= split; }, widenedSigma());
      if (!two || movedBy(two->first, two->second, correspondences) < kLeastMove * sigma_ ||
          two->explained.cost > kMovedCost) {
        continue; // two places explain it a little better, as two of anything would
      }
      if (!byChance) {
        byChance = gainByChance(correspondences);
      }
      if (numbers_ * (base_.cost - two->explained.cost) > kOverChance * *byChance) {
        considerHypothesis(CalibrationFault::CameraMoved, correspondences[split].time,
                           two->explained, 3.5 * std::log(numbers_));
      }
    }
  }

  /// Two poses of the camera, and how well they explain its images.
  struct TwoPoses {
    Camera first, second;
    Explained explained;
  };

  template <typename IsSecond>
  std::optional<TwoPoses> twoPoses(const std::vector<PointCorrespondence>& correspondences,
                                   IsSecond isSecond, const InitialRigSigma& sigma) const {
    std::array<std::vector<PointCorrespondence>, 2> parts;
    for (std::size_t i = 0; i < correspondences.size(); ++i) {
      parts.at(isSecond(i) ? 1 : 0).push_back(correspondences[i]);
    }
    const auto first = fitCamera(initial_, parts[0], sigma, false);
    const auto second = fitCamera(initial_, parts[1], sigma, false);
    if (!first || !second) {
      return std::nullopt;
    }
    std::vector<double> squares = first->squaredResiduals;
    squares.insert(squares.end(), second->squaredResiduals.begin(), second->squaredResiduals.end());
    return TwoPoses{first->camera,
                    second->camera,
                    {meanCost(squares, sigma_), std::sqrt(upperMedian(squares))}};
  }

  /// Most that two poses gain where they cannot be right: for parts of the recording that
  /// alternate. A lens that does not fit, or images that are a little late, differ from part to
  /// part as well; then any two poses gain something.
  double gainByChance(const std::vector<PointCorrespondence>& correspondences) const {
    double most = 0.0;
    for (const char* pattern : {"0101010101", "0011001100", "0110011001", "0001110001"}) {
      const auto isSecond = [&](std::size_t index) {
        return pattern[10 * index / correspondences.size()] == '1';
      };
      if (const auto two = twoPoses(correspondences, isSecond, widenedSigma())) {
        most = std::max(most, numbers_ * (base_.cost - two->explained.cost));
      }
    }
    return most;
  }

  /// How far the same points lie apart in the images of two poses: median, pixels.
  static double movedBy(const Camera& one, const Camera& other,
                        const std::vector<PointCorrespondence>& correspondences) {
    std::vector<double> distances;
    for (const PointCorrespondence& seen : correspondences) {
      const auto a = Projector(one).project(seen.position);
      const auto b = Projector(other).project(seen.position);
      if (a && b) {
        distances.push_back((*a - *b).norm());
      }
    }
    return upperMedian(distances);
  }

  /// A camera that was moved may be farther off than the initial rig.
  InitialRigSigma widenedSigma() const {
    return {2.0 * input_.initialSigma.rotation, 2.0 * input_.initialSigma.position};
  }

  void tryDelay() {
    const auto& times = suspect_.imagePoints->times;
    const auto& states = input_.problem.states;
    std::vector<double> gaps;
    for (std::size_t s = 0; s < times.size(); ++s) {
      if (!states[s].isFixed) {
        byTime_[times[s]] = s;
      }
    }
    for (auto at = byTime_.begin(); at != byTime_.end() && std::next(at) != byTime_.end(); ++at) {
      gaps.push_back(std::next(at)->first - at->first);
    }
    period_ = upperMedian(gaps);
    if (!(period_ > 0.0)) {
      return;
    }
    std::vector<std::pair<double, int>> order; // cost, frames
    for (int frames = -kMaxDelayFrames; frames <= kMaxDelayFrames; ++frames) {
      const auto correspondences = selectEvenly(known(frames * period_), kQuickCorrespondences);
      if (std::abs(frames) < kMinDelayFrames || correspondences.size() < kFewestCorrespondences) {
        continue;
      }
      if (const auto now = explain(initial_, correspondences, false, true)) {
        order.emplace_back(now->cost, frames);
      }
    }
    std::sort(order.begin(), order.end());
    for (std::size_t k = 0; k < std::min<std::size_t>(3, order.size()); ++k) {
      const auto correspondences =
          selectEvenly(known(order[k].second * period_), kMostCorrespondences);
      considerHypothesis(CalibrationFault::CameraDelayed, order[k].second,
                         explain(initial_, correspondences, false),
                         0.5 * std::log(numbers_) + std::log(2.0 * kMaxDelayFrames));
    }
  }

  const FaultSearchInput& input_;
  const SuspectCamera& suspect_;
  const Camera& initial_;
  double sigma_;
  double numbers_ = 0.0;
  double period_ = 0.0;
  std::map<double, std::size_t> byTime_;
  Explained base_;
  std::optional<DetectedFault> best_;
};

} // namespace

std::optional<DetectedFault> findCameraFault(const FaultSearchInput& input,
                                             const SuspectCamera& suspect) {
  return CameraSuspicion(input, suspect).run();
}

} // namespace dewpoint::calibration
