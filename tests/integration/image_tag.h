// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <opencv2/core/mat.hpp>
#include <opencv2/imgproc.hpp>

#include <cstdint>
#include <optional>

namespace dewpoint::tests {

/// Data that a fake image contains about itself, as black and white squares in its upper left
/// corner.
struct ImageTag {
  int camera = 0;        ///< 0 to 7
  std::int64_t tick = 0; ///< of the common clock of the cameras
  bool isGood = true;    ///< the image shows the ball correctly
};

namespace image_tag {

inline constexpr int kSquare = 8; ///< side of a square in pixels, as that of JPEG's blocks
inline constexpr int kCameraBits = 3;
inline constexpr int kTickBits = 24;
inline constexpr std::uint64_t kFrame = 0b1011; ///< first four squares, which identify a tag
inline constexpr int kFrameBits = 4;
inline constexpr int kBits =
    kFrameBits + 1 + kCameraBits + kTickBits + 1; ///< the last bit is the parity

inline std::uint64_t withParity(std::uint64_t bits) {
  return bits << 1U | static_cast<std::uint64_t>(__builtin_parityll(bits));
}

} // namespace image_tag

/// Draws the tag into an image of at least 320 x 8 pixels, CV_8UC3.
inline void drawTag(cv::Mat& image, const ImageTag& tag) {
  using namespace image_tag;
  std::uint64_t bits = kFrame;
  bits = bits << 1U | (tag.isGood ? 1U : 0U);
  bits = bits << kCameraBits | static_cast<std::uint64_t>(tag.camera);
  bits = bits << kTickBits | (static_cast<std::uint64_t>(tag.tick) & ((1U << kTickBits) - 1U));
  bits = withParity(bits);
  for (int k = 0; k < kBits; ++k) {
    const bool isSet = (bits >> static_cast<unsigned>(kBits - 1 - k) & 1U) != 0;
    cv::rectangle(image, cv::Rect(k * kSquare, 0, kSquare, kSquare),
                  cv::Scalar::all(isSet ? 255 : 0), cv::FILLED);
  }
}

/// Reads the tag of an image, CV_8UC3; nothing if it has none.
inline std::optional<ImageTag> readTag(const cv::Mat& image) {
  using namespace image_tag;
  if (image.type() != CV_8UC3 || image.cols < kBits * kSquare || image.rows < kSquare) {
    return std::nullopt;
  }
  std::uint64_t bits = 0;
  for (int k = 0; k < kBits; ++k) {
    const auto pixel = image.at<cv::Vec3b>(kSquare / 2, k * kSquare + kSquare / 2);
    bits = bits << 1U | (pixel[1] > 127 ? 1U : 0U);
  }
  const bool isWhole = withParity(bits >> 1U) == bits;
  bits >>= 1U;
  ImageTag tag;
  tag.tick = static_cast<std::int64_t>(bits & ((1U << kTickBits) - 1U));
  bits >>= static_cast<unsigned>(kTickBits);
  tag.camera = static_cast<int>(bits & ((1U << kCameraBits) - 1U));
  bits >>= static_cast<unsigned>(kCameraBits);
  tag.isGood = (bits & 1U) != 0;
  bits >>= 1U;
  return isWhole && bits == kFrame ? std::optional(tag) : std::nullopt;
}

} // namespace dewpoint::tests
