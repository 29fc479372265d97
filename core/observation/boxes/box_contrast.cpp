// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/boxes/box_contrast.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::observation {
namespace {

// docs/method-sugandi.md has the steps; the origin of the values is not recorded.

constexpr double kFigureRing = 1.6; ///< size of the ring's outline, in boxes
constexpr double kFewestPixels = 4; ///< in an oval
constexpr double kLeastRing = 0.5;  ///< of the oval's pixels, in the ring: else it is cut off
constexpr double kKnownReach = 1.5; ///< pixels around the known one that count as known
/// An oval in three bands: heights and half widths, in halves of the box.
constexpr double kMiddleBand = 0.6;
constexpr double kMiddleWidth = 0.95;
constexpr double kOuterWidth = 0.6;

} // namespace

BoxContrast::BoxContrast(const cv::Mat& bgr, const Eigen::Vector2d& pixel)
    : size_(bgr.size()), palette_(bgr, {static_cast<int>(pixel.x()), static_cast<int>(pixel.y())}) {
  constexpr std::size_t kColors = ColorPalette::kColorCount;
  const std::size_t stride = static_cast<std::size_t>(size_.width + 1) * kColors;
  sums_.assign(stride * static_cast<std::size_t>(size_.height + 1), 0);
  for (int y = 0; y < size_.height; ++y) {
    std::array<int, kColors> row{};
    int* sums = &sums_[stride * static_cast<std::size_t>(y + 1)];
    for (int x = 0; x < size_.width; ++x) {
      ++row[palette_.colorIndices().at<std::uint8_t>(y, x)];
      sums += kColors;
      std::transform(row.begin(), row.end(), integralAt(x + 1, y), sums, std::plus<>());
    }
  }
  add(pixel.x() - kKnownReach, pixel.y() - kKnownReach, pixel.x() + kKnownReach,
      pixel.y() + kKnownReach, known_);
}

void BoxContrast::add(double left, double top, double right, double bottom, Colors& colors) const {
  const auto whole = [](double edge, int end) {
    return std::clamp(static_cast<int>(std::lround(edge)), 0, end);
  };
  const int from = whole(left, size_.width);
  const int to = whole(right, size_.width);
  const int above = whole(top, size_.height);
  const int below = whole(bottom, size_.height);
  if (to <= from || below <= above) {
    return;
  }
  const int* corners[] = {integralAt(from, above), integralAt(to, above), integralAt(from, below),
                          integralAt(to, below)};
  for (std::size_t k = 0; k < ColorPalette::kColorCount; ++k) {
    colors.counts[k] += corners[3][k] - corners[2][k] - corners[1][k] + corners[0][k];
  }
  colors.pixelCount += double(to - from) * (below - above);
}

BoxContrast::Colors BoxContrast::colorsInOval(const ImageBox& box) const {
  const Eigen::Vector2d center = box.center();
  const double right = 0.5 * box.width;
  const double down = 0.5 * box.height;
  Colors colors;
  const auto band = [&](double top, double bottom, double half) {
    add(center.x() - half * right, center.y() + top * down, center.x() + half * right,
        center.y() + bottom * down, colors);
  };
  band(-1.0, -kMiddleBand, kOuterWidth);
  band(-kMiddleBand, kMiddleBand, kMiddleWidth);
  band(kMiddleBand, 1.0, kOuterWidth);
  return colors;
}

double BoxContrast::contrastOf(const ImageBox& box) const {
  const Colors figure = colorsInOval(box);
  Colors ring = colorsInOval(
      ImageBox::around(box.center(), kFigureRing * box.width, kFigureRing * box.height));
  ring.pixelCount -= figure.pixelCount;
  if (figure.pixelCount < kFewestPixels || ring.pixelCount < kLeastRing * figure.pixelCount ||
      known_.pixelCount <= 0.0) {
    return 0.0;
  }
  for (std::size_t k = 0; k < ColorPalette::kColorCount; ++k) {
    ring.counts[k] -= figure.counts[k];
  }
  const Shares inside = palette_.spreadOverSimilarColors(figure.counts);
  const Shares around = palette_.spreadOverSimilarColors(ring.counts);
  double difference = 0.0;
  double differenceAtKnown = 0.0;
  for (std::size_t k = 0; k < ColorPalette::kColorCount; ++k) {
    const double f = inside[k] / figure.pixelCount;
    const double b = around[k] / ring.pixelCount;
    const double evidence = f + b > 0.0 ? (f - b) / (f + b) : 0.0;
    difference += evidence * figure.counts[k] / figure.pixelCount;
    differenceAtKnown += evidence * known_.counts[k] / known_.pixelCount;
  }
  return std::max(0.0, difference) * std::max(0.0, differenceAtKnown);
}

} // namespace dewpoint::observation
