// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/color_learning.h"

#include "core/color/color_evidence.h"
#include "core/color/color_verdict.h"
#include "core/color/range_fit.h"

#include <algorithm>

namespace dewpoint {

Result<LearnedColor> learnColor(const std::vector<ColorSample>& samples,
                                const std::vector<cv::Mat>& images) {
  const ColorEvidence evidence = colorEvidence(samples, images);
  const bool anyColor = std::ranges::any_of(
      evidence.target, [](const HsiColors& cell) { return cell.color.intensity > 0.0; });
  if (!anyColor) {
    return failure(ErrorCode::BadValue, {}, "samples",
                   "none of them shows a target that is not black");
  }
  LearnedColor learned;
  learned.range = fitRange(inOtherLight(evidence.target), evidence.rest);
  learned.verdict = judgeColor(learned.range, samples, images);
  return learned;
}

ColorVerdict judgeColor(const ColorRange& range, const std::vector<ColorSample>& samples,
                        const std::vector<cv::Mat>& images) {
  return verdictOn(range, colorEvidence(samples, images, range), images);
}

} // namespace dewpoint
