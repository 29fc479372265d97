// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/target_exposure.h"

#include <opencv2/core/mat.hpp>

#include <algorithm>
#include <cassert>

namespace dewpoint::color {
namespace {

constexpr int kClippedValue = 255;
constexpr std::size_t kValuesPerBin = (kClippedValue + 1) / TargetExposure::kBinCount;

double fractionOf(std::int64_t part, std::int64_t all) {
  return all > 0 ? static_cast<double>(part) / static_cast<double>(all) : 0.0;
}

} // namespace

void TargetExposure::add(const BgrColor& color) {
  const int brightness = std::max({color[0], color[1], color[2]});
  ++histogram[static_cast<std::size_t>(brightness) / kValuesPerBin];
  ++pixelCount;
  clippedCount += brightness == kClippedValue ? 1 : 0;
  darkCount += brightness < kMinUsefulBrightness ? 1 : 0;
}

double TargetExposure::clippedShare() const {
  return fractionOf(clippedCount, pixelCount);
}

double TargetExposure::darkShare() const {
  return fractionOf(darkCount, pixelCount);
}

ExposureFault TargetExposure::fault() const {
  if (clippedShare() >= kMaxClippedShare) {
    return ExposureFault::Overexposed;
  }
  return darkShare() >= kMaxDarkShare ? ExposureFault::TooDark : ExposureFault::None;
}

TargetExposure exposureOf(const cv::Mat& bgr, const cv::Mat& mask) {
  assert(bgr.type() == CV_8UC3 && mask.type() == CV_8UC1 && bgr.size() == mask.size());
  TargetExposure exposure;
  for (int row = 0; row < bgr.rows; ++row) {
    const auto* pixel = bgr.ptr<std::uint8_t>(row);
    const auto* inside = mask.ptr<std::uint8_t>(row);
    for (int column = 0; column < bgr.cols; ++column, pixel += 3) {
      if (inside[column] != 0) {
        exposure.add({pixel[0], pixel[1], pixel[2]});
      }
    }
  }
  return exposure;
}

TargetExposure exposureOf(const std::vector<BgrColor>& colors) {
  TargetExposure exposure;
  for (const BgrColor& color : colors) {
    exposure.add(color);
  }
  return exposure;
}

} // namespace dewpoint::color
