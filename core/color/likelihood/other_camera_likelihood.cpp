// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/likelihood/other_camera_likelihood.h"

#include "core/color/hsi.h"
#include "core/color/hsi_counts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace dewpoint::color {
namespace {

/// Factors between two cameras' gray levels: of blue and red against green (white balance), and of
/// all three (exposure). Chosen: automatic white balance in rooms comes to about a sixth, exposure
/// to about a third.
constexpr std::array<double, 3> kWhiteBalance{0.86, 1.0, 1.16};
constexpr std::array<double, 3> kExposure{0.74, 1.0, 1.35};

/// The density below which a color counts as never seen, relative to colors spread evenly. Chosen:
/// a tenth of a percent of an image in one cell of color has 33.
constexpr double kUnseen = 0.3;

std::vector<WeightedBgrColor> asOtherCamerasShow(const std::vector<BgrColor>& target) {
  HsiCounts counts;
  for (const BgrColor& color : target) {
    counts.add(color, 1.0);
  }
  std::vector<WeightedBgrColor> result;
  for (const WeightedHsiColor& cell : counts.colors()) {
    const auto bgr = bgrFromHsi(cell.color);
    for (const double exposure : kExposure) {
      for (const double blue : kWhiteBalance) {
        for (const double red : kWhiteBalance) {
          const std::array<double, 3> factors{exposure * blue, exposure, exposure * red};
          WeightedBgrColor& shown = result.emplace_back(WeightedBgrColor{{}, cell.weight});
          for (std::size_t i = 0; i < 3; ++i) {
            shown.bgr[i] = std::min(255.0, bgr[i] * factors[i]);
          }
        }
      }
    }
  }
  return result;
}

/// How much a pixel counts where the target cannot be: it still shows what colors the room has. A
/// judgment.
constexpr double kFarWeight = 0.2;

std::vector<WeightedBgrColor> colorsBeside(const cv::Mat& bgr, const cv::Mat& near,
                                           const cv::Mat& region) {
  HsiCounts counts;
  counts.add(bgr, region, kFarWeight);
  counts.add(bgr, ~near | region, 1.0 - kFarWeight);
  std::vector<WeightedBgrColor> result;
  for (const WeightedHsiColor& cell : counts.colors()) {
    result.push_back({bgrFromHsi(cell.color), cell.weight});
  }
  return result;
}

} // namespace

OtherCameraLikelihood::OtherCameraLikelihood(const std::vector<BgrColor>& target)
    : target_(asOtherCamerasShow(target), 1.0) {}

std::vector<double> OtherCameraLikelihood::logRatios(const cv::Mat& bgr, const cv::Mat& near,
                                                     const cv::Mat& region) const {
  const ColorDensity rest(colorsBeside(bgr, near, region), 0.0); // its colors count where they are
  std::vector<double> result(kColorCellCount);
  for (std::size_t cell = 0; cell < kColorCellCount; ++cell) {
    result[cell] = std::log((target_.at(cell) + kUnseen) / (rest.at(cell) + kUnseen));
  }
  return result;
}

ColorLikelihood OtherCameraLikelihood::likelihoodForImage(const cv::Mat& bgr,
                                                          const cv::Mat& near) const {
  return ColorLikelihood(logRatios(bgr, near, cv::Mat::zeros(bgr.size(), CV_8UC1)));
}

double OtherCameraLikelihood::meanLogLikelihoodRatio(const cv::Mat& bgr, const cv::Mat& near,
                                                     const cv::Mat& region) const {
  const std::vector<double> table = logRatios(bgr, near, region);
  double sum = 0.0;
  int count = 0;
  for (int y = 0; y < bgr.rows; ++y) {
    const std::uint8_t* pixel = bgr.ptr<std::uint8_t>(y);
    const std::uint8_t* inside = region.ptr<std::uint8_t>(y);
    for (int x = 0; x < bgr.cols; ++x, pixel += 3) {
      if (inside[x] != 0) {
        sum += table[colorCell(pixel[0], pixel[1], pixel[2])];
        ++count;
      }
    }
  }
  return count > 0 ? sum / count : 0.0;
}

} // namespace dewpoint::color
