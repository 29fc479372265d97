// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/likelihood/target_color_model.h"

#include "core/color/color_classifier.h"
#include "core/color/color_evidence.h"
#include "core/color/hsi.h"
#include "core/color/likelihood/color_density.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace dewpoint::color {
namespace {

/// Shares of colors that are spread as in other light (ColorDensity). The target moves through the
/// light, and was clicked at few places in it. Of the rest nearly all colors were seen, where and
/// as they are; a little of it moves. Judgments.
constexpr double kTargetInOtherLight = 0.5;
constexpr double kRestInOtherLight = 0.05;

double factorOf(const ColorGain& gain, std::size_t channel) {
  return channel == 0 ? gain.blue : channel == 1 ? gain.green : gain.red;
}

double weightOf(const std::vector<WeightedBgrColor>& colors) {
  double sum = 0.0;
  for (const WeightedBgrColor& color : colors) {
    sum += color.weight;
  }
  return sum;
}

std::vector<WeightedBgrColor> bgrColors(const std::vector<WeightedHsiColor>& colors) {
  std::vector<WeightedBgrColor> result;
  result.reserve(colors.size());
  for (const WeightedHsiColor& color : colors) {
    result.push_back({bgrFromHsi(color.color), color.weight});
  }
  return result;
}

std::vector<WeightedBgrColor> withGain(std::vector<WeightedBgrColor> colors,
                                       const ColorGain& gain) {
  for (WeightedBgrColor& color : colors) {
    for (std::size_t i = 0; i < 3; ++i) {
      color.bgr[i] = std::min(255.0, color.bgr[i] * factorOf(gain, i));
    }
  }
  return colors;
}

/// What a range says about the cells of a camera with a gain.
class RangeOfCells {
public:
  RangeOfCells(const ColorRange& range, const ColorGain& gain) : classifier_(range) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      for (std::size_t cell = 0; cell < kColorCellsPerChannel; ++cell) {
        const double first = kColorCellLevels * static_cast<double>(cell);
        const auto reference = [&](double level) {
          const double levels = std::min(255.0, (first + level) / factorOf(gain, channel));
          return static_cast<std::uint8_t>(std::lround(levels));
        };
        lower_[channel][cell] = reference(2.0);
        middle_[channel][cell] = reference(3.5);
        upper_[channel][cell] = reference(5.0);
      }
    }
  }

  /// Of eight colors in the cell the share that lies in the range.
  double share(std::size_t blue, std::size_t green, std::size_t red) const {
    int matching = 0;
    for (const std::uint8_t b : {lower_[0][blue], upper_[0][blue]}) {
      for (const std::uint8_t g : {lower_[1][green], upper_[1][green]}) {
        for (const std::uint8_t r : {lower_[2][red], upper_[2][red]}) {
          matching += classifier_.matches(b, g, r) ? 1 : 0;
        }
      }
    }
    return matching / 8.0;
  }

  bool containsMiddle(std::size_t blue, std::size_t green, std::size_t red) const {
    return classifier_.matches(middle_[0][blue], middle_[1][green], middle_[2][red]);
  }

private:
  using Channels = std::array<std::array<std::uint8_t, kColorCellsPerChannel>, 3>;
  ColorClassifier classifier_;
  Channels lower_{}, middle_{}, upper_{}; ///< gray levels of the reference camera
};

/// How far the evidence is believed against the prior, 0 to 1.
double trustIn(double targetPixels, double restPixels) {
  const bool bothSeen = targetPixels > 0.0 && restPixels > 0.0;
  const double pixels =
      bothSeen ? std::min(targetPixels, restPixels) : std::max(targetPixels, restPixels);
  return pixels / (pixels + TargetColorModel::kPriorPixelCount);
}

} // namespace

