// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bench/color_score.h"
#include "core/color/color_range.h"
#include "core/color/color_sample.h"
#include "core/color/hsi_counts.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace dewpoint::bench {

/// A way to tell a target's pixels by their color: a column of the benchmark.
struct PixelClassifier {
  std::string name;
  /// CV_8SC1 of an image (CV_8UC3): above 0 where it takes a pixel for the target's.
  std::function<cv::Mat(const cv::Mat& bgr)> values;
};

/// What samples in images teach, and nothing if there is nothing to learn:
///   range       the range of hue, saturation and intensity
///   table       log ratios of color, pixels weighed as for the range, which is prior and limits
///   no limits   the same with the range as the prior only
///   likelihood  as the table, but the target as likely at each pixel as the rest together
struct LearnedColors {
  static constexpr std::size_t kColors = 4;

  ColorRange range;
  double separability = 0.0; ///< how well the range tells the target apart
  std::vector<PixelClassifier> colors;
};
LearnedColors learnFromSamples(const std::vector<ColorSample>& samples,
                               const std::vector<cv::Mat>& images);

/// What the very images that are judged teach when the truth is told: about the most that a range
/// or a table can do.
class TruthLearner {
public:
  void add(const cv::Mat& bgr, const ColorTruth& truth);
  /// best box: a range; best table: without limits. Nothing if the target was nowhere.
  std::vector<PixelClassifier> colors() const;

private:
  HsiCounts target_;
  HsiCounts rest_;
};

} // namespace dewpoint::bench
