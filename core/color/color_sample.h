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

/// Blue, green, red.
using BgrColor = std::array<std::uint8_t, 3>;

/// One click (or dragged box) on a target, or on something that is none, and the colors found
/// there. It is its own evidence: a color is learned again from samples whose images are gone.
struct ColorSample {
  static constexpr std::size_t kMostColors = 256;

  bool excluded = false; ///< shows what the target is not
  bool found = false;    ///< by the geometry of the cameras, from a click in another one
  int camera = 0;        ///< in the order of the project
  std::int64_t frame = 0;
  double x = 0.0; ///< pixels: of the click, or of the box's upper left corner
  double y = 0.0;
  double width = 0.0; ///< pixels, of a dragged box; 0: a click
  double height = 0.0;
  int area = 0;                   ///< pixels of the region grown from the click
  std::vector<BgrColor> colors{}; ///< of the region, evenly picked, at most kMostColors

  bool isBox() const { return width > 0.0 && height > 0.0; }
  bool operator==(const ColorSample&) const = default;
};

/// The same sample with the area and the colors of the region that grows from it in `bgr`
/// (CV_8UC3). BadValue naming "pixel" or "box" where it is not in the image, "image" for another
/// type.
Result<ColorSample> takeSample(const cv::Mat& bgr, ColorSample sample);

} // namespace dewpoint::color
