// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/people/body_silhouette.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace dewpoint::observation {

/// Number of color bins for clothes: 8 x 8 chromaticity cells (fractions of red and green) for each
/// of three intensity levels, and one bin for all colors that are too dark to have a hue.
inline constexpr std::size_t kClothesBins = 8 * 8 * 3 + 1;
/// Returns the number of the clothes color bin of a pixel (BGR).
std::size_t clothesBin(const std::uint8_t* bgr);

/// Log ratio log(p(color | one person) / p(color | other person)) for each color bin, limited to
/// [-1, 1]. Element 0 is for the body from the waist down, and element 1 for the body above the
/// waist.
using ClothesRatio = std::array<std::array<float, kClothesBins>, 2>;

/// Color histograms of a person's clothes below and above the waist, over all cameras. They are
/// learned while the person is seen separately from others.
class ClothesModel {
public:
  /// Learns the colors of those pixels of a silhouette in `image` (BGR) that move (nonzero in
  /// `mask`) and are not covered by other people (zero in `covered`). `covered` is CV_8UC1, or
  /// empty if no pixel is covered.
  void learn(const cv::Mat& image, const cv::Mat& mask, const BodySilhouette& silhouette,
             const cv::Mat& covered);
  /// Ends a frame. All images that were learned since the last call, usually one per camera, count
  /// as one update.
  void finishFrame();
  /// Returns whether enough frames have been learned to compare the colors with those of other
  /// people.
  bool isKnown() const { return updateCount_ >= kEnoughUpdates; }
  /// Returns the log ratio of this person's colors against the colors of another person.
  ClothesRatio logRatioAgainst(const ClothesModel& other) const;
  /// Returns the mean of `ratio` over those pixels of a silhouette that move (nonzero in `mask`)
  /// and are not covered by other people (zero in `covered`). Returns 0 if there are no such
  /// pixels.
  static double meanLogRatioInSilhouette(const ClothesRatio& ratio, const cv::Mat& image,
                                         const cv::Mat& mask, const BodySilhouette& silhouette,
                                         const cv::Mat& covered);

private:
  /// Number of updates until the clothes are known. The origin of this value is not recorded.
  static constexpr int kEnoughUpdates = 3;
  using Histogram = std::array<float, kClothesBins>;
  std::array<Histogram, 2> shares_{}; ///< each sums to 1 once known
  std::array<Histogram, 2> counts_{}; ///< counts of the current frame
  int updateCount_ = 0;
};

} // namespace dewpoint::observation
