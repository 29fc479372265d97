// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/quality/fault_finder.h"

#include "core/base/statistics.h"
#include "core/calibration/formats/calibration_plausibility.h"
#include "core/calibration/quality/fault_all.h"
#include "core/calibration/quality/fault_bodies.h"
#include "core/calibration/quality/fault_camera.h"
#include "core/calibration/wand/wand_bundle.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::calibration {
namespace {

/// Cameras agree when their residuals are within the best times this.
constexpr double kAgreeingFactor = 2.0;
/// Two cameras cannot tell shifted principal points: their poses explain the same images.
constexpr std::size_t kLeastCamerasOfCommonFault = 3;
constexpr double kSwapExplains = 0.5; ///< exchanged cameras fit at least so much better

/// Lens data of another size than the video: no question of residuals.
std::optional<DetectedFault> declaredSize(const FaultSearchInput& input) {
  for (std::size_t c = 0; c < input.imageSizes.size(); ++c) {
    const Intrinsics& in = input.problem.cameras.at(c).camera.intrinsics;
    const auto& size = input.imageSizes[c];
    if (size[0] != in.width || size[1] != in.height) {
      return DetectedFault{CalibrationFault::WrongResolution, {c}, double(size[0]) / in.width};
    }
  }
  return std::nullopt;
}

/// The search for one question.
class FaultSearch {
public:
  explicit FaultSearch(const FaultSearchInput& input)
      : input_(input), imagePoints_(imagePointsOf(input.problem)) {
    for (const BundleCamera& camera : input.problem.cameras) {
      initialRig_.push_back(camera.camera);
    }
    if (cameraSpread(initialRig_) > kMaxCameraSpread) {
      input_.initialSigma.position *= 1000.0;
    }
    everyone_.assign(initialRig_.size(), true);
  }

  FaultReport run() {
    FaultReport report;
    if (auto size = declaredSize(input_)) {
      report.faults.push_back(*size);
      return finished(std::move(report));
    }
    all_ = estimateStructureAndPoses(initialRig_, imagePoints_, everyone_, input_.initialSigma);
    fitOthers();
    fitSwapped();
    report.sigmaPx = best_;
    auto named = ofOneCamera();
    if (auto swap = ofTwoCameras();
        swap && (!named || swap->logLikelihoodGain > named->logLikelihoodGain)) {
      named = swap;
    }
    if (!named && all_ && initialRig_.size() >= kLeastCamerasOfCommonFault) {
      named = findCommonFault(input_, imagePoints_, *all_);
    }
    if (named) {
      report.faults.push_back(*named);
    }
    if (all_ && all_->sigmaPx <= kAgreeingFactor * best_ &&
        (!named || named->fault == CalibrationFault::HalfPixel)) {
      for (DetectedFault& fault : findBodyFaults(
               input_, triangulatedPositions(all_->rig, imagePoints_, everyone_), all_->rig)) {
        report.faults.push_back(fault);
      }
    }
    return finished(std::move(report));
  }

private:
  struct Swap {
    std::size_t one, other;
    PointFit fit;
  };

  FaultReport finished(FaultReport report) const {
    std::vector<std::string> names;
    for (const Camera& camera : initialRig_) {
      names.push_back(camera.name);
    }
    for (DetectedFault& fault : report.faults) {
      fault.sentence = faultDescription(fault, names);
    }
    return report;
  }

  void consider(const std::optional<PointFit>& fit) {
    if (fit && (best_ == 0.0 || fit->sigmaPx < best_)) {
      best_ = fit->sigmaPx;
    }
  }

  std::vector<bool> without(std::size_t camera) const {
    std::vector<bool> use = everyone_;
    use[camera] = false;
    return use;
  }

  void fitOthers() {
    consider(all_);
    for (std::size_t c = 0; c < initialRig_.size(); ++c) {
      others_.push_back(initialRig_.size() < 3
                            ? std::nullopt
                            : estimateStructureAndPoses(initialRig_, imagePoints_, without(c),
                                                        input_.initialSigma));
      consider(others_.back());
    }
  }

  /// Exchanged cameras leave many pixels.
  bool mayBeSwapped() const {
    std::vector<double> sigmas;
    for (const BundleObservation& seen : input_.problem.observations) {
      sigmas.push_back(seen.sigma);
    }
    return all_ && all_->sigmaPx > std::max(1.0, 3.0 * upperMedian(sigmas));
  }

  void fitSwapped() {
    if (!mayBeSwapped()) {
      return;
    }
    for (std::size_t i = 0; i < initialRig_.size(); ++i) {
      for (std::size_t j = i + 1; j < initialRig_.size(); ++j) {
        ImagePoints exchanged = imagePoints_;
        std::swap(exchanged.pointsPerCamera[i], exchanged.pointsPerCamera[j]);
        if (auto fit =
                estimateStructureAndPoses(initialRig_, exchanged, everyone_, input_.initialSigma)) {
          swaps_.push_back({i, j, std::move(*fit)});
          consider(swaps_.back().fit);
        }
      }
    }
  }

  std::optional<DetectedFault> ofOneCamera() const {
    std::optional<DetectedFault> best;
    for (std::size_t c = 0; c < initialRig_.size(); ++c) {
      if (!others_[c] || others_[c]->sigmaPx > kAgreeingFactor * best_) {
        continue;
      }
      const PointPositions positions =
          triangulatedPositions(others_[c]->rig, imagePoints_, without(c));
      const auto found =
          findCameraFault(input_, {c, &imagePoints_, &positions, others_[c]->sigmaPx});
      if (found && (!best || found->logLikelihoodGain > best->logLikelihoodGain)) {
        best = found;
      }
    }
    return best;
  }

  std::optional<DetectedFault> ofTwoCameras() const {
    std::optional<DetectedFault> best;
    for (const Swap& swap : swaps_) {
      if (!all_ || swap.fit.sigmaPx > kAgreeingFactor * best_ ||
          swap.fit.sigmaPx > kSwapExplains * all_->sigmaPx) {
        continue;
      }
      const double gain =
          static_cast<double>(swap.fit.squaredResiduals.size()) *
          (meanCost(all_->squaredResiduals, best_) - meanCost(swap.fit.squaredResiduals, best_));
      if (gain > kMinGain && (!best || gain > best->logLikelihoodGain)) {
        best = DetectedFault{CalibrationFault::CamerasSwapped, {swap.one, swap.other}, 0.0, gain};
      }
    }
    return best;
  }

  FaultSearchInput input_;
  ImagePoints imagePoints_;
  CameraRig initialRig_;
  std::vector<bool> everyone_;
  std::optional<PointFit> all_;
  std::vector<std::optional<PointFit>> others_; ///< without each camera
  std::vector<Swap> swaps_;
  double best_ = 0.0; ///< pixels: the least that any hypothesis leaves
};

} // namespace

FaultReport findFaults(const FaultSearchInput& input) {
  return FaultSearch(input).run();
}

Result<FaultReport> findWandFaults(const WandProblem& problem) {
  return makeWandBundle(problem).map([&](const BundleProblem& bundle) {
    FaultSearchInput input;
    input.problem = bundle;
    input.initialSigma = {problem.initialRotationError, problem.initialPositionError};
    input.isFocalUnknown = problem.estimatesFocalLengths;
    input.isUnsynchronized =
        problem.estimatesTimeOffsets ||
        std::any_of(bundle.observations.begin(), bundle.observations.end(),
                    [](const BundleObservation& seen) { return seen.timeAfterState != 0.0; });
    return findFaults(input);
  });
}

} // namespace dewpoint::calibration
