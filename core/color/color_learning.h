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
      otherRanges{}; ///< additional ranges for a multicolored target, besides `range`

  /// Returns all learned ranges.
  ColorRanges ranges() const { return {range, otherRanges}; }
};

/// Learns the range of hue, saturation and intensity that best separates the sampled colors from
/// the rest of the images, measured by the F1 score. `images` has one entry per camera in the
/// project, which is empty if there is no image. The sampled colors are also used slightly lighter,
/// darker and paler, as they will appear in other positions in the room. An excluded sample counts
/// as background, with the same weight as the target. If the samples have several colors, each
/// color gets its own range, provided that several ranges separate the target from the rest much
/// better than one range. Error: BadValue if no sample shows the target.
Result<LearnedColor> learnColor(const std::vector<ColorSample>& samples,
                                const std::vector<cv::Mat>& images);

/// Assesses how well any color ranges, learned or not, separate the target of the samples from the
/// rest of the images.
ColorAssessment assessColor(const ColorRanges& ranges, const std::vector<ColorSample>& samples,
                            const std::vector<cv::Mat>& images);

/// Learns a color like learnColor(), but for trackers that use background images: for the
/// assessment, background pixels with the learned color are painted black
/// (suppressBackgroundColors()). `backgroundImages` has the same order as `images`. Pixels that are
/// marked in `undecided` are ignored; see collectColorEvidence().
Result<LearnedColor> learnColorWithBackground(const std::vector<ColorSample>& samples,
                                              const std::vector<cv::Mat>& images,
                                              const std::vector<cv::Mat>& backgroundImages,
                                              const std::vector<cv::Mat>& undecided = {});

/// Assesses color ranges like assessColor(), but for trackers that use background images:
/// background pixels that match `ranges` are painted black first (suppressBackgroundColors()).
ColorAssessment assessColorWithBackground(const ColorRanges& ranges,
                                          const std::vector<ColorSample>& samples,
                                          const std::vector<cv::Mat>& images,
                                          const std::vector<cv::Mat>& backgroundImages);

/// First step of learnColor(): finds the ranges from evidence that collectColorEvidence() collected
/// without its argument `ranges`. Call it instead of learnColor() if you also need the evidence for
/// another purpose, because collecting the evidence takes most of the time.
Result<ColorRanges> learnRanges(const ColorEvidence& evidence);
/// Second step of learnColor(): assesses ranges in these images, which may differ from the images
/// of the evidence.
ColorAssessment assessColor(const ColorRanges& ranges, const std::vector<ColorSample>& samples,
                            const std::vector<cv::Mat>& images, const ColorEvidence& evidence);

} // namespace dewpoint::color
