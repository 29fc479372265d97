// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_range.h"
#include "core/color/hsi.h"

#include <array>
#include <cstddef>

namespace dewpoint::observation {

/// One range of a target's color in one camera while the light changes slowly (AdaptiveColor): its
/// bounds follow the quantiles of the colors on the target.
class FollowedRange {
public:
  /// Low and high quantiles: of hue (degrees from the center of the range), saturation, and the
  /// logarithm of the intensity.
  static constexpr std::size_t kBounds = 6;
  using Quantiles = std::array<double, kBounds>;

  /// `base` is the range in the first light.
  explicit FollowedRange(const ColorRange& base) : base_(base), inUse_(base) {}

  const ColorRange& base() const { return base_; }
  const ColorRange& inUse() const { return inUse_; }
  /// The range in use with all bounds farther out: what lies within is about its color.
  ColorRange widened() const;
  /// Where a color lies: hue in degrees from the center of the base, 0 for gray; saturation; the
  /// logarithm of the intensity, which must not be 0.
  std::array<double, 3> placeOf(const Hsi& color) const;

  /// Takes quantiles of the first light into their mean. True as long as that is all that was done:
  /// for the first `updates` calls.
  bool takeReference(const Quantiles& measured, int updates);
  /// `share` (0 to 1) of the way from the quantiles now to those measured.
  Quantiles toward(const Quantiles& measured, double share) const;
  /// The range of these quantiles.
  ColorRange at(const Quantiles& quantiles) const { return rangeOf(quantiles, slack_); }
  void moveTo(const Quantiles& quantiles);

  /// How far a bound lies beyond its quantile, as a share of what was learned.
  double slack(std::size_t bound) const { return slack_[bound]; }
  /// The range with another one; that in use where there is none.
  ColorRange withSlack(std::size_t bound, double slack) const;
  void setSlack(std::size_t bound, double slack);

  /// Whether colors can lie in a range that was computed.
  static bool isUsable(const ColorRange& range);

private:
  double center() const;
  Quantiles boundsOfBase() const;
  ColorRange rangeOf(const Quantiles& now, const Quantiles& slack) const;

  ColorRange base_;
  ColorRange inUse_;
  int updateCount_ = 0;
  Quantiles reference_{}; ///< in the first light
  Quantiles now_{};
  Quantiles slack_{1, 1, 1, 1, 1, 1};
};

} // namespace dewpoint::observation
