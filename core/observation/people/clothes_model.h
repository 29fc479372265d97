// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/people/body_silhouette.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace dewpoint::observation {

/// Colors of clothes are told apart in 8 x 8 cells of chromaticity (red and green as shares of the
/// whole), three of intensity, and one for all that is too dark to have a color.
inline constexpr std::size_t kClothesBins = 8 * 8 * 3 + 1;
std::size_t clothesBin(const std::uint8_t* bgr);

/// log p(color | one person) / p(color | others), within [-1, 1]; [0] from the waist down, [1]
/// above.
using ClothesRatio = std::array<std::array<float, kClothesBins>, 2>;

/// What a person wears, from the waist down and above: color histograms over all cameras, learned
/// while the person is seen alone.
class ClothesModel {
public:
  /// Learns the moving pixels of a silhouette that are not `covered` by others (CV_8UC1, or empty).
  void learn(const cv::Mat& image, const cv::Mat& mask, const BodySilhouette& silhouette,
             const cv::Mat& covered);
  /// Ends a frame: the images learned from since the last call count as one update.
  void finishFrame();
  bool known() const { return updateCount_ >= kEnoughUpdates; }
  /// This person against another.
  ClothesRatio against(const ClothesModel& other) const;
  /// Mean log ratio of the moving pixels of a silhouette that are not covered; 0 without any.
  static double meanRatio(const ClothesRatio& ratio, const cv::Mat& image, const cv::Mat& mask,
                          const BodySilhouette& silhouette, const cv::Mat& covered);

private:
  static constexpr int kEnoughUpdates = 3; ///< until the clothes are known; origin not recorded
  using Histogram = std::array<float, kClothesBins>;
  std::array<Histogram, 2> shares_{}; ///< sum 1 each, once known
  std::array<Histogram, 2> counts_{}; ///< of the frame under way
  int updateCount_ = 0;
};

} // namespace dewpoint::observation
