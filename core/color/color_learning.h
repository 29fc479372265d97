// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/color/color_assessment.h"
#include "core/color/color_ranges.h"
#include "core/color/color_sample.h"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace dewpoint::color {

struct LearnedColor {
  ColorRange range;
  ColorAssessment assessment;
  std::vector<ColorRange> others{}; ///< ranges of a target of several colors, besides `range`

  ColorRanges ranges() const { return {range, others}; }
};

/// The range of hue, saturation and intensity with the greatest F1 score between what was sampled
/// and the rest of the images (one per camera of the project, empty where there is none). The
/// sampled colors are also taken a little lighter, darker and paler, as other positions in the room
/// will show them. An excluded sample counts as much background as a target is large. Where the
/// samples show several colors, each gets a range of its own if that separates much better than one
/// range for all. BadValue when no sample shows the target.
Result<LearnedColor> learnColor(const std::vector<ColorSample>& samples,
                                const std::vector<cv::Mat>& images);

/// The assessment alone, of ranges however they were made.
ColorAssessment assessColor(const ColorRanges& ranges, const std::vector<ColorSample>& samples,
                            const std::vector<cv::Mat>& images);

/// learnColor() for trackers that know the empty rooms, which are in the order of the images
/// (withoutBackgroundColors()). Pixels that are `undecided` (colorEvidence()) count for nothing.
Result<LearnedColor> learnColorWithBackground(const std::vector<ColorSample>& samples,
                                              const std::vector<cv::Mat>& images,
                                              const std::vector<cv::Mat>& rooms,
                                              const std::vector<cv::Mat>& undecided = {});

/// assessColor() for them.
ColorAssessment assessColorWithBackground(const ColorRanges& ranges,
                                          const std::vector<ColorSample>& samples,
                                          const std::vector<cv::Mat>& images,
                                          const std::vector<cv::Mat>& rooms);

/// The two steps of learnColor(), for callers that use the evidence, which is most of the work, for
/// other purposes as well: the ranges, from the evidence of the samples without ranges...
Result<ColorRanges> learnRanges(const ColorEvidence& evidence);
/// ... and the assessment of ranges in these images, which may be others than the evidence is
/// from.
ColorAssessment assessColor(const ColorRanges& ranges, const std::vector<ColorSample>& samples,
                            const std::vector<cv::Mat>& images, const ColorEvidence& evidence);

} // namespace dewpoint::color
