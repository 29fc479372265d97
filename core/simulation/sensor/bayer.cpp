// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/sensor/bayer.h"

#include "core/simulation/sensor/normal_table.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace dewpoint::simulation {
namespace {

/// Of blue, green and red pixels to daylight, relative to green: round numbers within what camera
/// makers publish for CMOS color sensors (0.5 to 0.8).
constexpr std::array<float, 3> kSensitivity{0.65F, 1.0F, 0.6F};
/// Full scale of a 12 bit converter; small sensors have 10 or 12 bits.
constexpr double kFullScale = 4095.0;

/// The channel (of BGR) that a pixel of the array measures.
int channelAt(int row, int column) {
  if (row % 2 == 0) {
    return column % 2 == 0 ? 2 : 1;
  }
  return column % 2 == 0 ? 1 : 0;
}

} // namespace

cv::Mat bayerMosaic(const cv::Mat& linear) {
  CV_Assert(linear.type() == CV_32FC3);
  cv::Mat raw(linear.size(), CV_32FC1);
  for (int row = 0; row < linear.rows; ++row) {
    const auto* in = linear.ptr<cv::Vec3f>(row);
    auto* out = raw.ptr<float>(row);
    for (int column = 0; column < linear.cols; ++column) {
      const int channel = channelAt(row, column);
      out[column] = in[column][channel] * kSensitivity.at(static_cast<std::size_t>(channel));
    }
  }
  return raw;
}

void addPixelNoise(cv::Mat& raw, const PixelNoise& noise, double gain, const RandomStream& stream) {
  CV_Assert(raw.type() == CV_32FC1 && raw.isContinuous());
  const std::vector<float>& normals = standardNormalNumbers();
  const auto perElectron = static_cast<float>(gain / noise.fullWellElectrons);
  const auto readVariance =
      static_cast<float>(noise.readNoiseElectrons * noise.readNoiseElectrons) * perElectron *
      perElectron;
  auto* values = raw.ptr<float>();
  const std::size_t count = raw.total();
  // Eight values from the four words of one draw.
  for (std::size_t i = 0; i < count; i += 8) {
    const auto words = stream.randomWords(static_cast<std::uint32_t>(i / 8));
    const std::size_t end = std::min<std::size_t>(8, count - i);
    for (std::size_t k = 0; k < end; ++k) {
      const std::uint32_t pick = (words[k / 2] >> (16U * (k % 2))) & 0xFFFFU;
      float& value = values[i + k];
      const float variance = std::max(0.0F, value) * perElectron + readVariance;
      value += std::sqrt(variance) * normals[pick];
    }
  }
}

cv::Mat demosaiced(const cv::Mat& raw) {
  CV_Assert(raw.type() == CV_32FC1);
  cv::Mat digits;
  // Rounds, and cuts at 0; what is above full scale is cut before.
  cv::Mat(cv::min(raw, 1.0)).convertTo(digits, CV_16U, kFullScale);
  cv::Mat colors;
  // OpenCV names an array by the second and third pixel of its second row: RGGB is "BG".
  cv::cvtColor(digits, colors, cv::COLOR_BayerBG2BGR);
  cv::Mat result;
  colors.convertTo(result, CV_32F, 1.0 / kFullScale);
  cv::multiply(result,
               cv::Scalar(1.0 / kSensitivity[0], 1.0 / kSensitivity[1], 1.0 / kSensitivity[2], 0.0),
               result);
  return result;
}

} // namespace dewpoint::simulation
