// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/people/clothes_model.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::observation {
namespace {

// Origin of the values not recorded.

constexpr float kUnseenColorShare = 0.01F;   ///< of a color that was never observed
constexpr float kFastestRate = 0.05F;        ///< least gain of an update, 0 to 1
constexpr float kFewestUpdatePixels = 10.0F; ///< pixels, least of an update

int cell(int part, int whole, int low, int high) {
  // Percent of the whole, in eight cells from `low` to `high`.
  return std::clamp((100 * part / whole - low) * 8 / (high - low), 0, 7);
}

/// Calls `use(part, bgr)` for the pixels of a silhouette that move and are not covered.
template <class Use>
void forEachOwnPixel(const cv::Mat& image, const cv::Mat& mask, const BodySilhouette& silhouette,
                     const cv::Mat& covered, const Use& use) {
  if (!silhouette.isVisible) {
    return;
  }
  const cv::Rect whole(0, 0, mask.cols, mask.rows);
  for (std::size_t k = 0; k < kBodyPartCount; ++k) {
    const cv::Rect piece = silhouette.partRects[k] & whole;
    for (int row = piece.y; row < piece.y + piece.height; ++row) {
      for (int column = piece.x; column < piece.x + piece.width; ++column) {
        if (mask.at<std::uint8_t>(row, column) != 0 &&
            (covered.empty() || covered.at<std::uint8_t>(row, column) == 0)) {
          use(k < kBodyPartCount / 2 ? std::size_t{0} : std::size_t{1}, image.ptr(row, column));
        }
      }
    }
  }
}

} // namespace

std::size_t clothesBin(const std::uint8_t* bgr) {
  constexpr int kDark = 75; // sum of three channels, below which a pixel has no color
  const int sum = bgr[0] + bgr[1] + bgr[2];
  if (sum < kDark) {
    return kClothesBins - 1;
  }
  const int red = cell(bgr[2], sum, 17, 57);
  const int green = cell(bgr[1], sum, 17, 49);
  const int bright = sum < 210 ? 0 : sum < 390 ? 1 : 2;
  const int bin = (bright * 8 + green) * 8 + red;
  return static_cast<std::size_t>(bin);
}

void ClothesModel::learn(const cv::Mat& image, const cv::Mat& mask,
                         const BodySilhouette& silhouette, const cv::Mat& covered) {
  forEachOwnPixel(image, mask, silhouette, covered, [&](std::size_t part, const auto* bgr) {
    counts_[part][clothesBin(bgr)] += 1.0F;
  });
}

void ClothesModel::finishFrame() {
  bool learned = false;
  for (std::size_t part = 0; part < 2; ++part) {
    float sum = 0.0F;
    for (const float count : counts_[part]) {
      sum += count;
    }
    if (sum >= kFewestUpdatePixels) {
      learned = true;
      const float rate = std::max(kFastestRate, 1.0F / static_cast<float>(updateCount_ + 1));
      for (std::size_t bin = 0; bin < kClothesBins; ++bin) {
        shares_[part][bin] += rate * (counts_[part][bin] / sum - shares_[part][bin]);
      }
    }
    counts_[part].fill(0.0F);
  }
  updateCount_ += learned ? 1 : 0;
}

ClothesRatio ClothesModel::logRatioAgainst(const ClothesModel& other) const {
  ClothesRatio ratio{};
  if (!isKnown() || !other.isKnown()) {
    return ratio;
  }
  for (std::size_t part = 0; part < 2; ++part) {
    for (std::size_t bin = 0; bin < kClothesBins; ++bin) {
      const float own = shares_[part][bin] + kUnseenColorShare;
      const float others = other.shares_[part][bin] + kUnseenColorShare;
      ratio[part][bin] = std::clamp(std::log(own / others), -1.0F, 1.0F);
    }
  }
  return ratio;
}

double ClothesModel::meanLogRatioInSilhouette(const ClothesRatio& ratio, const cv::Mat& image,
                                              const cv::Mat& mask, const BodySilhouette& silhouette,
                                              const cv::Mat& covered) {
  double sum = 0.0;
  double count = 0.0;
  forEachOwnPixel(image, mask, silhouette, covered, [&](std::size_t part, const auto* bgr) {
    sum += static_cast<double>(ratio[part][clothesBin(bgr)]);
    count += 1.0;
  });
  return count >= static_cast<double>(kFewestUpdatePixels) ? sum / count : 0.0;
}

} // namespace dewpoint::observation
