// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/sensor/sensor.h"

#include "core/simulation/sensor/normal_table.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace dewpoint::simulation {
cv::Mat digitize(const cv::Mat& image, double noiseSigma, const RandomStream& stream) {
  cv::Mat result(image.size(), CV_8UC3);
  const std::vector<float>& normals = standardNormalNumbers();
  const auto sigma = static_cast<float>(noiseSigma);
  const auto values = static_cast<std::size_t>(image.total()) * 3;
  const auto* in = image.ptr<float>();
  auto* out = result.ptr<std::uint8_t>();
  // Eight values from the four words of one draw.
  for (std::size_t i = 0; i < values; i += 8) {
    std::array<std::uint32_t, 4> words{};
    if (sigma > 0.0F) {
      words = stream.randomWords(static_cast<std::uint32_t>(i / 8));
    }
    const std::size_t end = std::min<std::size_t>(8, values - i);
    for (std::size_t k = 0; k < end; ++k) {
      const std::uint32_t pick = (words[k / 2] >> (16U * (k % 2))) & 0xFFFFU;
      const float value = in[i + k] + sigma * normals[pick];
      const float rounded = std::clamp(value, 0.0F, 255.0F) + 0.5F; // truncated next
      out[i + k] = static_cast<std::uint8_t>(rounded);
    }
  }
  return result;
}

cv::Mat jpegCompressed(const cv::Mat& image, int quality) {
  std::vector<std::uint8_t> bytes;
  cv::imencode(".jpg", image, bytes, {cv::IMWRITE_JPEG_QUALITY, quality});
  return cv::imdecode(bytes, cv::IMREAD_COLOR);
}

cv::Mat sharpened(const cv::Mat& image, const Sharpening& sharpening) {
  if (sharpening.amount <= 0.0) {
    return image;
  }
  cv::Mat soft;
  cv::GaussianBlur(image, soft, {}, sharpening.sigmaPx, sharpening.sigmaPx, cv::BORDER_REPLICATE);
  cv::Mat result;
  cv::addWeighted(image, 1.0 + sharpening.amount, soft, -sharpening.amount, 0.0, result);
  return result;
}

cv::Mat unevenLightGains(cv::Size size, double vignette, double right, double down) {
  cv::Mat gains(size, CV_32FC3);
  for (int row = 0; row < size.height; ++row) {
    for (int column = 0; column < size.width; ++column) {
      const double x = 2.0 * column / (size.width - 1) - 1.0;
      const double y = 2.0 * row / (size.height - 1) - 1.0;
      const double gain = 1.0 + right * x + down * y - vignette * 0.5 * (x * x + y * y);
      gains.at<cv::Vec3f>(row, column) = cv::Vec3f::all(static_cast<float>(gain));
    }
  }
  return gains;
}

} // namespace dewpoint::simulation
