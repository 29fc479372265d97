// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/suite/pixel_recorder.h"

#include "core/base/units.h"
#include "core/experiment/metrics/overconfidence.h"
#include "core/experiment/suite/stated_presence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace dewpoint::experiment {
namespace {

constexpr double kNotInSight = std::numeric_limits<double>::infinity();

void fillBelief(const std::vector<Forecast>& forecasts, SuiteResult& result) {
  const Reliability table = computeReliability(forecasts, kReliabilityBins);
  result.row.existenceEce = table.expectedCalibrationError;
  for (const ReliabilityBin& bin : table.bins) {
    const auto count = static_cast<double>(bin.forecastCount);
    const bool any = bin.forecastCount > 0;
    result.trace.reliabilityCounts.push_back(
        {bin.forecastCount, any ? count * bin.meanProbability : 0.0,
         any ? std::llround(count * bin.observedFrequency) : 0});
  }
}

} // namespace

PixelRecorder::PixelRecorder(const ScenarioRun& run)
    : cameras_(run.rig.begin(), run.rig.end()), gate_(run.markGatePx),
      samples_(run.targets.size()) {
  for (const MarkedCenter& mark : run.markedCenters) {
    marks_[mark.frame].push_back(mark);
  }
}

void PixelRecorder::add(std::int64_t frame, const std::vector<SphereEstimate>& estimates) {
  const auto marks = marks_.find(frame);
  if (marks == marks_.end()) {
    return;
  }
  for (std::size_t target = 0; target < samples_.size(); ++target) {
    const SphereEstimate estimate =
        target < estimates.size() ? estimates[target] : SphereEstimate();
    Sample sample;
    sample.isDeclared = reportsPresence(estimate);
    sample.existenceProbability = estimate.existenceProbability;
    for (const MarkedCenter& mark : marks->second) {
      if (mark.target == target) {
        const auto pixel = cameras_[mark.camera].project(estimate.mean);
        sample.distancesPx.push_back(pixel ? (*pixel - mark.pixel).norm() : kNotInSight);
        sample.largestDistancePx = std::max(sample.largestDistancePx, sample.distancesPx.back());
      }
    }
    if (!sample.distancesPx.empty()) {
      samples_[target].push_back(std::move(sample));
    }
  }
}

/// The truth at zero and the estimate as far away as its worst projection is from its mark: the
/// metrics of events then count in pixels.
std::vector<TargetFrame> PixelRecorder::framesOf(std::size_t target) const {
  std::vector<TargetFrame> frames;
  for (const Sample& sample : samples_[target]) {
    TargetFrame frame;
    frame.frame = static_cast<std::int64_t>(frames.size());
    frame.truth = Eigen::Vector3d::Zero();
    if (sample.isDeclared) {
      frame.estimate = Eigen::Vector3d(sample.largestDistancePx, 0.0, 0.0);
    }
    frames.push_back(frame);
  }
  return frames;
}

SuiteRow::Value PixelRecorder::rmsePx() const {
  double sum = 0.0;
  std::int64_t count = 0;
  for (std::size_t target = 0; target < samples_.size(); ++target) {
    const auto begin = framesToConverge(framesOf(target), gate_).value_or(0);
    for (auto k = static_cast<std::size_t>(begin); k < samples_[target].size(); ++k) {
      const Sample& sample = samples_[target][k];
      if (sample.isDeclared) {
        for (const double distance : sample.distancesPx) {
          sum += distance * distance;
          ++count;
        }
      }
    }
  }
  return count > 0 ? SuiteRow::Value(std::sqrt(sum / static_cast<double>(count))) : std::nullopt;
}

SuiteResult PixelRecorder::result(RunKey key, double usPerFrame) const {
  SuiteResult result;
  SuiteRow& row = result.row;
  row.key = std::move(key);
  result.trace.key = row.key;
  Proportion lost;
  Proportion wrong;
  Proportion wrongWhenConfident;
  std::vector<Forecast> forecasts;
  for (std::size_t target = 0; target < samples_.size(); ++target) {
    const auto frames = framesOf(target);
    const auto converged = framesToConverge(frames, gate_);
    const double begin = converged ? static_cast<double>(*converged) : kNotInSight;
    row.framesToConverge = std::max(row.framesToConverge.value_or(begin), begin);
    const auto after = std::span(frames).subspan(static_cast<std::size_t>(converged.value_or(0)));
    const Proportion part = lostFrameShare(after, gate_);
    lost.count += part.count;
    lost.total += part.total;
    for (const Sample& sample : samples_[target]) {
      forecasts.push_back({sample.existenceProbability, sample.largestDistancePx < gate_});
      const bool isWrong = sample.isDeclared && sample.largestDistancePx > gate_;
      wrong.count += isWrong ? 1 : 0;
      wrongWhenConfident.count +=
          isWrong && sample.existenceProbability > kConfidentProbability ? 1 : 0;
      ++wrong.total;
      ++wrongWhenConfident.total;
    }
    // No length is known: "not declared" in every frame.
    result.trace.errorsMm.emplace_back(std::max<std::size_t>(1, frames.size()),
                                       std::numeric_limits<double>::quiet_NaN());
  }
  if (lost.total > 0) {
    row.lostPercent = inPercent(lost.value());
  }
  if (wrong.total > 0) {
    row.wrongPercent = inPercent(wrong.value());
    row.wrongWhenConfidentPercent = inPercent(wrongWhenConfident.value());
  }
  fillBelief(forecasts, result);
  row.rmsePx = rmsePx();
  row.usPerFrame = usPerFrame;
  row.frameCount = static_cast<double>(marks_.size());
  return result;
}

} // namespace dewpoint::experiment
