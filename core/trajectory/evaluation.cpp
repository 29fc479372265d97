// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/evaluation.h"

#include "core/base/belief_region.h"
#include "core/base/statistics.h"
#include "core/trajectory/trajectory_reader.h"

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace dewpoint::trajectory {
namespace {

using Samples = std::vector<const TrajectorySample*>;

/// One frame of the truth; `estimate` is null where there is none (or none that is finite).
struct Pair {
  const TrajectorySample* truth = nullptr;
  const TrajectorySample* estimate = nullptr;

  Eigen::Vector3d error() const { return estimate->position - truth->position; }
  /// Whether the truth lies in the estimate's 95 % ellipsoid; never where that is none.
  bool isInside() const {
    const Eigen::LLT<Eigen::Matrix3d> factor(estimate->covariance);
    return factor.info() == Eigen::Success &&
           factor.matrixL().solve(error()).squaredNorm() <= kChiSquared95ThreeDof;
  }
};

std::vector<std::string> targetNames(const Trajectory& trajectory) {
  std::vector<std::string> names;
  std::set<std::string> seen;
  for (const TrajectorySample& sample : trajectory.samples)
    if (seen.insert(sample.target).second)
      names.push_back(sample.target);
  return names;
}

std::map<std::string, Samples> samplesByTarget(const Trajectory& trajectory) {
  std::map<std::string, Samples> samples;
  for (const TrajectorySample& sample : trajectory.samples)
    samples[sample.target].push_back(&sample);
  return samples;
}

bool haveFrames(const Samples& samples) {
  return std::all_of(samples.begin(), samples.end(),
                     [](const TrajectorySample* sample) { return sample->frame != kNoFrame; });
}

bool haveTimes(const Samples& samples) {
  return std::all_of(samples.begin(), samples.end(),
                     [](const TrajectorySample* sample) { return std::isfinite(sample->time); });
}

Pair makePair(const TrajectorySample* truth, const TrajectorySample* estimate) {
  const bool usable = estimate != nullptr && estimate->position.allFinite();
  return {truth, usable ? estimate : nullptr};
}

std::vector<Pair> pairByFrame(const Samples& estimate, const Samples& truth) {
  std::map<std::int64_t, const TrajectorySample*> byFrame;
  for (const TrajectorySample* sample : estimate)
    byFrame[sample->frame] = sample;
  std::map<std::int64_t, Pair> pairs;
  for (const TrajectorySample* sample : truth) {
    if (sample->frame < byFrame.begin()->first || sample->frame > byFrame.rbegin()->first)
      continue;
    const auto found = byFrame.find(sample->frame);
    pairs[sample->frame] = makePair(sample, found == byFrame.end() ? nullptr : found->second);
  }
  std::vector<Pair> result;
  result.reserve(pairs.size());
  for (const auto& [frame, pair] : pairs)
    result.push_back(pair);
  return result;
}

Samples sortedByTime(Samples samples) {
  std::stable_sort(samples.begin(), samples.end(),
                   [](const auto* a, const auto* b) { return a->time < b->time; });
  return samples;
}

/// Median time between samples, in seconds; 0 if there are fewer than two.
double framePeriod(const Samples& sorted) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < sorted.size(); ++i)
    steps.push_back(sorted[i]->time - sorted[i - 1]->time);
  return upperMedian(std::move(steps));
}

std::vector<Pair> pairByTime(const Samples& estimate, const Samples& truth) {
  const Samples found = sortedByTime(estimate);
  const Samples wanted = sortedByTime(truth);
  const double period = framePeriod(wanted) > 0.0 ? framePeriod(wanted) : framePeriod(found);
  // Times written with few digits must still meet when there is no other measure.
  const double half = std::max(period / 2.0, 1e-6);
  std::vector<Pair> pairs;
  for (const TrajectorySample* sample : wanted) {
    if (sample->time < found.front()->time - half || sample->time > found.back()->time + half)
      continue;
    auto next = std::lower_bound(found.begin(), found.end(), sample->time,
                                 [](const auto* a, double time) { return a->time < time; });
    if (next == found.end() || (next != found.begin() && sample->time - (*std::prev(next))->time <=
                                                             (*next)->time - sample->time))
      --next;
    const bool near = std::abs((*next)->time - sample->time) <= half;
    pairs.push_back(makePair(sample, near ? *next : nullptr));
  }
  return pairs;
}

