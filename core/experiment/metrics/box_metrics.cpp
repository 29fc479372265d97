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

BoxFigures measureBoxes(std::span<const std::optional<ImageBox>> found,
                        std::span<const ImageBox> truth, double radius) {
  assert(found.size() == truth.size() && found.size() > 1 && found.front());
  BoxFigures figures;
  ImageBox last = *found.front();
  for (std::size_t frame = 1; frame < found.size(); ++frame) {
    last = found[frame].value_or(last);
    const double distance = (last.center() - truth[frame].center()).norm();
    figures.rmse += distance * distance;
    if (found[frame]) {
      figures.success += successOf(overlap(*found[frame], truth[frame]));
      figures.precision += distance <= radius ? 1.0 : 0.0;
    }
  }
  const double count = double(found.size() - 1);
  figures.rmse = std::sqrt(figures.rmse / count);
  figures.success /= count;
  figures.precision /= count;
  return figures;
}

} // namespace dewpoint::experiment
