// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/color_palette.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace dewpoint::color {
namespace {

constexpr float kLightness = 0.5F; ///< weight: light and shade are on one object
constexpr double kAlike = 10.0;    ///< distance in L*a*b* at which colors are still alike
constexpr int kStep = 2;           ///< pixels, of those that the palette is made of
constexpr int kClusterRounds = 4;  ///< of k-means

float squaredDistance(const cv::Vec3f& one, const cv::Vec3f& other) {
  const cv::Vec3f difference = one - other;
  return difference.dot(difference);
}

cv::Mat labOf(const cv::Mat& bgr) {
  cv::Mat lab;
  bgr.convertTo(lab, CV_32FC3, 1.0 / 255.0);
  cv::cvtColor(lab, lab, cv::COLOR_BGR2Lab);
  for (int y = 0; y < lab.rows; ++y) {
    for (int x = 0; x < lab.cols; ++x) {
      lab.at<cv::Vec3f>(y, x)[0] *= kLightness;
    }
  }
  return lab;
}

} // namespace

std::uint8_t ColorPalette::nearest(const Colors& colors, const cv::Vec3f& color) {
  std::size_t best = 0;
  float least = std::numeric_limits<float>::max();
  for (std::size_t k = 0; k < kColorCount; ++k) {
    const float distance = squaredDistance(colors[k], color);
    best = distance < least ? k : best;
    least = std::min(least, distance);
  }
  return static_cast<std::uint8_t>(best);
}

ColorPalette::Colors ColorPalette::farthestFirst(const cv::Mat& lab, cv::Point first) {
  cv::Mat distances(lab.size(), CV_32FC1, cv::Scalar(std::numeric_limits<float>::max()));
  Colors colors;
  cv::Point next(std::clamp(first.x, 0, lab.cols - 1), std::clamp(first.y, 0, lab.rows - 1));
  for (cv::Vec3f& color : colors) {
    color = lab.at<cv::Vec3f>(next);
    float farthest = -1.0F;
    for (int y = 0; y < lab.rows; y += kStep) {
      for (int x = 0; x < lab.cols; x += kStep) {
        float& distance = distances.at<float>(y, x);
        distance = std::min(distance, squaredDistance(lab.at<cv::Vec3f>(y, x), color));
        if (distance > farthest) {
          farthest = distance;
          next = {x, y};
        }
      }
    }
  }
  return colors;
}

void ColorPalette::refineClusters(Colors& colors, const cv::Mat& lab) {
  for (int round = 0; round < kClusterRounds; ++round) {
    Colors sums{};
    std::array<int, kColorCount> counts{};
    for (int y = 0; y < lab.rows; y += kStep) {
      for (int x = 0; x < lab.cols; x += kStep) {
        const auto& color = lab.at<cv::Vec3f>(y, x);
        const std::size_t k = nearest(colors, color);
        sums[k] += color;
        ++counts[k];
      }
    }
    for (std::size_t k = 0; k < kColorCount; ++k) {
      colors[k] = counts[k] > 0 ? sums[k] * (1.0F / static_cast<float>(counts[k])) : colors[k];
    }
  }
}

ColorPalette::ColorPalette(const cv::Mat& bgr, cv::Point first) : labels_(bgr.size(), CV_8UC1) {
  const cv::Mat lab = labOf(bgr);
  Colors colors = farthestFirst(lab, first);
  refineClusters(colors, lab);
  for (int y = 0; y < lab.rows; ++y) {
    for (int x = 0; x < lab.cols; ++x) {
      labels_.at<std::uint8_t>(y, x) = nearest(colors, lab.at<cv::Vec3f>(y, x));
    }
  }
  for (std::size_t i = 0; i < kColorCount; ++i) {
    for (std::size_t j = 0; j < kColorCount; ++j) {
      alike_[i][j] =
          std::exp(-0.5 * double(squaredDistance(colors[i], colors[j])) / (kAlike * kAlike));
    }
  }
}

ColorPalette::Shares ColorPalette::spreadOverSimilarColors(const Shares& counts) const {
  Shares soft{};
  for (std::size_t i = 0; i < kColorCount; ++i) {
    for (std::size_t j = 0; j < kColorCount; ++j) {
      soft[i] += alike_[i][j] * counts[j];
    }
  }
  return soft;
}

} // namespace dewpoint::color
