// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_sample.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cv {
class Mat;
}

namespace dewpoint::color {

/// Fault of the exposure of a target's pixels.
enum class ExposureFault : std::uint8_t { None, Overexposed, TooDark };

/// How bright the pixels of a target are. The brightness of a pixel is its largest channel, because
/// a color is lost as soon as one of its channels is clipped.
struct TargetExposure {
  static constexpr std::size_t kBinCount = 32; ///< number of bins, of 8 brightness values each
  static constexpr int kMinUsefulBrightness =
      20; ///< brightness below which a pixel has no useful color
  /// If at least this fraction of the pixels is clipped, fault() returns Overexposed. Chosen by
  /// judgment: the highlights of a well exposed ball are smaller.
  static constexpr double kMaxClippedShare = 0.2;
  /// If at least this fraction of the pixels is dark, fault() returns TooDark. Chosen by judgment:
  /// the shaded side of a well exposed ball is smaller.
  static constexpr double kMaxDarkShare = 0.5;

  std::array<std::int64_t, kBinCount> histogram{}; ///< number of pixels by brightness
  std::int64_t pixelCount = 0;                     ///< number of all pixels
  std::int64_t clippedCount = 0;                   ///< number of pixels with a channel of 255
  std::int64_t darkCount =
      0; ///< number of pixels whose channels are all below kMinUsefulBrightness

  /// Adds one pixel.
  void add(const BgrColor& color);
  /// Returns the fraction of all pixels that is clipped (a channel is 255), 0 to 1; 0 without
  /// pixels.
  double clippedShare() const;
  /// Returns the fraction of all pixels that is dark (all channels below kMinUsefulBrightness), 0
  /// to 1; 0 without pixels.
  double darkShare() const;
  /// Returns the fault of the exposure, or None. Returns Overexposed if both faults apply.
  ExposureFault fault() const;

  bool operator==(const TargetExposure&) const = default;
};

/// Returns the exposure of the pixels of `bgr` (CV_8UC3) at which `mask` (CV_8UC1, of the same
/// size) is not 0.
TargetExposure exposureOf(const cv::Mat& bgr, const cv::Mat& mask);
/// Returns the exposure of colors, for example of the colors of a sample.
TargetExposure exposureOf(const std::vector<BgrColor>& colors);

} // namespace dewpoint::color
