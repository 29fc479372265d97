// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/color_sample.h"

#include "core/color/color_region.h"

#include <opencv2/core/mat.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace dewpoint::color {
namespace {

/// `count` of them, evenly picked by brightness, so that light and shade are all there.
std::vector<BgrColor> evenlyPicked(std::vector<BgrColor> colors, std::size_t count) {
  std::ranges::sort(colors, {}, [](const BgrColor& color) {
    return std::pair(int(color[0]) + color[1] + color[2], color);
  });
  if (colors.size() <= count) {
    return colors;
  }
  std::vector<BgrColor> picked;
  for (std::size_t i = 0; i < count; ++i) {
    picked.push_back(colors[(2 * i + 1) * colors.size() / (2 * count)]);
  }
  return picked;
}

} // namespace

Result<ColorSample> takeSample(const cv::Mat& bgr, ColorSample sample) {
  if (bgr.empty() || bgr.type() != CV_8UC3) {
    return failure(ErrorCode::BadValue, {}, "image", "a color image is expected");
  }
  const bool inside = sample.x >= 0.0 && sample.y >= 0.0 && sample.x + sample.width <= bgr.cols &&
                      sample.y + sample.height <= bgr.rows && sample.width >= 0.0 &&
                      sample.height >= 0.0 && std::lround(sample.x) < bgr.cols &&
                      std::lround(sample.y) < bgr.rows;
  if (!inside) { // NaN comes here too
    return failure(ErrorCode::BadValue, {}, sample.isBox() ? "box" : "pixel",
                   std::to_string(bgr.cols) + "x" + std::to_string(bgr.rows) +
                       " pixels are in the image");
  }
  auto colors = colorsIn(bgr, regionOfSample(bgr, sample));
  sample.areaPx = static_cast<int>(colors.size());
  sample.colors = evenlyPicked(std::move(colors), ColorSample::kMaxColors);
  return sample;
}

} // namespace dewpoint::color
