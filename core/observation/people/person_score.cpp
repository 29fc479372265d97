// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/people/person_score.h"

#include "core/observation/people/body_silhouette.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dewpoint::observation {

cv::Mat maskScores(const cv::Mat& mask, const cv::Mat& explained) {
  constexpr double kMoving =
      ScoreSums::kZeroScoreByte + kMovingPixel * ScoreSums::kByteChangePerScore;
  constexpr double kStill =
      ScoreSums::kZeroScoreByte + kStillPixel * ScoreSums::kByteChangePerScore;
  cv::Mat scores;
  mask.convertTo(scores, CV_8UC1, (kMoving - kStill) / 255.0, kStill);
  if (!explained.empty()) {
    scores.setTo(ScoreSums::kZeroScoreByte, explained);
  }
  return scores;
}

void addColorScores(const cv::Mat& image, const cv::Mat& mask, const cv::Rect& area, int waist,
                    const ClothesRatio& ratio, double weight, cv::Mat& scores) {
  const cv::Rect inside = area & cv::Rect(0, 0, mask.cols, mask.rows);
  const double scale = weight * ScoreSums::kByteChangePerScore;
  std::array<std::array<int, kClothesBins>, 2> steps;
  for (std::size_t part = 0; part < 2; ++part) {
    for (std::size_t bin = 0; bin < kClothesBins; ++bin) {
      steps[part][bin] = static_cast<int>(std::lround(scale * ratio[part][bin]));
    }
  }
  for (int row = inside.y; row < inside.y + inside.height; ++row) {
    const auto& table = steps[row < waist ? 1 : 0];
    const auto* moving = mask.ptr<std::uint8_t>(row);
    const auto* colors = image.ptr<std::uint8_t>(row);
    auto* out = scores.ptr<std::uint8_t>(row);
    for (int column = inside.x; column < inside.x + inside.width; ++column) {
      if (moving[column] != 0) {
        const int score = out[column] + table[clothesBin(colors + std::ptrdiff_t{3} * column)];
        out[column] = static_cast<std::uint8_t>(std::clamp(score, 0, 255));
      }
    }
  }
}

} // namespace dewpoint::observation