ColorRange TargetColorModel::limitsOf(const ColorRange& range) {
  ColorRange limits = range;
  const double width = std::fmod(range.hueMax - range.hueMin + 720.0, 360.0);
  if (spansEveryHue(range) || width + 2.0 * kHueMarginDegrees >= 360.0) {
    limits.hueMin = 0.0;
    limits.hueMax = 360.0;
  } else {
    limits.hueMin = std::fmod(range.hueMin - kHueMarginDegrees + 360.0, 360.0);
    limits.hueMax = std::fmod(range.hueMax + kHueMarginDegrees, 360.0);
  }
  limits.saturationMin = std::max(0.0, range.saturationMin - kSaturationMargin);
  limits.saturationMax = std::min(1.0, range.saturationMax + kSaturationMargin);
  limits.intensityMin = std::max(0.0, range.intensityMin - kIntensityMargin);
  limits.intensityMax = std::min(1.0, range.intensityMax + kIntensityMargin);
  return limits;
}

TargetColorModel::TargetColorModel(const ColorRange& range)
    : TargetColorModel(range, limitsOf(range)) {}

TargetColorModel::TargetColorModel(const ColorRange& range, const ColorRange& limits)
    : range_(range), limits_(limits) {}

void TargetColorModel::add(const std::vector<WeightedHsiColor>& colors, const ColorGain& gain) {
  const ColorGain inverse{1.0 / gain.blue, 1.0 / gain.green, 1.0 / gain.red};
  for (const WeightedBgrColor& color : bgrColors(colors)) {
    WeightedBgrColor& added = target_.emplace_back(color);
    for (std::size_t i = 0; i < 3; ++i) {
      added.bgr[i] *= factorOf(inverse, i);
    }
  }
}

ColorLikelihood TargetColorModel::likelihoodForCamera(const ColorGain& gain,
                                                      const std::vector<WeightedHsiColor>& rest,
                                                      double restPerTarget) const {
  assert(gain.blue > 0.0 && gain.green > 0.0 && gain.red > 0.0 && restPerTarget > 0.0);
  const std::vector<WeightedBgrColor> target = withGain(target_, gain);
  const std::vector<WeightedBgrColor> others = bgrColors(rest);
  const ColorDensity targetDensity(target, kTargetInOtherLight);
  const ColorDensity restDensity(others, kRestInOtherLight);
  const double trust = trustIn(weightOf(target), weightOf(others));
  const RangeOfCells inside(range_, gain);
  const RangeOfCells allowed(limits_, gain);
  std::vector<double> logRatios(kColorCellCount, -ColorLikelihood::kMaxLogRatio);
  std::size_t cell = 0;
  for (std::size_t b = 0; b < kColorCellsPerChannel; ++b) {
    for (std::size_t g = 0; g < kColorCellsPerChannel; ++g) {
      for (std::size_t r = 0; r < kColorCellsPerChannel; ++r, ++cell) {
        if (!allowed.containsMiddle(b, g, r)) {
          continue;
        }
        const double prior = kPriorLogRatio * (2.0 * inside.share(b, g, r) - 1.0);
        const double unseen = kUnseenColorDensity * std::exp(0.5 * prior);
        const double unseenRest = kUnseenColorDensity * std::exp(-0.5 * prior);
        const double seen = std::log((targetDensity.at(cell) + unseen) /
                                     (restPerTarget * restDensity.at(cell) + unseenRest));
        logRatios[cell] =
            (1.0 - trust) * prior +
            trust * std::clamp(seen, -ColorLikelihood::kMaxLogRatio, ColorLikelihood::kMaxLogRatio);
      }
    }
  }
  return ColorLikelihood(logRatios);
}

double restPixelsPerTargetPixel(const ColorEvidence& evidence) {
  const bool both = evidence.targetWeight > 0.0 && evidence.restWeight > 0.0;
  return both ? evidence.restWeight / evidence.targetWeight : 1.0;
}

ColorLikelihood learnLikelihood(const ColorEvidence& evidence, const ColorRange& range,
                                double restPerTarget) {
  TargetColorModel model(range);
  model.add(evidence.targetColors);
  return model.likelihoodForCamera({}, evidence.restColors, restPerTarget);
}

} // namespace dewpoint::color
