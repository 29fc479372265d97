// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/box_metrics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace dewpoint::experiment {
namespace {

constexpr int kThresholds = 21;

/// Mean over the thresholds of "above the threshold".
double successOf(double share) {
  int above = 0;
  for (int k = 0; k < kThresholds; ++k) {
    above += share > k / double(kThresholds - 1) ? 1 : 0;
  }
  return above / double(kThresholds);
}

} // namespace

BoxMetrics measureBoxes(std::span<const std::optional<ImageBox>> found,
                        std::span<const ImageBox> truth, double radius) {
  assert(found.size() == truth.size() && found.size() > 1 && found.front());
  BoxMetrics metrics;
  ImageBox last = *found.front();
  for (std::size_t frame = 1; frame < found.size(); ++frame) {
    last = found[frame].value_or(last);
    const double distance = (last.center() - truth[frame].center()).norm();
    metrics.rmse += distance * distance;
    if (found[frame]) {
      metrics.success += successOf(intersectionOverUnion(*found[frame], truth[frame]));
      metrics.precision += distance <= radius ? 1.0 : 0.0;
    }
  }
  const double count = double(found.size() - 1);
  metrics.rmse = std::sqrt(metrics.rmse / count);
  metrics.success /= count;
  metrics.precision /= count;
  return metrics;
}

} // namespace dewpoint::experiment
