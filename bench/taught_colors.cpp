// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/taught_colors.h"

#include "core/color/color_evidence.h"
#include "core/color/color_learning.h"
#include "core/color/likelihood/target_color_model.h"
#include "core/color/match_image.h"
#include "core/color/range_fit.h"

#include <cstdint>

namespace dewpoint::bench {
namespace {

constexpr ColorRange kEveryColor{0.0, 360.0};

PixelClassifier byRange(const std::string& name, const ColorRange& range) {
  return {name, [classifier = ColorClassifier(range)](const cv::Mat& bgr) {
            const cv::Mat match = matchImage(bgr, classifier);
            cv::Mat values(bgr.size(), CV_8SC1, cv::Scalar(-1));
            values.setTo(1, match);
            return values;
          }};
}

PixelClassifier byTable(const std::string& name, const ColorLikelihood& table) {
  return {name, [table](const cv::Mat& bgr) {
            cv::Mat values(bgr.size(), CV_8SC1);
            for (int row = 0; row < bgr.rows; ++row) {
              table.computeLogRatioRow(bgr.ptr<std::uint8_t>(row), bgr.cols,
                                       values.ptr<std::int8_t>(row));
            }
            return values;
          }};
}

} // namespace

LearnedColors learnFromSamples(const std::vector<ColorSample>& samples,
                               const std::vector<cv::Mat>& images) {
  const ColorEvidence evidence = collectColorEvidence(samples, images);
  const auto ranges = learnRanges(evidence);
  if (!ranges) {
    return {};
  }
  const ColorRange& range = (*ranges)[0]; // the clicks are on things of one color
  const double ratio = restPixelsPerTargetPixel(evidence);
  TargetColorModel unlimited(range, kEveryColor);
  unlimited.add(evidence.targetColors);
  return {range,
          assessColor(range, samples, images, evidence).separability,
          {byRange("range", range), byTable("table", learnLikelihood(evidence, range, ratio)),
           byTable("no limits", unlimited.likelihoodForCamera({}, evidence.restColors, ratio)),
           byTable("likelihood", learnLikelihood(evidence, range))}};
}

void TruthLearner::add(const cv::Mat& bgr, const ColorTruth& truth) {
  target_.add(bgr, ~(truth.target & truth.whole));
  rest_.add(bgr, truth.target | ~truth.whole);
}

std::vector<PixelClassifier> TruthLearner::colors() const {
  if (target_.totalWeight() <= 0.0 || rest_.totalWeight() <= 0.0) {
    return {};
  }
  const auto target = target_.colors();
  const auto rest = rest_.colors();
  const ColorRange range = withNarrowestHue(fitRange(target, rest), target, rest);
  TargetColorModel model(range, kEveryColor);
  model.add(target);
  return {byRange("best box", range),
          byTable("best table", model.likelihoodForCamera(
                                    {}, rest, rest_.totalWeight() / target_.totalWeight()))};
}

} // namespace dewpoint::bench
