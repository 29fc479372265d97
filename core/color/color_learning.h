// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/color/color_assessment.h"
#include "core/color/color_ranges.h"
#include "core/color/color_sample.h"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace dewpoint::color {

/// Learned color and its assessment.
struct LearnedColor {
  ColorRange range;
  ColorAssessment assessment;
  std::vector<ColorRange>
      others{}; ///< additional ranges for a multicolored target, besides `range`

  /// Returns all learned ranges.
  ColorRanges ranges() const { return {range, others}; }
};

/// Learns the range of hue, saturation and intensity with the highest F1 score between the sampled
/// colors and the rest of the images (one image per camera in the project, empty where there is
/// none). The sampled colors are also used slightly lighter, darker and paler, as they will appear
/// in other positions in the room. An excluded sample counts as background, with the same weight as
/// the target. If the samples have several colors, each color gets its own range, provided that
/// this separates much better than one range for all. Error: BadValue if no sample shows the
/// target.
Result<LearnedColor> learnColor(const std::vector<ColorSample>& samples,
                                const std::vector<cv::Mat>& images);

/// Assesses any ranges using samples and images.
ColorAssessment assessColor(const ColorRanges& ranges, const std::vector<ColorSample>& samples,
                            const std::vector<cv::Mat>& images);

/// Same as learnColor(), for trackers that use background images. `backgroundImages` has the same
/// order as `images`; see withoutBackgroundColors(). Pixels that are marked in `undecided` are
/// ignored; see colorEvidence().
Result<LearnedColor> learnColorWithBackground(const std::vector<ColorSample>& samples,
                                              const std::vector<cv::Mat>& images,
                                              const std::vector<cv::Mat>& backgroundImages,
                                              const std::vector<cv::Mat>& undecided = {});

/// Same as assessColor(), for trackers that use background images.
ColorAssessment assessColorWithBackground(const ColorRanges& ranges,
                                          const std::vector<ColorSample>& samples,
                                          const std::vector<cv::Mat>& images,
                                          const std::vector<cv::Mat>& backgroundImages);

/// First step of learnColor(): finds the ranges, from evidence that was collected without ranges.
/// Intended for callers that also use the evidence for other purposes, because collecting it is
/// most of the work.
Result<ColorRanges> learnRanges(const ColorEvidence& evidence);
/// Second step of learnColor(): assesses ranges in these images, which may differ from the images
/// of the evidence.
ColorAssessment assessColor(const ColorRanges& ranges, const std::vector<ColorSample>& samples,
                            const std::vector<cv::Mat>& images, const ColorEvidence& evidence);

} // namespace dewpoint::color
