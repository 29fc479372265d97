// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/background/light_change.h"

#include "core/base/statistics.h"
#include "core/observation/background/background_model.h"

#include <opencv2/core.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace dewpoint::observation {
namespace {

// Reasons: docs/method-dewpoint.md, section 2; those without a derivation are judgments.

/// Pixels of the grid. Noise of 4 % each leaves the median good to 0.5 %.
constexpr double kSamples = 400.0;
constexpr std::size_t kFewest = 50; ///< known pixels; fewer say nothing
constexpr int kDarkest = 20;        ///< gray levels below which a ratio is mostly noise
constexpr int kBrightest = 245;     ///< gray levels above which the sensor may be saturated
/// Least relative change that is followed: a fifth of the tolerance for light.
constexpr double kNoticeable = 1.0 / 40.0;
/// Largest factor from one image to the next; more is no lamp but a lens that is covered or blind.
constexpr double kGreatest = 4.0;
/// Largest factor since the reference; what is darker says nothing any more.
constexpr double kGreatestInAll = 8.0;
/// Least share of the samples that the change must explain, 0 to 1.
constexpr double kMostAgree = 0.6;

using Color = std::array<std::uint8_t, 3>; ///< blue, green, red

/// A pixel in this image and in the learned background.
struct LightSample {
  Color now;
  Color usual;
};

/// The ratios of a channel, of the samples where they mean anything.
std::vector<double> ratiosOf(const std::vector<LightSample>& samples, std::size_t channel) {
  std::vector<double> ratios(samples.size());
  std::size_t count = 0;
  for (const auto& sample : samples) {
    const int usual = sample.usual[channel];
    ratios[count] = (sample.now[channel] + 0.5) / (usual + 0.5);
    const bool speaks =
        (usual >= kDarkest) & (usual <= kBrightest) & (sample.now[channel] <= kBrightest);
    count += speaks ? 1 : 0;
  }
  ratios.resize(count);
  return ratios;
}

/// The change of light that the ratios of one channel show: their median; 1 of too few.
double gainFrom(std::vector<double> ratios) {
  return ratios.size() < kFewest ? 1.0 : upperMedian(std::move(ratios));
}

/// Whether gainFrom() differs noticeably from 1, without sorting: it does not while the ratios
/// below and those above leave the median to the others.
bool isNoticeable(const std::vector<double>& ratios) {
  if (ratios.size() < kFewest) {
    return false;
  }
  std::ptrdiff_t below = 0;
  std::ptrdiff_t above = 0;
  for (const double ratio : ratios) {
    below += 1.0 - ratio >= kNoticeable ? 1 : 0;
    above += ratio - 1.0 >= kNoticeable ? 1 : 0;
  }
  const std::ptrdiff_t half = std::ssize(ratios) / 2;
  return below > half || above >= std::ssize(ratios) - half;
}

/// Share of the samples that are explained by this change of light.
double agreement(const std::vector<LightSample>& samples, const Eigen::Array3d& gain) {
  const auto agrees = [&](const auto& sample) {
    for (Eigen::Index channel = 0; channel < 3; ++channel) {
      const double expected =
          std::min(255.0, gain[channel] * sample.usual[static_cast<std::size_t>(channel)]);
      const double allowed =
          BackgroundModel::kBaseTolerance +
          expected / (1 << BackgroundModel::kToleranceShiftBits); // as for labels
      if (std::abs(sample.now[static_cast<std::size_t>(channel)] - expected) > allowed) {
        return false;
      }
    }
    return true;
  };
  return static_cast<double>(std::count_if(samples.begin(), samples.end(), agrees)) /
         static_cast<double>(samples.size());
}

std::vector<LightSample> lightSamples(const cv::Mat& image, const cv::Mat& mean,
                                      const cv::Mat& confidence) {
  const int step =
      std::max(1, static_cast<int>(std::sqrt(static_cast<double>(image.total()) / kSamples)));
  std::vector<LightSample> samples;
  samples.reserve(static_cast<std::size_t>(image.rows / step + 1) *
                  static_cast<std::size_t>(image.cols / step + 1));
  for (int row = step / 2; row < image.rows; row += step) {
    const std::uint8_t* known = confidence.ptr<std::uint8_t>(row);
    const std::uint8_t* now = image.ptr<std::uint8_t>(row);
    const std::uint8_t* usual = mean.ptr<std::uint8_t>(row);
    for (int column = step / 2; column < image.cols; column += step) {
      const std::ptrdiff_t at = std::ptrdiff_t{3} * column;
      if (known[column] >= BackgroundModel::kObservationsUntilKnown) {
        samples.push_back(
            {{now[at], now[at + 1], now[at + 2]}, {usual[at], usual[at + 1], usual[at + 2]}});
      }
    }
  }
  return samples;
}

} // namespace

std::optional<Eigen::Array3d> estimateLightChange(const cv::Mat& image, const cv::Mat& mean,
                                                  const cv::Mat& confidence,
                                                  const Eigen::Array3d& light) {
  const auto samples = lightSamples(image, mean, confidence);
  if (samples.size() < kFewest) {
    return std::nullopt;
  }
  std::array<std::vector<double>, 3> ratios{ratiosOf(samples, 0), ratiosOf(samples, 1),
                                            ratiosOf(samples, 2)};
  if (std::none_of(ratios.begin(), ratios.end(), isNoticeable)) {
    return std::nullopt;
  }
  const Eigen::Array3d gain(gainFrom(std::move(ratios[0])), gainFrom(std::move(ratios[1])),
                            gainFrom(std::move(ratios[2])));
  const auto within = [](const Eigen::Array3d& factors, double greatest) {
    return factors.maxCoeff() <= greatest && factors.minCoeff() >= 1.0 / greatest;
  };
  if (!within(gain, kGreatest) || !within(gain * light, kGreatestInAll)) {
    return std::nullopt;
  }
  const double share = agreement(samples, gain);
  if (share < kMostAgree || share < agreement(samples, Eigen::Array3d::Ones())) {
    return std::nullopt;
  }
  return gain;
}

} // namespace dewpoint::observation
