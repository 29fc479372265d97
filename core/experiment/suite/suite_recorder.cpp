// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/suite/suite_recorder.h"

#include "core/base/units.h"
#include "core/experiment/metrics/clear_mot.h"
#include "core/experiment/metrics/consistency.h"
#include "core/experiment/metrics/error_split.h"
#include "core/experiment/metrics/extent_errors.h"
#include "core/experiment/metrics/gospa.h"
#include "core/experiment/metrics/hota.h"
#include "core/experiment/metrics/jitter.h"
#include "core/experiment/metrics/overconfidence.h"
#include "core/experiment/metrics/reliability.h"
#include "core/experiment/metrics/tie_belief.h"
#include "core/experiment/suite/stated_presence.h"
#include "core/filter/assignment.h"
#include "core/geometry/mean_vector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace dewpoint::experiment {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr std::int64_t kStepFrames = 5; // frames before and after a camera's loss that are averaged

double framesOrNever(const std::optional<std::int64_t>& frames) {
  return frames ? static_cast<double>(*frames) : kNever;
}

/// The worst so far and one more.
void raise(SuiteRow::Value& worst, double value) {
  worst = std::max(worst.value_or(value), value);
}

std::optional<Eigen::Vector3d> errorOf(const TargetFrame& frame) {
  return frame.truth && frame.estimate
             ? std::optional<Eigen::Vector3d>(*frame.estimate - *frame.truth)
             : std::nullopt;
}

std::vector<Eigen::Vector3d> errorsBetween(const std::vector<TargetFrame>& frames,
                                           std::int64_t begin, std::int64_t end) {
  std::vector<Eigen::Vector3d> errors;
  for (const TargetFrame& frame : frames) {
    const auto error = errorOf(frame);
    if (error && frame.frame >= begin && frame.frame < end) {
      errors.push_back(*error);
    }
  }
  return errors;
}

bool happensToACamera(ScenarioEvent::Kind kind) {
  return kind == ScenarioEvent::Kind::CameraLost || kind == ScenarioEvent::Kind::CameraBack;
}

bool hasToBeFoundAgain(ScenarioEvent::Kind kind) {
  return kind == ScenarioEvent::Kind::Jump || kind == ScenarioEvent::Kind::BlackoutEnd ||
         kind == ScenarioEvent::Kind::Return || kind == ScenarioEvent::Kind::UnseenEnd;
}

/// The first frame at or after `frame` where the same camera's blackout ends.
std::int64_t endOfBlackout(const ScenarioRun& run, const ScenarioEvent& begin) {
  for (const ScenarioEvent& event : run.events) {
    if (event.kind == ScenarioEvent::Kind::BlackoutEnd && event.camera == begin.camera &&
        event.frame >= begin.frame) {
      return event.frame;
    }
  }
  return run.frameCount;
}

bool isWithin(const ScenarioRun& run, const ScenarioEvent& blackout, std::int64_t frame) {
  return blackout.kind == ScenarioEvent::Kind::BlackoutBegin && frame >= blackout.frame &&
         frame < endOfBlackout(run, blackout);
}

/// Whether no camera has the target in view, by the events.
bool isOutOfView(const ScenarioRun& run, std::int64_t frame) {
  bool outOfView = false;
  for (const ScenarioEvent& event : run.events) { // in the order of their frames
    if (event.camera < 0 && event.frame <= frame) {
      outOfView = event.kind == ScenarioEvent::Kind::UnseenBegin ||
                  (outOfView && event.kind != ScenarioEvent::Kind::UnseenEnd);
    }
  }
  return outOfView;
}

void measureEvents(const ScenarioRun& run, const std::vector<TargetFrame>& frames, SuiteRow& row) {
  for (const ScenarioEvent& event : run.events) {
    if (hasToBeFoundAgain(event.kind)) {
      raise(row.framesToReacquire,
            framesOrNever(framesToReacquire(frames, event.frame, kFollowGate)));
    } else if (event.kind == ScenarioEvent::Kind::Vanish) {
      raise(row.framesToDeclareLoss, framesOrNever(framesToDeclareLoss(frames, event.frame)));
    } else if (event.kind == ScenarioEvent::Kind::BlackoutBegin) {
      const auto errors = errorsBetween(frames, event.frame, endOfBlackout(run, event));
      raise(row.blackoutRmseMm, errors.empty() ? kNever : inMillimeters(rootMeanSquare(errors)));
    } else if (happensToACamera(event.kind)) {
      const auto before = errorsBetween(frames, event.frame - kStepFrames, event.frame);
      const auto after = errorsBetween(frames, event.frame, event.frame + kStepFrames);
      const bool both = !before.empty() && !after.empty();
      raise(row.largestStepMm,
            both ? inMillimeters((meanVector(after) - meanVector(before)).norm()) : kNever);
    }
  }
}

