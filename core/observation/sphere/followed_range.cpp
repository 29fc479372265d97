// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/sphere/followed_range.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::observation {
namespace {

// Reasons: docs/method-dewpoint.md, section 8; those without a derivation are judgments.

/// A color counts as the target's when it is in the range in use, widened by so much: what hides a
/// part of it is left out.
constexpr double kWiderHue = 12.0; // degrees
constexpr double kWiderSaturation = 0.12;
constexpr double kWiderIntensity = 1.35;  ///< factor
constexpr double kMostHue = 30.0;         ///< degrees from what was learned
constexpr double kMostSaturation = 0.35;  ///< from what was learned
constexpr double kMostIntensity = 2.0794; ///< ln 8
constexpr double kNarrowest = 1e-3;

/// `angle` within [-180, 180), degrees.
double aside(double angle) {
  return angle - 360.0 * std::floor((angle + 180.0) / 360.0);
}
double widthOf(const ColorRange& range) {
  return spansEveryHue(range) ? 360.0 : normalizedHue(range.hueMax - range.hueMin);
}

} // namespace

ColorRange FollowedRange::widened() const {
  ColorRange range = inUse_;
  if (widthOf(range) + 2.0 * kWiderHue >= 360.0) {
    range.hueMin = 0.0;
    range.hueMax = 360.0;
  } else {
    range.hueMin = normalizedHue(range.hueMin - kWiderHue);
    range.hueMax = normalizedHue(range.hueMax + kWiderHue);
  }
  range.saturationMin = std::max(0.0, range.saturationMin - kWiderSaturation);
  range.saturationMax = std::min(1.0, range.saturationMax + kWiderSaturation);
  range.intensityMin /= kWiderIntensity;
  range.intensityMax = std::min(1.0, range.intensityMax * kWiderIntensity);
  return range;
}

bool FollowedRange::isUsable(const ColorRange& range) {
  return range.saturationMin + kNarrowest <= range.saturationMax &&
         range.intensityMin + kNarrowest <= range.intensityMax &&
         checkColorRange(range).has_value();
}

double FollowedRange::center() const {
  return base_.hueMin + 0.5 * widthOf(base_);
}

std::array<double, 3> FollowedRange::coordinatesOf(const Hsi& color) const {
  return {std::isnan(color.hueDegrees) ? 0.0 : aside(color.hueDegrees - center()), color.saturation,
          std::log(color.intensity)};
}

FollowedRange::Quantiles FollowedRange::boundsOfBase() const {
  const double half = 0.5 * widthOf(base_);
  return {-half,
          half,
          base_.saturationMin,
          base_.saturationMax,
          std::log(base_.intensityMin),
          std::log(base_.intensityMax)}; // of 0: no bound, see rangeOf()
}

ColorRange FollowedRange::rangeOf(const Quantiles& now, const Quantiles& slack) const {
  static constexpr Quantiles kMost{kMostHue,        kMostHue,       kMostSaturation,
                                   kMostSaturation, kMostIntensity, kMostIntensity};
  Quantiles bounds = boundsOfBase();
  for (std::size_t k = 0; k < kBoundCount; ++k) {
    const double outward = k % 2 == 0 ? -1.0 : 1.0;
    const double way = bounds[k] - reference_[k];
    const double kept = outward * way > 0.0 ? slack[k] * way : way;
    const double moved = std::clamp(now[k] - reference_[k], -kMost[k], kMost[k]);
    bounds[k] = reference_[k] + moved + kept;
  }
  ColorRange range = base_; // a bound that is no bound stays none
  if (!spansEveryHue(base_)) {
    range.hueMin = normalizedHue(center() + bounds[0]);
    range.hueMax =
        normalizedHue(center() + std::max(bounds[0], std::min(bounds[1], bounds[0] + 350.0)));
  }
  if (base_.saturationMin > 0.0) {
    range.saturationMin = std::clamp(bounds[2], 0.0, 1.0);
  }
  if (base_.saturationMax < 1.0) {
    range.saturationMax = std::clamp(bounds[3], 0.0, 1.0);
  }
  if (base_.intensityMin > 0.0) {
    range.intensityMin = std::min(1.0, std::exp(bounds[4]));
  }
  if (base_.intensityMax < 1.0) {
    range.intensityMax = std::min(1.0, std::exp(bounds[5]));
  }
  return range;
}

bool FollowedRange::addReference(const Quantiles& measured, int updates) {
  if (updateCount_ >= updates) {
    return false;
  }
  const double share = 1.0 / ++updateCount_;
  for (std::size_t k = 0; k < kBoundCount; ++k) {
    reference_[k] += share * (measured[k] - reference_[k]);
  }
  now_ = reference_;
  return true;
}

FollowedRange::Quantiles FollowedRange::toward(const Quantiles& measured, double share) const {
  Quantiles next;
  for (std::size_t k = 0; k < kBoundCount; ++k) {
    next[k] = now_[k] + share * (measured[k] - now_[k]);
  }
  return next;
}

void FollowedRange::moveTo(const Quantiles& quantiles) {
  now_ = quantiles;
  inUse_ = rangeOf(now_, slack_);
}

ColorRange FollowedRange::withSlack(std::size_t bound, double slack) const {
  Quantiles tried = slack_;
  tried[bound] = slack;
  const ColorRange range = rangeOf(now_, tried);
  return isUsable(range) ? range : inUse_;
}

void FollowedRange::setSlack(std::size_t bound, double slack) {
  slack_[bound] = slack;
  inUse_ = rangeOf(now_, slack_);
}

} // namespace dewpoint::observation
