// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/background/running_background.h"

#include "core/base/vector_kernel.h"

#include <opencv2/core.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace dewpoint::observation {
namespace {

// Origin of the values not recorded.

constexpr float kLeastDeviation = 3.0F; ///< gray levels, of the sum of three channels
constexpr float kFirstDeviation = 9.0F; ///< gray levels, before anything is learned
/// A pixel is new beyond this many deviations and these gray levels of the sum of three channels.
constexpr float kDeviations = 3.5F;
constexpr float kSlack = 14.0F;
constexpr float kShadowTint = 0.08F; ///< largest difference of ratio between a shadow's channels
constexpr float kBrightestShadow =
    1.06F; ///< largest brightness of a shadow, as a share of the mean

float distanceTo(float value, float mean) {
  return value > mean ? value - mean : mean - value;
}

/// Pixels and means in planes: so the loop becomes vector code.
struct Planes {
  const std::uint8_t* blue;
  const std::uint8_t* green;
  const std::uint8_t* red;
};

struct SubtractKernel {
  DEWPOINT_KERNEL void run(std::int64_t count, const Planes& pixels,
                           const std::uint8_t* __restrict keep, float* __restrict blueMean,
                           float* __restrict greenMean, float* __restrict redMean,
                           float* __restrict deviation, std::uint8_t* __restrict mask,
                           float darkest, float rate, float slowRate) {
    const std::uint8_t* __restrict blue = pixels.blue;
    const std::uint8_t* __restrict green = pixels.green;
    const std::uint8_t* __restrict red = pixels.red;
    for (std::int64_t i = 0; i < count; ++i) {
      const auto b = static_cast<float>(blue[i]);
      const auto g = static_cast<float>(green[i]);
      const auto r = static_cast<float>(red[i]);
      const float apart =
          distanceTo(b, blueMean[i]) + distanceTo(g, greenMean[i]) + distanceTo(r, redMean[i]);
      const bool moved = apart > kSlack + kDeviations * deviation[i];
      // The same ratio in all channels, without a division: r meanG = g meanR and so on.
      const float sum = b + g + r;
      const float usual = blueMean[i] + greenMean[i] + redMean[i];
      const float tint = distanceTo(b * usual, blueMean[i] * sum) +
                         distanceTo(g * usual, greenMean[i] * sum) +
                         distanceTo(r * usual, redMean[i] * sum);
      const bool shadow = (sum > darkest * usual) & (sum < kBrightestShadow * usual) &
                          (tint < kShadowTint * usual * sum);
      mask[i] = (moved & !shadow) ? 255 : 0;
      const float own = moved ? slowRate : rate;
      const float step = keep[i] != 0 ? 0.0F : own;
      blueMean[i] += step * (b - blueMean[i]);
      greenMean[i] += step * (g - greenMean[i]);
      redMean[i] += step * (r - redMean[i]);
      const float spread = deviation[i] + (moved ? 0.0F : step) * (apart - deviation[i]);
      deviation[i] = spread > kLeastDeviation ? spread : kLeastDeviation;
    }
  }
};

struct LearnKernel {
  DEWPOINT_KERNEL void run(std::int64_t count, const Planes& pixels, float* __restrict blueMean,
                           float* __restrict greenMean, float* __restrict redMean,
                           float* __restrict deviation, float rate, float deviationRate) {
    const std::uint8_t* __restrict blue = pixels.blue;
    const std::uint8_t* __restrict green = pixels.green;
    const std::uint8_t* __restrict red = pixels.red;
    for (std::int64_t i = 0; i < count; ++i) {
      const auto b = static_cast<float>(blue[i]);
      const auto g = static_cast<float>(green[i]);
      const auto r = static_cast<float>(red[i]);
      const float apart =
          distanceTo(b, blueMean[i]) + distanceTo(g, greenMean[i]) + distanceTo(r, redMean[i]);
      blueMean[i] += rate * (b - blueMean[i]);
      greenMean[i] += rate * (g - greenMean[i]);
      redMean[i] += rate * (r - redMean[i]);
      const float spread = deviation[i] + deviationRate * (apart - deviation[i]);
      deviation[i] = spread > kLeastDeviation ? spread : kLeastDeviation;
    }
  }
};

} // namespace

void RunningBackground::start(const cv::Mat& image) {
  size_ = image.size();
  learned_ = 0;
  for (auto& mean : means_) {
    mean.assign(image.total(), 0.0F);
  }
  deviation_.assign(image.total(), kFirstDeviation);
}

void RunningBackground::splitChannels(const cv::Mat& image) {
  if (image.size() != size_) {
    start(image);
  }
  cv::split(image, planes_);
}

void RunningBackground::learn(const cv::Mat& image) {
  splitChannels(image);
  // The mean of all so far; the deviation likewise from the third one on.
  const float rate = 1.0F / static_cast<float>(++learned_);
  runKernel<LearnKernel>(static_cast<std::int64_t>(image.total()),
                         Planes{planes_[0].data, planes_[1].data, planes_[2].data},
                         means_[0].data(), means_[1].data(), means_[2].data(), deviation_.data(),
                         rate, learned_ > 2 ? rate : 0.0F);
}

void RunningBackground::subtract(const cv::Mat& image, const cv::Mat& keep, cv::Mat& mask) {
  if (image.size() != size_) {
    learn(image);
  }
  splitChannels(image);
  mask.create(size_, CV_8UC1);
  constexpr float kRate = 0.02F; // per frame: the mean follows the light within some seconds
  const auto slow = static_cast<float>(0.7 / std::max(1.0, settings_.memoryFrameCount));
  if (keep.empty()) {
    nothing_.assign(image.total(), 0);
  }
  assert(keep.empty() || (keep.size() == size_ && keep.isContinuous()));
  runKernel<SubtractKernel>(static_cast<std::int64_t>(image.total()),
                            Planes{planes_[0].data, planes_[1].data, planes_[2].data},
                            keep.empty() ? nothing_.data() : keep.data, means_[0].data(),
                            means_[1].data(), means_[2].data(), deviation_.data(), mask.data,
                            static_cast<float>(settings_.darkestShadow), kRate, slow);
}

} // namespace dewpoint::observation
