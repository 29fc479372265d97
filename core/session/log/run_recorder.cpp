// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/log/run_recorder.h"

#include "core/base/overloaded.h"
#include "core/base/statistics.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace dewpoint::session {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
constexpr std::size_t kTimesKept = 101; // odd: the median is one of them
/// Intervals between frames, for their rate; odd as well.
constexpr std::size_t kFrameTimesKept = 31;

using Seconds = std::chrono::duration<double>;

template <class T> void append(std::deque<T>& values, T value, std::size_t most) {
  values.push_back(std::move(value));
  while (values.size() > most) {
    values.pop_front();
  }
}

} // namespace

void RunRecorder::restart() {
  firstArrival_.reset();
  frameTimes_.clear();
  iterationTimes_.clear();
  budget_ = {};
  settings_.clear();
}

void RunRecorder::noteFrameTaken(bool isLive) {
  arrival_ = Clock::now();
  isFresh_ = isLive_ = isLive;
  append(frameTimes_, arrival_, kFrameTimesKept);
}

void RunRecorder::setCameraProblems(std::vector<Error> problems) {
  if (problems.empty()) {
    cameraProblems_ = nullptr;
  } else if (cameraProblems_ == nullptr || *cameraProblems_ != problems) {
    cameraProblems_ = std::make_shared<const std::vector<Error>>(std::move(problems));
  }
}

void RunRecorder::resetArrivalTime() {
  arrival_ = Clock::now();
  begun_.reset(); // it was taken long ago
  isFresh_ = false;
}

void RunRecorder::onIteration(const TrackingRun& run, double microseconds) {
  append(iterationTimes_, microseconds, kTimesKept);
  log_.countIteration(1e-6 * microseconds);
  countAgainstBudget(run.definition()->parameters,
                     1e-3 * microseconds *
                         static_cast<double>(std::max<std::size_t>(1, run.trackedTargetCount())));
  log_.append(records(run));
}

Status RunRecorder::onFrameTracked(const TrackingRun& run) {
  const auto now = Clock::now();
  estimated_ = now;
  firstArrival_ = firstArrival_.value_or(arrival_);
  log_.countFrame(Seconds(now - arrival_).count(), Seconds(now - *firstArrival_).count());
  if (std::exchange(isLive_, false)) {
    log_.addLiveFrameRecord(*run.frames());
  }
  if (std::exchange(isFresh_, false)) {
    log_.countLiveFrame(*run.frames(), arrival_, now);
  }
  return {};
}

std::vector<IterationRecord> RunRecorder::records(const TrackingRun& run) const {
  std::vector<IterationRecord> records;
  const std::vector<TrackEstimate> estimates = run.estimates();
  for (std::size_t k = 0; k < estimates.size(); ++k) {
    const TrackEstimate& estimate = estimates[k];
    if (isAbsent(estimate)) {
      continue;
    }
    IterationRecord record;
    record.iteration = run.iterationCount();
    record.frame = run.frames()->index;
    record.target = static_cast<int>(k);
    record.effectiveSampleSize = effectiveSampleSizeOf(estimate);
    record.frameTime = seconds(run.frames()->time);
    record.durationMicroseconds = iterationTimes_.back();
    record.particleCount = particleCountOf(estimate);
    record.existenceProbability = existenceProbabilityOf(estimate);
    record.isConfirmed = isConfirmed(estimate);
    record.cameraEvidence = cameraEvidenceOf(estimate);
    if (const auto position = positionOf(estimate)) {
      record.spread = spreadOf(position->covariance);
      record.spreadPerAxis = position->covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
      record.position = position->mean;
    }
    const auto describe =
        Overloaded{[&](const SphereEstimate& sphere) {
                     const auto truth = truth_.at(run.targets()[k].name, record.frame);
                     record.distanceToTruth =
                         truth ? (sphere.mean - *truth).norm() : record.distanceToTruth;
                     record.truth = truth.value_or(record.truth);
                   },
                   [&](const BoxEstimate& box) {
                     record.similarity = box.similarity;
                     record.spread = box.spreadPixels;
                     record.position.head<2>() = box.box.center();
                     record.boxWidth = box.box.width;
                     record.boxHeight = box.box.height;
                   },
                   [](const PersonEstimate&) {}, // nobody knows which of the true ones it is
                   [](const AbsentEstimate&) {}};
    std::visit(describe, estimate);
    records.push_back(std::move(record));
  }
  return records;
}

void RunRecorder::countAgainstBudget(const ParameterValues& parameters, double milliseconds) {
  const auto declared = parameters.declarations();
  const bool has =
      std::ranges::find(declared, "time_budget", &ParameterDeclaration::key) != declared.end();
  const double budget = has ? parameters.at("time_budget") : 0.0;
  if (budget != budget_.budgetMilliseconds) {
    budget_ = {budget, 0, 0};
  }
  ++budget_.iterationCount;
  budget_.lateIterationCount += milliseconds > budget ? 1 : 0;
}

void RunRecorder::record(const TrackingRun& run, const TrackedFrame& trackedFrame) {
  log_.append(run.samples());
  log_.append(run.boxSamples());
  FrameRecord frame = frameRecord(trackedFrame, *run.frames());
  frame.cameraProblems = cameraProblems_;
  log_.append(frame);
  if (run.definition()->family().writesBodies() && !trackedFrame.targets.empty()) {
    log_.append(peopleFrame(trackedFrame));
  }
  const auto awaited = std::exchange(begun_, std::nullopt);
  if (run.frameIterationCount() < run.iterationsPerFrame()) {
    return; // it is under way, and goes on with the settings of then
  }
  settings_.recordTrackedFrame(trackedFrame.frame, run.definition());
  if (awaited) {
    append(workTimes_, Seconds(Clock::now() - *awaited).count(), kFrameTimesKept);
  }
}

void RunRecorder::updateOldResults(const RunDefinition& now) const {
  log_.setOldResults({settings_.framesDifferingFrom(now), settings_.newestFrame(),
                      upperMedian({workTimes_.begin(), workTimes_.end()})});
}

void RunRecorder::addStatistics(TrackSnapshot& snapshot) const {
  if (frameTimes_.size() > 1) {
    const Seconds span = frameTimes_.back() - frameTimes_.front();
    snapshot.framesPerSecond =
        static_cast<double>(frameTimes_.size() - 1) / std::max(1e-9, span.count());
  }
  snapshot.microsecondsPerIteration = upperMedian({iterationTimes_.begin(), iterationTimes_.end()});
  snapshot.budget = budget_;
  snapshot.estimatedAt = estimated_;
  snapshot.latency = log_.latency();
  snapshot.liveLatency = log_.liveLatency();
}

} // namespace dewpoint::session