void fillErrors(const std::vector<Eigen::Vector3d>& errors, const CameraRig& rig, SuiteRow& row) {
  if (errors.empty()) {
    return;
  }
  std::vector<TrajectoryCamera> cameras;
  for (const Camera& camera : rig) {
    cameras.push_back({camera.name, camera.center(), camera.opticalAxis()});
  }
  const ErrorSplit split = splitErrors(errors, cameras);
  row.rmseMm = inMillimeters(split.summary.rmse);
  row.medianErrorMm = inMillimeters(split.summary.medianError);
  row.p95ErrorMm = inMillimeters(split.summary.p95);
  row.maxErrorMm = inMillimeters(split.summary.maxError);
  row.biasMm = inMillimeters(split.summary.bias.norm());
  if (split.meanViewBias) {
    row.depthErrorMm = inMillimeters(split.meanViewBias->alongAxisRms);
    row.lateralErrorMm = inMillimeters(split.meanViewBias->acrossAxisRms);
    row.depthBiasMm = inMillimeters(split.meanViewBias->alongAxisBias);
  }
}

void fillTracks(const std::vector<TrackFrame>& frames, SuiteRow& row) {
  row.gospaMm = inMillimeters(averageGospa(frames, {kMatchGate, 2.0}).mean);
  const ClearMot mot = computeClearMot(frames, kMatchGate);
  row.mota = mot.mota();
  row.identitySwitches = static_cast<double>(mot.identitySwitches);
  row.hota = computeHota(frames, kMatchGate).hota;
  row.falseAlarmPercent = inPercent(falseAlarmFrameShare(frames, kMatchGate).value());
}

void fillReliability(const std::vector<Forecast>& forecasts, SuiteResult& result) {
  const Reliability table = computeReliability(forecasts, kReliabilityBins);
  result.row.existenceEce = table.expectedCalibrationError;
  for (const ReliabilityBin& bin : table.bins) {
    const auto count = static_cast<double>(bin.forecastCount);
    result.trace.reliabilityCounts.push_back(
        {bin.forecastCount, bin.forecastCount > 0 ? count * bin.meanProbability : 0.0,
         bin.forecastCount > 0 ? std::llround(count * bin.observedFrequency) : 0});
  }
}

bool isInside95(const StateError& sample) {
  return normalizedErrorSquared(sample) <= kChiSquared95ThreeDof; // false if it is unusable
}

void fillConsistency(const std::vector<StateError>& samples, SuiteRow& row) {
  const Consistency fit = computeConsistency(samples);
  row.nees = fit.nees.value;
  row.coverage95Percent = inPercent(fit.coverage95.value());
  row.coverage50Percent = inPercent(fit.coverage50.value());
}

/// Nothing where there was nothing to measure.
SuiteRow::Value figureOrNone(double value) {
  return std::isnan(value) ? std::nullopt : SuiteRow::Value(value);
}

void fillExtents(const std::vector<ExtentSample>& samples, SuiteRow& row) {
  const ExtentErrors errors = measureExtentErrors(samples);
  row.nearCentroidPercent = figureOrNone(inPercent(errors.nearEstimateProportion.value()));
  row.centroidErrorPercent = figureOrNone(inPercent(errors.relativeCentroidError));
  row.sizeErrorPercent = figureOrNone(inPercent(errors.relativeSizeError));
}

void fillOverconfidence(const std::vector<ReportedBelief>& beliefs, SuiteRow& row) {
  const Overconfidence shares = measureOverconfidence(beliefs, kFollowGate);
  row.confidentlyWrongPercent = inPercent(shares.confidentlyWrongShare.value());
  row.wrongPercent = inPercent(shares.wrongShare.value());
  row.wrongWhenConfidentPercent = inPercent(shares.wrongAndConfidentShare.value());
}

} // namespace

