// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cv {
class Mat;
}

namespace dewpoint::color {

/// Blue, green and red components of an 8-bit color.
using BgrColor = std::array<std::uint8_t, 3>;

/// Click (or dragged box) on a target, or on an object that is not the target, and the colors found
/// there. The colors are stored with the sample, so that a color can be learned again from samples
/// whose images no longer exist.
struct ColorSample {
  static constexpr std::size_t kMaxColors = 256;

  bool isExcluded = false; ///< true if the sample shows an object that is not the target
  /// True if the sample was not clicked, but found by the camera geometry from a click in the image
  /// of another camera.
  bool isFoundByGeometry = false;
  int camera = 0; ///< camera index in project order
  std::int64_t frame = 0;
  double x = 0.0; ///< position of the click, or of the box's upper left corner; pixels
  double y = 0.0;
  double width = 0.0; ///< width of a dragged box in pixels; 0 for a click
  double height = 0.0;
  int areaPx = 0;                 ///< area of the region grown from the click, in pixels
  std::vector<BgrColor> colors{}; ///< colors of the region, evenly selected, at most kMaxColors

  bool isBox() const { return width > 0.0 && height > 0.0; }
  bool operator==(const ColorSample&) const = default;
};

/// Returns `sample`, completed with the area and the colors of the region grown from the sample in
/// `bgr` (CV_8UC3). Error: BadValue with the field "pixel" or "box" if the sample is outside the
/// image, or "image" if the image is empty or has another type.
Result<ColorSample> takeSample(const cv::Mat& bgr, ColorSample sample);

} // namespace dewpoint::color
