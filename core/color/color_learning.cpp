// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/color_learning.h"

#include "core/color/background_suppression.h"
#include "core/color/color_classifier.h"
#include "core/color/color_evidence.h"
#include "core/color/range_fit.h"

#include <algorithm>

namespace dewpoint::color {

namespace {

/// Whether one of several samples hardly matches.
bool leavesSampleOut(const ColorRange& range, const std::vector<ColorSample>& samples) {
  constexpr double kHardly = 0.2; // of its colors
  const ColorClassifier classifier(range);
  const auto isLeftOut = [&](const ColorSample& sample) {
    const auto matching = std::ranges::count_if(sample.colors, [&](const BgrColor& color) {
      return classifier.matches(color[0], color[1], color[2]);
    });
    return !sample.excluded && !sample.colors.empty() &&
           static_cast<double>(matching) < kHardly * static_cast<double>(sample.colors.size());
  };
  return samples.size() > 1 && std::ranges::any_of(samples, isLeftOut);
}

ColorAssessment assessmentFrom(const ColorEvidence& evidence, const ColorRange& range,
                               const std::vector<ColorSample>& samples,
                               const std::vector<cv::Mat>& images) {
  ColorAssessment assessment = assessRange(range, evidence, images);
  assessment.sampleLeftOut = leavesSampleOut(range, samples);
  return assessment;
}

bool anyRoom(const std::vector<cv::Mat>& rooms) {
  return std::ranges::any_of(rooms, [](const cv::Mat& room) { return !room.empty(); });
}

} // namespace

Result<ColorRange> learnRange(const ColorEvidence& evidence) {
  const bool anyColor = std::ranges::any_of(
      evidence.target, [](const HsiColors& cell) { return cell.color.intensity > 0.0; });
  if (!anyColor) {
    return failure(ErrorCode::BadValue, {}, "samples",
                   "none of them shows a target that is not black");
  }
  const auto target = inOtherLight(evidence.target);
  return withShortestHue(fitRange(target, evidence.rest), target, evidence.rest);
}

Result<LearnedColor> learnColor(const std::vector<ColorSample>& samples,
                                const std::vector<cv::Mat>& images) {
  const ColorEvidence evidence = colorEvidence(samples, images);
  return learnRange(evidence).map([&](const ColorRange& range) {
    return LearnedColor{range, assessColor(range, samples, images, evidence)};
  });
}

ColorAssessment assessColor(const ColorRange& range, const std::vector<ColorSample>& samples,
                            const std::vector<cv::Mat>& images) {
  return assessmentFrom(colorEvidence(samples, images, range), range, samples, images);
}

ColorAssessment assessColor(const ColorRange& range, const std::vector<ColorSample>& samples,
                            const std::vector<cv::Mat>& images, const ColorEvidence& evidence) {
  return assessmentFrom(colorEvidence(samples, images, range, evidence), range, samples, images);
}

ColorAssessment assessColorWithBackground(const ColorRange& range,
                                          const std::vector<ColorSample>& samples,
                                          const std::vector<cv::Mat>& images,
                                          const std::vector<cv::Mat>& rooms) {
  return assessColor(range, samples,
                     anyRoom(rooms) ? withoutBackgroundColors(range, images, rooms) : images);
}

Result<LearnedColor> learnColorWithBackground(const std::vector<ColorSample>& samples,
                                              const std::vector<cv::Mat>& images,
                                              const std::vector<cv::Mat>& rooms,
                                              const std::vector<cv::Mat>& undecided) {
  const ColorEvidence evidence = colorEvidence(samples, images, std::nullopt, undecided);
  return learnRange(evidence).map([&](const ColorRange& range) {
    const auto shown = anyRoom(rooms) ? withoutBackgroundColors(range, images, rooms) : images;
    return LearnedColor{range, assessColor(range, samples, shown, evidence)};
  });
}

} // namespace dewpoint::color
