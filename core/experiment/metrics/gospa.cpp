// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/gospa.h"

#include "core/filter/assignment.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::experiment {

Gospa computeGospa(const TrackFrame& frame, const GospaSetup& setup) {
  const Eigen::MatrixXd distance = distances(frame);
  const auto power = [&](double value) { return std::pow(value, setup.order); };
  // A pair at the cutoff costs what a missed and a false target cost, so pairing as many as
  // possible at min(d, cutoff) is the same as leaving out pairs at will.
  const Eigen::MatrixXd cost =
      distance.unaryExpr([&](double value) { return power(std::min(value, setup.cutoff)); });
  const Assignment assignment = assignMinimumCost(cost);
  Gospa result;
  int pairs = 0;
  for (Eigen::Index row = 0; row < distance.rows(); ++row) {
    const Eigen::Index column = assignment.columnOfRow[static_cast<std::size_t>(row)];
    if (column == kUnassigned || distance(row, column) >= setup.cutoff)
      continue;
    ++pairs;
    result.localizationCost += cost(row, column);
  }
  result.missedTargetCount = static_cast<int>(distance.rows()) - pairs;
  result.falseTargetCount = static_cast<int>(distance.cols()) - pairs;
  result.missedTargetCost = result.missedTargetCount * power(setup.cutoff) / 2.0;
  result.falseTargetCost = result.falseTargetCount * power(setup.cutoff) / 2.0;
  result.distance =
      std::pow(result.localizationCost + result.missedTargetCost + result.falseTargetCost,
               1.0 / setup.order);
  return result;
}

GospaAverage averageGospa(std::span<const TrackFrame> frames, const GospaSetup& setup) {
  GospaAverage average;
  const double share = 1.0 / static_cast<double>(frames.size());
  for (const TrackFrame& frame : frames) {
    const Gospa one = computeGospa(frame, setup);
    average.mean += share * one.distance;
    average.localizationCost += share * one.localizationCost;
    average.missedTargetCost += share * one.missedTargetCost;
    average.falseTargetCost += share * one.falseTargetCost;
    average.missedTargetsPerFrame += share * one.missedTargetCount;
    average.falseTargetsPerFrame += share * one.falseTargetCount;
  }
  average.powerMean =
      std::pow(average.localizationCost + average.missedTargetCost + average.falseTargetCost,
               1.0 / setup.order);
  return average;
}

} // namespace dewpoint::experiment
