// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_range.h"
#include "core/color/color_sample.h"
#include "core/color/hsi_counts.h"

#include <opencv2/core/mat.hpp>

#include <optional>
#include <vector>

namespace dewpoint::color {

/// The evidence of samples and images about a color: what is target, and what is not. Weights are
/// pixels.
struct ColorEvidence {
  std::vector<HsiColors> target;
  std::vector<HsiColors> rest;
  double targetWeight = 0.0;
  double restWeight = 0.0;
  double targetArea = 0.0; ///< mean pixels of the samples: how large the target is in an image
  double imageShare = 0.0; ///< of the smallest image that targetArea takes, 0 to 1
  BgrColor typicalColor{}; ///< the median of what was sampled
  /// Per camera, CV_8UC1: 255 where the target is or may be, so that it is no evidence about the
  /// rest. Empty where there is no image.
  std::vector<cv::Mat> targetMasks;
  /// The images it was collected from (pixels are shared, not copied), and per camera, CV_8UC1: 255
  /// where the image still shows what was clicked; empty where it does nowhere.
  std::vector<cv::Mat> images;
  std::vector<cv::Mat> clicked;
};

/// The target in an image is the region grown from a click, where the image still shows the clicked
/// object; elsewhere the one connected object of its color that is about as large. With a `range`,
/// all parts of that object that match it belong to the target.
ColorEvidence colorEvidence(const std::vector<ColorSample>& samples,
                            const std::vector<cv::Mat>& images,
                            const std::optional<ColorRange>& range = std::nullopt);

/// The same as colorEvidence(samples, images, range), from what was collected `before` of the same
/// samples: regions are grown only in images that have other pixels by now.
ColorEvidence colorEvidence(const std::vector<ColorSample>& samples,
                            const std::vector<cv::Mat>& images, const ColorRange& range,
                            const ColorEvidence& before);

/// The target's colors as other positions and times will show them: lighter and darker, paler and
/// fuller, a little of another hue. The weight stays.
std::vector<HsiColors> inOtherLight(const std::vector<HsiColors>& colors);

} // namespace dewpoint::color
