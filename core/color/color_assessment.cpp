// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/color_assessment.h"

#include "core/color/color_evidence.h"
#include "core/color/color_region.h"
#include "core/color/hsi.h"
#include "core/color/match_image.h"
#include "core/color/range_fit.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

namespace dewpoint::color {
namespace {

/// An object that matters as a distractor: this share of the target's size, and no speckle.
constexpr double kDistractorShare = 0.1;
constexpr double kSmallestDistractor = 9.0; ///< pixels
constexpr double kDark = 0.08;              ///< intensity
constexpr double kBright = 0.94;            ///< intensity, with kPale
constexpr double kPale = 0.12;              ///< saturation
constexpr double kMostOfImage = 0.25;       ///< that a target fills
/// Share of an image: a shadow in an object, rather than an object.
constexpr double kSpeck = 1.0 / 5000.0;
constexpr double kLow = 0.4;             ///< F1 score, or share of the target
constexpr double kDistinguishable = 3.0; ///< colorDistance()
constexpr double kOneObject = 0.5;       ///< of all that matches beside the target
/// How much larger or smaller the area of an object is that may be the target's like: it may stand
/// nearer or farther away. Chosen.
constexpr double kAlikeFactor = 3.0;
constexpr int kMostAlike = 6; ///< of more nobody follows each. Chosen

template <class Third> Third third(double at, double size) {
  return static_cast<Third>(std::clamp(static_cast<int>(3.0 * at / size), 0, 2));
}

BgrColor meanColor(const cv::Mat& image, const cv::Mat& mask) {
  const cv::Scalar mean = cv::mean(image, mask);
  BgrColor color{};
  for (int i = 0; i < 3; ++i) {
    color[std::size_t(i)] = cv::saturate_cast<std::uint8_t>(mean[i]);
  }
  return color;
}

struct FoundRegion {
  DistractorRegion region;
  double area = 0.0;
  BgrColor color{};
};

FoundRegion described(int camera, const cv::Mat& image, const cv::Mat& labels, int label,
                      const cv::Mat& statistics, const cv::Mat& centers) {
  FoundRegion found;
  found.area = statistics.at<int>(label, cv::CC_STAT_AREA);
  DistractorRegion& region = found.region;
  region.camera = camera;
  region.box = {
      statistics.at<int>(label, cv::CC_STAT_LEFT), statistics.at<int>(label, cv::CC_STAT_TOP),
      statistics.at<int>(label, cv::CC_STAT_WIDTH), statistics.at<int>(label, cv::CC_STAT_HEIGHT)};
  region.shareOfImage = found.area / double(image.total());
  region.horizontalThird = third<HorizontalThird>(centers.at<double>(label, 0), image.cols);
  region.verticalThird = third<VerticalThird>(centers.at<double>(label, 1), image.rows);
  const cv::Mat mask = labels(region.box) == label;
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(mask, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_SIMPLE, region.box.tl());
  region.outline =
      *std::ranges::max_element(outlines, {}, [](const auto& outline) { return outline.size(); });
  found.color = meanColor(image(region.box), mask);
  region.color = nameOfColor(found.color);
  return found;
}

void addRegions(int camera, const cv::Mat& image, const cv::Mat& targetMask,
                const ColorClassifier& classifier, double smallest,
                std::vector<FoundRegion>& found) {
  cv::Mat match = matchImage(image, classifier);
  match.setTo(0, targetMask);
  // Parts of one object that touch but for a pixel are one object to a person.
  cv::morphologyEx(match, match, cv::MORPH_CLOSE, cv::Mat::ones(3, 3, CV_8UC1));
  cv::Mat labels;
  cv::Mat statistics;
  cv::Mat centers;
  const int count = cv::connectedComponentsWithStats(match, labels, statistics, centers);
  for (int i = 1; i < count; ++i) {
    if (statistics.at<int>(i, cv::CC_STAT_AREA) >= smallest) {
      found.push_back(described(camera, image, labels, i, statistics, centers));
    }
  }
}

/// Whether nobody could tell this from the target.
bool isAlike(const FoundRegion& region, const ColorEvidence& evidence) {
  return region.area < kAlikeFactor * evidence.targetAreaPx &&
         kAlikeFactor * region.area > evidence.targetAreaPx &&
         colorDistance(region.color, evidence.typicalColor) <= kDistinguishable;
}

/// As ColorAssessment::similarObjectCount; only images in which the target is told from the rest
/// count.
int countAlike(const ColorEvidence& evidence, const std::vector<FoundRegion>& found) {
  int most = 0;
  for (std::size_t camera = 0; camera < evidence.targetMasks.size(); ++camera) {
    const cv::Mat& mask = evidence.targetMasks[camera];
    const auto count = std::ranges::count_if(found, [&](const FoundRegion& region) {
      return region.region.camera == static_cast<int>(camera) && isAlike(region, evidence);
    });
    if (count > most && cv::countNonZero(mask) > 0) {
      most = static_cast<int>(count);
    }
  }
  return 1 + most;
}

ColorSuggestion suggestionFor(const ColorAssessment& assessment, const ColorEvidence& evidence,
                              const std::vector<FoundRegion>& found) {
  const BgrColor& color = evidence.typicalColor;
  const Hsi typical = hsiFromBgr(color[0], color[1], color[2]);
  if (typical.intensity < kDark) {
    return ColorSuggestion::MoreLight;
  }
  if (typical.intensity > kBright && typical.saturation < kPale) {
    return ColorSuggestion::LessExposure;
  }
  if (evidence.targetShareOfImage > kMostOfImage) {
    return ColorSuggestion::ClickObjectItself;
  }
  if (typical.saturation < kPale && assessment.isGood()) {
    return ColorSuggestion::UseStrongerColor; // the next change of light makes it like the walls
  }
  if (assessment.isGood()) {
    return ColorSuggestion::None;
  }
  if (assessment.separability < kLow && assessment.targetShare < kLow &&
      evidence.targetShareOfImage < kSpeck) {
    return ColorSuggestion::ClickMore;
  }
  if (assessment.missesTarget() && found.empty()) {
    return ColorSuggestion::AddSamples;
  }
  if (typical.saturation < kPale) {
    return ColorSuggestion::UseStrongerColor;
  }
  double all = 0.0;
  double alike = 0.0;
  for (const FoundRegion& region : found) {
    all += region.area;
    alike += isAlike(region, evidence) ? region.area : 0.0;
  }
  if (assessment.similarObjectCount > 1 && assessment.similarObjectCount <= kMostAlike &&
      alike > kOneObject * all) {
    return ColorSuggestion::FollowAll;
  }
  if (!found.empty() && found.front().area > kOneObject * all) {
    return colorDistance(found.front().color, color) > kDistinguishable
               ? ColorSuggestion::ExcludeDistractor
               : ColorSuggestion::RemoveDistractor;
  }
  return found.empty() ? ColorSuggestion::None : ColorSuggestion::UseAnotherColor;
}

} // namespace

ColorName nameOfColor(const BgrColor& bgr) {
  const Hsi color = hsiFromBgr(bgr[0], bgr[1], bgr[2]);
  if (color.intensity < 0.12) {
    return ColorName::Black;
  }
  if (std::isnan(color.hueDegrees) || color.saturation < 0.12) {
    return color.intensity > 0.8 ? ColorName::White : ColorName::Gray;
  }
  struct Until {
    double hue;
    ColorName word;
  };
  static constexpr std::array<Until, 9> kWords{{{14.0, ColorName::Red},
                                                {42.0, ColorName::Orange},
                                                {68.0, ColorName::Yellow},
                                                {160.0, ColorName::Green},
                                                {195.0, ColorName::Turquoise},
                                                {258.0, ColorName::Blue},
                                                {292.0, ColorName::Purple},
                                                {346.0, ColorName::Pink},
                                                {360.0, ColorName::Red}}};
  const auto word = std::ranges::find_if(
      kWords, [&](const Until& until) { return color.hueDegrees <= until.hue; });
  const bool warm = color.hueDegrees < 50.0;
  return warm && color.hueDegrees > 8.0 && color.intensity < 0.4 ? ColorName::Brown : word->word;
}

ColorAssessment assessRange(const ColorRanges& ranges, const ColorEvidence& evidence,
                            const std::vector<cv::Mat>& images) {
  const RangeScore score = scoreRange(ranges, evidence.targetColors, evidence.restColors);
  ColorAssessment assessment;
  assessment.separability = score.f1;
  assessment.targetShare =
      evidence.targetWeight > 0.0 ? score.targetWeight / evidence.targetWeight : 0.0;
  assessment.backgroundShare =
      evidence.restWeight > 0.0 ? score.restWeight / evidence.restWeight : 0.0;
  assessment.isTargetKnown = evidence.targetWeight > 0.0;
  if (!assessment.isTargetKnown) {
    return assessment;
  }
  if (assessment.missesTarget()) {
    const RangeScore whole = scoreRange(evidence.typicalRanges, {}, evidence.restColors);
    assessment.backgroundShareOfFullRange =
        evidence.restWeight > 0.0 ? whole.restWeight / evidence.restWeight : 0.0;
  }
  std::vector<FoundRegion> found;
  const ColorClassifier classifier(ranges);
  const double smallest = std::max(kSmallestDistractor, kDistractorShare * evidence.targetAreaPx);
  for (std::size_t i = 0; i < images.size(); ++i) {
    if (!evidence.targetMasks[i].empty()) {
      addRegions(int(i), images[i], evidence.targetMasks[i], classifier, smallest, found);
    }
  }
  std::ranges::stable_sort(found, std::greater(), &FoundRegion::area);
  assessment.similarObjectCount = countAlike(evidence, found);
  assessment.suggestion = suggestionFor(assessment, evidence, found);
  found.resize(std::min(found.size(), ColorAssessment::kMaxDistractors));
  for (FoundRegion& region : found) {
    assessment.distractors.push_back(std::move(region.region));
  }
  return assessment;
}

} // namespace dewpoint::color
