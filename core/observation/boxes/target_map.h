// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/boxes/target_colors.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace dewpoint::observation {

/// Map of the target's colors in a part of an image. Each part of the target has an integral image
/// (Crow 1984) of TargetColors::binShares(), so that evaluating a box of any size takes only a few
/// look-ups. Values are integers, so sums are exact up to 16 million pixels.
class TargetMap {
public:
  /// Computes the map for the rectangle `region` of an image (CV_8UC3). Pixels outside the
  /// rectangle have the value 0.
  void build(const cv::Mat& bgr, const cv::Rect& region, const TargetColors& colors);
  /// Returns the sum of TargetColors::binShares() over the pixels of a box, px². Each part of the
  /// box uses its own colors. A pixel that is only partly inside the box counts by the area inside
  /// (bilinear interpolation of the integral image).
  double sum(const ImageBox& box) const;
  const cv::Rect& region() const { return region_; }
  /// Returns the approximate size of a copy, bytes.
  std::size_t memoryBytes() const {
    return sizeof(std::uint32_t) * integrals_.front().capacity() * integrals_.size();
  }

private:
  using Integral = std::vector<std::uint32_t>;

  double corner(const Integral& integral, double x, double y) const;

  cv::Rect region_;
  std::array<Integral, TargetColors::kPartCount> integrals_; ///< (rows + 1) x (columns + 1)
};

} // namespace dewpoint::observation
