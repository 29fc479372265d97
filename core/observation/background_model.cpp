// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/background_model.h"

#include "core/observation/label_image.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace dewpoint {
namespace {

constexpr int kRowPhases = 4;      ///< every frame learns every fourth row
constexpr int kLearned = 3;        ///< agreeing observations that make a pixel known
constexpr int kMostConfident = 16; ///< and that are remembered at most
constexpr int kReplaceAfter = 24;  ///< observations of something new that replace the old
/// A color is the usual one within this many gray levels (sensor noise) and a share of the mean
/// (light that changes a little).
constexpr int kTolerance = 14;
constexpr int kToleranceDivisor = 10;

bool agrees(const std::uint8_t* pixel, const std::uint8_t* mean) {
  int worst = -255;
  for (int channel = 0; channel < 3; ++channel) {
    const int allowed = kTolerance + mean[channel] / kToleranceDivisor;
    worst = std::max(worst, std::abs(int(pixel[channel]) - int(mean[channel])) - allowed);
  }
  return worst <= 0;
}

/// One step of the mean towards the new value: a share of the difference, at least one level.
std::uint8_t approached(std::uint8_t mean, std::uint8_t value, int divisor) {
  const int difference = int(value) - int(mean);
  const int rounded = (2 * difference + (difference > 0 ? divisor : -divisor)) / (2 * divisor);
  return static_cast<std::uint8_t>(mean + rounded);
}

} // namespace

void BackgroundModel::reset() {
  mean_ = cv::Mat();
  novelShare_ = 0.0;
  phase_ = 0;
}

void BackgroundModel::learn(const cv::Mat& image, const std::vector<Hidden>& hidden) {
  if (image.empty()) {
    return;
  }
  if (mean_.size() != image.size()) {
    mean_ = image.clone();
    confidence_ = cv::Mat::zeros(image.size(), CV_8UC1);
    novel_ = cv::Mat::zeros(image.size(), CV_8UC1);
  }
  seen_ = 0;
  news_ = 0;
  for (int row = phase_; row < image.rows; row += kRowPhases) {
    learnRow(image, row, hidden);
  }
  phase_ = (phase_ + 1) % kRowPhases;
  novelShare_ = seen_ > 0 ? static_cast<double>(news_) / static_cast<double>(seen_) : 0.0;
}

void BackgroundModel::learnRow(const cv::Mat& image, int row, const std::vector<Hidden>& hidden) {
  const std::uint8_t* pixel = image.ptr<std::uint8_t>(row);
  std::uint8_t* mean = mean_.ptr<std::uint8_t>(row);
  std::uint8_t* confidence = confidence_.ptr<std::uint8_t>(row);
  std::uint8_t* novel = novel_.ptr<std::uint8_t>(row);
  const auto learnPixels = [&](int begin, int end) {
    for (int column = begin; column < end; ++column) {
      const std::uint8_t* value = pixel + 3 * column;
      std::uint8_t* old = mean + 3 * column;
      const bool known = confidence[column] >= kLearned;
      const bool usual = agrees(value, old);
      if (usual) {
        const int divisor = std::min<int>(confidence[column] + 1, 8);
        for (int channel = 0; channel < 3; ++channel) {
          old[channel] = approached(old[channel], value[channel], divisor);
        }
        confidence[column] =
            static_cast<std::uint8_t>(std::min<int>(confidence[column] + 1, kMostConfident));
        novel[column] = 0;
      } else if (!known || ++novel[column] >= kReplaceAfter) {
        std::copy_n(value, 3, old);
        confidence[column] = 1;
        novel[column] = 0;
      }
      seen_ += known ? 1 : 0;
      news_ += known && !usual ? 1 : 0;
    }
  };
  int begin = 0;
  while (begin < image.cols) {
    // The next stretch of the row that no target hides.
    int end = image.cols;
    for (const Hidden& circle : hidden) {
      const double above = row - circle.center.y();
      const double half2 = circle.radius * circle.radius - above * above;
      if (half2 <= 0.0) {
        continue;
      }
      const double half = std::sqrt(half2);
      const int left =
          static_cast<int>(std::clamp(circle.center.x() - half, 0.0, 1.0 * image.cols));
      const int right =
          static_cast<int>(std::clamp(circle.center.x() + half + 1.0, 0.0, 1.0 * image.cols));
      if (begin >= left && begin < right) {
        begin = right;
      } else if (left > begin) {
        end = std::min(end, left);
      }
    }
    if (begin < end) {
      learnPixels(begin, end);
    }
    begin = std::max(begin, end);
  }
}

void BackgroundModel::labelRow(const cv::Mat& image, int column, int row, int count,
                               std::uint8_t* labels) const {
  if (mean_.size() != image.size()) {
    std::fill_n(labels, count, static_cast<std::uint8_t>(PixelLabel::Unlearned));
    return;
  }
  const std::uint8_t* pixel = image.ptr<std::uint8_t>(row) + 3 * column;
  const std::uint8_t* mean = mean_.ptr<std::uint8_t>(row) + 3 * column;
  const std::uint8_t* confidence = confidence_.ptr<std::uint8_t>(row) + column;
  for (int k = 0; k < count; ++k) {
    const auto usual =
        agrees(pixel + 3 * k, mean + 3 * k) ? PixelLabel::Background : PixelLabel::Unknown;
    labels[k] =
        static_cast<std::uint8_t>(confidence[k] >= kLearned ? usual : PixelLabel::Unlearned);
  }
}

} // namespace dewpoint
