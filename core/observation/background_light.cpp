// SPDX-License-Identifier: GPL-3.0-or-later
// How a BackgroundModel follows light that changes.
#include "core/observation/background_model.h"

#include <opencv2/core.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace dewpoint {
namespace {

constexpr double kSamples = 400.0; ///< pixels looked at, on a grid: the median is good to 0.5 %
constexpr std::size_t kFewest = 50;
constexpr int kDarkest = 20;    ///< gray levels below which a ratio is mostly noise
constexpr int kBrightest = 245; ///< and above which the sensor may have been at its end
constexpr double kNoticeable = 1.0 / 40.0;
/// A greater change from one image to the next is no lamp, but a lens that is covered or blind.
constexpr double kGreatest = 4.0;
/// The same for all changes since the first image: what is darker says nothing any more.
constexpr double kGreatestInAll = 8.0;
constexpr double kMostAgree = 0.6; ///< share of the samples the change must explain

using Color = std::array<std::uint8_t, 3>; ///< blue, green, red

} // namespace

struct BackgroundModel::LightSample {
  Color now;
  Color usual;
};

namespace {

/// The median of the ratios of a channel; 1 where too few say something.
template <class Sample>
double medianRatio(const std::vector<Sample>& samples, std::size_t channel) {
  std::vector<double> ratios;
  ratios.reserve(samples.size());
  for (const auto& sample : samples) {
    if (sample.usual[channel] >= kDarkest && sample.usual[channel] <= kBrightest &&
        sample.now[channel] <= kBrightest) {
      ratios.push_back((sample.now[channel] + 0.5) / (sample.usual[channel] + 0.5));
    }
  }
  if (ratios.size() < kFewest) {
    return 1.0;
  }
  const auto middle = ratios.begin() + std::ssize(ratios) / 2;
  std::nth_element(ratios.begin(), middle, ratios.end());
  return *middle;
}

/// Share of the samples that are explained by this change of light.
template <class Sample>
double agreement(const std::vector<Sample>& samples, const Eigen::Array3d& gain) {
  const auto agrees = [&](const auto& sample) {
    for (Eigen::Index channel = 0; channel < 3; ++channel) {
      const double expected =
          std::min(255.0, gain[channel] * sample.usual[static_cast<std::size_t>(channel)]);
      const double allowed = BackgroundModel::kTolerance +
                             expected / (1 << BackgroundModel::kToleranceShift); // as for labels
      if (std::abs(sample.now[static_cast<std::size_t>(channel)] - expected) > allowed) {
        return false;
      }
    }
    return true;
  };
  return static_cast<double>(std::count_if(samples.begin(), samples.end(), agrees)) /
         static_cast<double>(samples.size());
}

} // namespace

std::vector<BackgroundModel::LightSample>
BackgroundModel::lightSamples(const cv::Mat& image) const {
  const int step =
      std::max(1, static_cast<int>(std::sqrt(static_cast<double>(image.total()) / kSamples)));
  std::vector<LightSample> samples;
  for (int row = step / 2; row < image.rows; row += step) {
    const std::uint8_t* confidence = confidence_.ptr<std::uint8_t>(row);
    const std::uint8_t* now = image.ptr<std::uint8_t>(row);
    const std::uint8_t* usual = mean_.ptr<std::uint8_t>(row);
    for (int column = step / 2; column < image.cols; column += step) {
      const std::ptrdiff_t at = std::ptrdiff_t{3} * column;
      if (confidence[column] >= kLearned) {
        samples.push_back(
            {{now[at], now[at + 1], now[at + 2]}, {usual[at], usual[at + 1], usual[at + 2]}});
      }
    }
  }
  return samples;
}

void BackgroundModel::followLight(const cv::Mat& image) {
  if (mean_.empty() || mean_.size() != image.size() || image.type() != CV_8UC3) {
    return;
  }
  const auto samples = lightSamples(image);
  if (samples.size() < kFewest) {
    return;
  }
  const Eigen::Array3d gain(medianRatio(samples, 0), medianRatio(samples, 1),
                            medianRatio(samples, 2));
  const Eigen::Array3d light = gain * light_;
  const auto within = [](const Eigen::Array3d& factors, double greatest) {
    return factors.maxCoeff() <= greatest && factors.minCoeff() >= 1.0 / greatest;
  };
  if ((gain - 1.0).abs().maxCoeff() < kNoticeable || !within(gain, kGreatest) ||
      !within(light, kGreatestInAll)) {
    return;
  }
  const double share = agreement(samples, gain);
  if (share < kMostAgree || share < agreement(samples, Eigen::Array3d::Ones())) {
    return;
  }
  cv::multiply(mean_, cv::Scalar(gain[0], gain[1], gain[2]), mean_);
  light_ = light;
}

} // namespace dewpoint