std::optional<std::size_t> convergedAt(const std::vector<Pair>& pairs, double gate) {
  int run = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    run = pairs[i].estimate != nullptr && pairs[i].error().norm() < gate ? run + 1 : 0;
    if (run == kConvergedFrames)
      return i + 1 - static_cast<std::size_t>(kConvergedFrames);
  }
  return std::nullopt;
}

void fillStatistics(Evaluation& evaluation, const std::vector<Eigen::Vector3d>& errors,
                    const std::vector<TrajectoryCamera>& cameras) {
  const ErrorSummary summary = summarize(errors);
  evaluation.rmse = summary.rmse;
  evaluation.medianError = summary.medianError;
  evaluation.p95 = summary.p95;
  evaluation.maxError = summary.maxError;
  evaluation.bias = summary.bias;
  for (const TrajectoryCamera& camera : cameras)
    evaluation.cameraBiases.push_back(computeCameraBias(camera, errors));
}

Result<Evaluation> evaluateTarget(const std::string& target, const Samples& estimate,
                                  const Samples& truth,
                                  const std::vector<TrajectoryCamera>& cameras, double gate) {
  const bool byFrame = haveFrames(estimate) && haveFrames(truth);
  if (!byFrame && !(haveTimes(estimate) && haveTimes(truth)))
    return failure(ErrorCode::Mismatch, "", target,
                   "trajectory and truth have neither frame numbers nor times in common");
  const std::vector<Pair> pairs =
      byFrame ? pairByFrame(estimate, truth) : pairByTime(estimate, truth);
  Evaluation evaluation;
  evaluation.target = target;
  const auto start = convergedAt(pairs, gate);
  std::vector<Eigen::Vector3d> all;
  std::vector<Eigen::Vector3d> settled;
  std::int64_t inside = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Pair& pair = pairs[i];
    const bool after = start && i >= *start;
    const bool present = pair.estimate != nullptr;
    if (after && (!present || !pair.estimate->isValid || pair.error().norm() >= gate))
      ++evaluation.lostFrameCount;
    if (!present) {
      ++evaluation.missingFrameCount;
      continue;
    }
    all.push_back(pair.error());
    if (after || !start) {
      settled.push_back(pair.error());
      inside += pair.isInside() ? 1 : 0;
    }
  }
  if (all.empty())
    return failure(ErrorCode::Mismatch, "", target, "no frame of the trajectory is in the truth");
  evaluation.comparedFrameCount = static_cast<std::int64_t>(all.size());
  evaluation.rmseOfAllFrames = rootMeanSquare(all);
  if (start)
    evaluation.convergenceFrameCount = static_cast<std::int64_t>(*start);
  evaluation.fractionInside95Ellipsoid =
      static_cast<double>(inside) / static_cast<double>(settled.size());
  fillStatistics(evaluation, settled, cameras);
  return evaluation;
}

} // namespace

Result<std::vector<Evaluation>> evaluate(const Trajectory& estimate, const Trajectory& truth,
                                         double gate) {
  if (!std::isfinite(gate) || gate <= 0.0)
    return failure(ErrorCode::BadValue, "", "gate", "it must be a positive number of meters");
  const auto& cameras =
      estimate.header.cameras.empty() ? truth.header.cameras : estimate.header.cameras;
  const auto names = targetNames(estimate);
  const auto truths = targetNames(truth);
  auto estimates = samplesByTarget(estimate);
  auto truthSamples = samplesByTarget(truth);
  std::vector<Evaluation> evaluations;
  for (const std::string& name : names) {
    const bool named = truthSamples.contains(name);
    if (!named && !(truths.size() == 1 && (names.size() == 1 || truths.front().empty())))
      continue;
    auto result = evaluateTarget(name, estimates[name], truthSamples[named ? name : truths.front()],
                                 cameras, gate);
    if (!result)
      return tl::make_unexpected(result.error());
    evaluations.push_back(std::move(*result));
  }
  if (evaluations.empty())
    return failure(ErrorCode::NotFound, "", "target", "no target of the trajectory has a truth");
  return evaluations;
}

} // namespace dewpoint::trajectory
