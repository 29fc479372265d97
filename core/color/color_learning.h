// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/color/color_assessment.h"
#include "core/color/color_ranges.h"
#include "core/color/color_sample.h"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace dewpoint::color {

/// A learned color with its assessment.
struct LearnedColor {
  ColorRange range;
  ColorAssessment assessment;
  std::vector<ColorRange>
      others{}; ///< further ranges of a target of several colors, besides `range`

  ColorRanges ranges() const { return {range, others}; }
};

/// Learns the range of hue, saturation and intensity with the highest F1 score between the sampled
/// colors and the rest of the images (one image per camera of the project, empty where there is
/// none). The sampled colors are also used a little lighter, darker and paler, as they will appear
/// in other positions in the room. An excluded sample counts as much background as the target is
/// large. If the samples have several colors, each color gets its own range, provided that this
/// separates much better than one range for all. Error: BadValue when no sample shows the target.
Result<LearnedColor> learnColor(const std::vector<ColorSample>& samples,
                                const std::vector<cv::Mat>& images);

/// Assesses ranges, wherever they come from, by samples and images.
ColorAssessment assessColor(const ColorRanges& ranges, const std::vector<ColorSample>& samples,
                            const std::vector<cv::Mat>& images);

/// learnColor() for trackers that know the background images, which are in the order of the images
/// (withoutBackgroundColors()). Pixels that are `undecided` (colorEvidence()) count for nothing.
Result<LearnedColor> learnColorWithBackground(const std::vector<ColorSample>& samples,
                                              const std::vector<cv::Mat>& images,
                                              const std::vector<cv::Mat>& rooms,
                                              const std::vector<cv::Mat>& undecided = {});

/// As assessColor(), for trackers that use background images.
ColorAssessment assessColorWithBackground(const ColorRanges& ranges,
                                          const std::vector<ColorSample>& samples,
                                          const std::vector<cv::Mat>& images,
                                          const std::vector<cv::Mat>& rooms);

/// First step of learnColor(): the ranges, from evidence that was collected without ranges. For
/// callers that use the evidence, which is most of the work, for other purposes too.
Result<ColorRanges> learnRanges(const ColorEvidence& evidence);
/// Second step of learnColor(): assesses ranges in these images, which may differ from those that
/// the evidence is from.
ColorAssessment assessColor(const ColorRanges& ranges, const std::vector<ColorSample>& samples,
                            const std::vector<cv::Mat>& images, const ColorEvidence& evidence);

} // namespace dewpoint::color
