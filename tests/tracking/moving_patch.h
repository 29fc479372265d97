// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/geometry/image_box.h"

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <cstdint>

namespace dewpoint::tests {

/// A two-colored patch that moves over a background of grays and browns with noise: pictures with
/// known boxes.
struct MovingPatch {
  cv::Size size{320, 240};
  double side = 30.0;
  double noise = 8.0;

  /// A slow Lissajous figure.
  ImageBox box(int frame) const {
    const double t = 0.06 * frame;
    return ImageBox::around({160.0 + 90.0 * std::sin(t), 120.0 + 60.0 * std::sin(1.7 * t)}, side,
                            side);
  }

  cv::Mat image(int frame, bool withPatch = true) const {
    cv::Mat picture(size, CV_8UC3);
    const RandomStream stream(7, 0, 0, RandomPurpose::Simulation);
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const auto word = stream.randomWords(std::uint32_t(500 * (y / 12) + x / 12));
        const int gray = 60 + int(word[0] % 120);
        picture.at<cv::Vec3b>(y, x) = cv::Vec3b(cv::saturate_cast<std::uint8_t>(gray - 25),
                                                std::uint8_t(gray), std::uint8_t(gray));
      }
    }
    if (withPatch) {
      const ImageBox where = box(frame);
      const cv::Rect patch(int(std::lround(where.x)), int(std::lround(where.y)), int(side),
                           int(side));
      cv::rectangle(picture, patch, cv::Scalar(40, 40, 210), cv::FILLED);
      cv::rectangle(picture, {patch.x + patch.width / 4, patch.y, patch.width / 2, patch.height},
                    cv::Scalar(200, 120, 40), cv::FILLED);
    }
    addNoise(picture, frame);
    return picture;
  }

private:
  void addNoise(cv::Mat& picture, int frame) const {
    const RandomStream stream(8, std::uint32_t(frame), 0, RandomPurpose::Noise);
    for (int i = 0; i < size.area(); ++i) {
      const auto normal = stream.normal3(std::uint32_t(i));
      auto& color = picture.at<cv::Vec3b>(i / size.width, i % size.width);
      for (int c = 0; c < 3; ++c) {
        color[c] =
            cv::saturate_cast<std::uint8_t>(color[c] + noise * double(normal[std::size_t(c)]));
      }
    }
  }
};

} // namespace dewpoint::tests