/// What a run's figures are taken from, of all targets.
struct SuiteRecorder::Samples {
  std::vector<Eigen::Vector3d> errors; ///< from convergence on, as the next three
  std::vector<StateError> states;
  std::vector<ErrorSequence> sequences; ///< one per target
  std::vector<ExtentSample> extents;
  std::vector<Forecast> forecasts;
  std::vector<ReportedBelief> beliefs;
  std::vector<ReportedBelief> firstBeliefs; ///< those in the first target
  Proportion lost;
  Proportion blindInside;
};

SuiteRecorder::SuiteRecorder(const ScenarioRun& run, std::string method)
    : run_(run), method_(std::move(method)),
      truth_(static_cast<std::size_t>(run.frameCount),
             std::vector<std::optional<Eigen::Vector3d>>(run.targets.size())) {
  std::map<std::string, std::size_t> index;
  for (std::size_t k = 0; k < run.targets.size(); ++k) {
    index.emplace(run.targets[k].name, k);
  }
  const bool sized = run.extents.size() == run.truth.samples.size();
  extents_.resize(sized ? truth_.size() : 0, std::vector<TargetExtent>(run.targets.size()));
  for (std::size_t k = 0; k < run.truth.samples.size(); ++k) {
    const TrajectorySample& sample = run.truth.samples[k];
    const auto target = index.find(sample.target);
    if (sample.isValid && target != index.end() && sample.frame >= 0 &&
        sample.frame < run.frameCount) {
      const auto frame = static_cast<std::size_t>(sample.frame);
      truth_[frame][target->second] = sample.position;
      if (sized) {
        extents_[frame][target->second] = run.extents[k];
      }
    }
  }
}

void SuiteRecorder::add(const std::vector<SphereEstimate>& estimates) {
  estimates_.push_back(estimates);
  estimates_.back().resize(run_.targets.size());
}

bool SuiteRecorder::areAllCamerasBlind(std::int64_t frame) const {
  return std::ranges::any_of(run_.events, [&](const ScenarioEvent& event) {
    return event.camera < 0 && isWithin(run_, event, frame);
  });
}

bool SuiteRecorder::isAnyCameraBlind(std::int64_t frame) const {
  return std::ranges::any_of(
      run_.events, [&](const ScenarioEvent& event) { return isWithin(run_, event, frame); });
}

std::vector<TargetFrame> SuiteRecorder::framesOf(std::size_t truth, std::size_t estimate) const {
  std::vector<TargetFrame> frames;
  for (std::size_t k = 0; k < estimates_.size(); ++k) {
    TargetFrame frame;
    frame.frame = static_cast<std::int64_t>(k);
    frame.truth = truth_[k][truth];
    if (reportsPresence(estimates_[k][estimate])) {
      frame.estimate = estimates_[k][estimate].mean;
    }
    frame.isVisible = !areAllCamerasBlind(frame.frame) && !isOutOfView(run_, frame.frame);
    frames.push_back(frame);
  }
  return frames;
}

std::vector<std::size_t> SuiteRecorder::truthToEstimate() const {
  const auto count = static_cast<Eigen::Index>(run_.targets.size());
  Eigen::MatrixXd cost(count, count);
  for (Eigen::Index truth = 0; truth < count; ++truth) {
    for (Eigen::Index estimate = 0; estimate < count; ++estimate) {
      const auto t = static_cast<std::size_t>(truth);
      const auto e = static_cast<std::size_t>(estimate);
      if (!(run_.targets[t].colors() == run_.targets[e].colors())) {
        cost(truth, estimate) = kNever;
        continue;
      }
      const auto followed = std::ranges::count_if(
          framesOf(t, e), [](const TargetFrame& frame) { return frame.isFollowed(kFollowGate); });
      // Their own name decides where nothing else does.
      cost(truth, estimate) = -static_cast<double>(followed) - (truth == estimate ? 0.5 : 0.0);
    }
  }
  std::vector<std::size_t> result;
  for (const Eigen::Index column : assignMinimumCost(cost).columnOfRow) {
    result.push_back(static_cast<std::size_t>(column)); // the diagonal is never forbidden
  }
  return result;
}

std::vector<TrackFrame> SuiteRecorder::trackFrames() const {
  std::vector<TrackFrame> frames;
  for (std::size_t k = 0; k < estimates_.size(); ++k) {
    TrackFrame frame;
    frame.frame = static_cast<std::int64_t>(k);
    frame.time = static_cast<double>(k) / run_.framesPerSecond;
    for (std::size_t target = 0; target < run_.targets.size(); ++target) {
      if (truth_[k][target]) {
        frame.truth.push_back({static_cast<int>(target), *truth_[k][target]});
      }
      if (reportsPresence(estimates_[k][target])) {
        frame.estimates.push_back({static_cast<int>(target), estimates_[k][target].mean});
      }
    }
    frames.push_back(std::move(frame));
  }
  return frames;
}

