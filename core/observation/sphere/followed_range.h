// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_range.h"
#include "core/color/hsi.h"

#include <array>
#include <cstddef>

namespace dewpoint::observation {

/// Color range of a target in one camera, for light that changes slowly (AdaptiveColor). The bounds
/// of the range follow the quantiles of the colors on the target.
class FollowedRange {
public:
  /// Number of bounds of a range. Each bound follows a quantile of the colors on the target. There
  /// is a low and a high quantile for each of three values: the hue (degrees from the center of the
  /// range), the saturation, and the logarithm of the intensity.
  static constexpr std::size_t kBoundCount = 6;
  using Quantiles = std::array<double, kBoundCount>;

  /// Starts with `base`, the range in the initial light.
  explicit FollowedRange(const ColorRange& base) : base_(base), inUse_(base) {}

  const ColorRange& initialRange() const { return base_; }
  const ColorRange& rangeInUse() const { return inUse_; }
  /// Returns the range in use with all bounds moved outward. Colors inside this wider range are
  /// considered approximately the target color.
  ColorRange widened() const;
  /// Returns the coordinates of a color: hue in degrees from the center of the base range (0 for
  /// gray), saturation, and the logarithm of the intensity, which must not be 0.
  std::array<double, 3> coordinatesOf(const Hsi& color) const;

  /// Includes measured quantiles in the mean quantiles of the initial light and returns true. Calls
  /// after the first `updates` calls change nothing and return false.
  bool addReference(const Quantiles& measured, int updates);
  /// Returns the quantiles at the fraction `share` (0 to 1) of the way from the current to the
  /// measured quantiles.
  Quantiles toward(const Quantiles& measured, double share) const;
  /// Returns the range that corresponds to the given quantiles.
  ColorRange at(const Quantiles& quantiles) const { return rangeOf(quantiles, slack_); }
  /// Sets the current quantiles and updates the range in use.
  void moveTo(const Quantiles& quantiles);

  /// Returns the slack of a bound: the distance between the bound and its quantile, as a fraction
  /// of the learned distance.
  double slack(std::size_t bound) const { return slack_[bound]; }
  /// Returns the range in use with a different slack for one bound, or the current range if the
  /// result is not usable.
  ColorRange withSlack(std::size_t bound, double slack) const;
  /// Sets the slack of one bound and updates the range in use.
  void setSlack(std::size_t bound, double slack);

  /// Returns whether a computed range can match any color.
  static bool isUsable(const ColorRange& range);

private:
  double center() const;
  Quantiles boundsOfBase() const;
  ColorRange rangeOf(const Quantiles& now, const Quantiles& slack) const;

  ColorRange base_;
  ColorRange inUse_;
  int updateCount_ = 0;
  Quantiles reference_{}; ///< quantiles in the initial light
  Quantiles now_{};
  Quantiles slack_{1, 1, 1, 1, 1, 1};
};

} // namespace dewpoint::observation
