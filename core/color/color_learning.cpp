// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/color_learning.h"

#include "core/color/background_suppression.h"
#include "core/color/color_classifier.h"
#include "core/color/color_evidence.h"
#include "core/color/range_fit.h"
#include "core/color/sample_colors.h"

#include <algorithm>

namespace dewpoint::color {

namespace {

/// Whether one of several samples hardly matches.
bool leavesSampleOut(const ColorRanges& ranges, const std::vector<ColorSample>& samples) {
  constexpr double kHardly = 0.2; // of its colors
  const ColorClassifier classifier(ranges);
  const auto isLeftOut = [&](const ColorSample& sample) {
    const auto matching = std::ranges::count_if(sample.colors, [&](const BgrColor& color) {
      return classifier.matches(color[0], color[1], color[2]);
    });
    return !sample.isExcluded && !sample.colors.empty() &&
           static_cast<double>(matching) < kHardly * static_cast<double>(sample.colors.size());
  };
  return samples.size() > 1 && std::ranges::any_of(samples, isLeftOut);
}

ColorAssessment assessmentFrom(const ColorEvidence& evidence, const ColorRanges& ranges,
                               const std::vector<ColorSample>& samples,
                               const std::vector<cv::Mat>& images) {
  ColorAssessment assessment = assessRange(ranges, evidence, images);
  assessment.isSampleLeftOut = leavesSampleOut(ranges, samples);
  return assessment;
}

bool anyBackgroundImage(const std::vector<cv::Mat>& backgroundImages) {
  return std::ranges::any_of(backgroundImages, [](const cv::Mat& room) { return !room.empty(); });
}

} // namespace

Result<ColorRanges> learnRanges(const ColorEvidence& evidence) {
  const bool anyColor =
      std::ranges::any_of(evidence.targetColors,
                          [](const WeightedHsiColor& cell) { return cell.color.intensity > 0.0; });
  if (!anyColor) {
    return failure(ErrorCode::BadValue, {}, "samples", "all samples are black");
  }
  const auto target = withLightVariations(evidence.targetColors);
  const ColorRange one =
      withNarrowestHue(fitRange(target, evidence.restColors), target, evidence.restColors);
  return multicolorRanges(evidence, one).value_or(ColorRanges(one));
}

Result<LearnedColor> learnColor(const std::vector<ColorSample>& samples,
                                const std::vector<cv::Mat>& images) {
  const ColorEvidence evidence = collectColorEvidence(samples, images);
  return learnRanges(evidence).map([&](const ColorRanges& ranges) {
    return LearnedColor{ranges[0], assessColor(ranges, samples, images, evidence),
                        ranges.rangesAfterFirst()};
  });
}

ColorAssessment assessColor(const ColorRanges& ranges, const std::vector<ColorSample>& samples,
                            const std::vector<cv::Mat>& images) {
  return assessmentFrom(collectColorEvidence(samples, images, ranges), ranges, samples, images);
}

ColorAssessment assessColor(const ColorRanges& ranges, const std::vector<ColorSample>& samples,
                            const std::vector<cv::Mat>& images, const ColorEvidence& evidence) {
  return assessmentFrom(collectColorEvidence(samples, images, ranges, evidence), ranges, samples,
                        images);
}

ColorAssessment assessColorWithBackground(const ColorRanges& ranges,
                                          const std::vector<ColorSample>& samples,
                                          const std::vector<cv::Mat>& images,
                                          const std::vector<cv::Mat>& backgroundImages) {
  return assessColor(ranges, samples,
                     anyBackgroundImage(backgroundImages)
                         ? suppressBackgroundColors(ranges, images, backgroundImages)
                         : images);
}

Result<LearnedColor> learnColorWithBackground(const std::vector<ColorSample>& samples,
                                              const std::vector<cv::Mat>& images,
                                              const std::vector<cv::Mat>& backgroundImages,
                                              const std::vector<cv::Mat>& undecided) {
  const ColorEvidence evidence = collectColorEvidence(samples, images, std::nullopt, undecided);
  return learnRanges(evidence).map([&](const ColorRanges& ranges) {
    const auto shown = anyBackgroundImage(backgroundImages)
                           ? suppressBackgroundColors(ranges, images, backgroundImages)
                           : images;
    return LearnedColor{ranges[0], assessColor(ranges, samples, shown, evidence),
                        ranges.rangesAfterFirst()};
  });
}

} // namespace dewpoint::color