const TargetExtent* SuiteRecorder::extentOf(std::size_t frame, std::size_t target) const {
  return extents_.empty() ? nullptr : &extents_[frame][target];
}

void SuiteRecorder::addTarget(std::size_t target, std::size_t estimate, Samples& samples,
                              SuiteResult& result) const {
  const auto frames = framesOf(target, estimate);
  const auto converged = framesToConverge(frames, kFollowGate);
  raise(result.row.framesToConverge, framesOrNever(converged));
  measureEvents(run_, frames, result.row);
  const auto begin = static_cast<std::size_t>(converged.value_or(0));
  const auto inPart = lostFrameShare(std::span(frames).subspan(begin), kFollowGate);
  samples.lost.count += inPart.count;
  samples.lost.total += inPart.total;
  const bool sizeIsGiven = run_.targets[target].radius > 0.0;
  auto& trace = result.trace.errorsMm.emplace_back();
  auto& sequence = samples.sequences.emplace_back();
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const SphereEstimate& stated = estimates_[k][estimate];
    const auto error = errorOf(frames[k]);
    // Of the difference between estimate and truth.
    const Eigen::Matrix3d covariance =
        stated.covariance + run_.truthSigma * run_.truthSigma * Eigen::Matrix3d::Identity();
    trace.push_back(error ? inMillimeters(error->norm())
                          : std::numeric_limits<double>::quiet_NaN());
    samples.forecasts.push_back(
        {stated.existenceProbability,
         frames[k].truth.has_value() && (stated.mean - *frames[k].truth).norm() < kFollowGate});
    samples.beliefs.push_back({stated.existenceProbability, reportsPresence(stated), stated.mean,
                               covariance, frames[k].truth});
    if (target == 0) {
      samples.firstBeliefs.push_back(samples.beliefs.back());
    }
    if (frames[k].truth && isAnyCameraBlind(frames[k].frame)) {
      ++samples.blindInside.total;
      samples.blindInside.count += error && isInside95({*error, covariance}) ? 1 : 0;
    }
    if (k < begin) {
      continue;
    }
    sequence.push_back(error);
    if (error) {
      samples.errors.push_back(*error);
      samples.states.push_back({*error, covariance});
    }
    const TargetExtent* const extent = extentOf(k, target);
    if (extent != nullptr && frames[k].truth && frames[k].isVisible) {
      const bool hasSize = error && !sizeIsGiven && stated.radius > 0.0;
      samples.extents.push_back({error ? std::optional(error->norm()) : std::nullopt,
                                 extent->halfAxes.maxCoeff(), extent->radius,
                                 hasSize ? std::optional(stated.radius) : std::nullopt});
    }
  }
}

SuiteResult SuiteRecorder::result(double usPerFrame) const {
  SuiteResult result;
  SuiteRow& row = result.row;
  row.key = {run_.scenario, run_.grade, method_, run_.seed};
  result.trace.key = row.key;
  Samples samples;
  const auto estimateOf = truthToEstimate();
  for (std::size_t target = 0; target < estimateOf.size(); ++target) {
    addTarget(target, estimateOf[target], samples, result);
  }
  fillErrors(samples.errors, run_.trueRig, row);
  row.jitterMm = figureOrNone(inMillimeters(jitterOf(samples.sequences)));
  fillExtents(samples.extents, row);
  fillConsistency(samples.states, row);
  fillReliability(samples.forecasts, result);
  fillOverconfidence(samples.beliefs, row);
  if (run_.equalCandidateCount > 1) {
    row.confidentInTiePercent = figureOrNone(
        inPercent(confidentInTieShare(samples.firstBeliefs, run_.equalCandidateCount).value()));
  }
  fillTracks(trackFrames(), row);
  if (samples.lost.total > 0) {
    row.lostPercent = inPercent(samples.lost.value());
  }
  if (samples.blindInside.total > 0) {
    row.blackoutCoverage95Percent = inPercent(samples.blindInside.value());
  }
  row.usPerFrame = usPerFrame;
  row.frameCount = static_cast<double>(estimates_.size());
  return result;
}

} // namespace dewpoint::experiment
