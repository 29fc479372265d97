// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/people/body_silhouette.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace dewpoint::observation {

/// Number of color bins for clothes: 8 x 8 cells of chromaticity (shares of red and green), times
/// three of intensity, plus one for all colors too dark to have a hue.
inline constexpr std::size_t kClothesBins = 8 * 8 * 3 + 1;
/// Bin of a pixel (BGR).
std::size_t clothesBin(const std::uint8_t* bgr);

/// Log ratio log p(color | one person) / p(color | others), within [-1, 1], by color bin. [0]: from
/// the waist down; [1]: above the waist.
using ClothesRatio = std::array<std::array<float, kClothesBins>, 2>;

/// Clothes of a person, below and above the waist: color histograms over all cameras, learned while
/// the person is seen alone.
class ClothesModel {
public:
  /// Learns the moving pixels of a silhouette that others do not cover. `covered` is CV_8UC1, or
  /// empty.
  void learn(const cv::Mat& image, const cv::Mat& mask, const BodySilhouette& silhouette,
             const cv::Mat& covered);
  /// Ends a frame: all images learned since the last call count as one update.
  void finishFrame();
  /// Whether enough frames have been learned.
  bool known() const { return updateCount_ >= kEnoughUpdates; }
  /// Log ratio of this person's colors against those of another.
  ClothesRatio against(const ClothesModel& other) const;
  /// Mean log ratio of the moving pixels of a silhouette that are not covered; 0 without such
  /// pixels.
  static double meanRatio(const ClothesRatio& ratio, const cv::Mat& image, const cv::Mat& mask,
                          const BodySilhouette& silhouette, const cv::Mat& covered);

private:
  /// Updates until the clothes are known; origin not recorded.
  static constexpr int kEnoughUpdates = 3;
  using Histogram = std::array<float, kClothesBins>;
  std::array<Histogram, 2> shares_{}; ///< each sums to 1 once known
  std::array<Histogram, 2> counts_{}; ///< counts of the current frame
  int updateCount_ = 0;
};

} // namespace dewpoint::observation
