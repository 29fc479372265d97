// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_range.h"
#include "core/color/hsi.h"

#include <array>
#include <cstddef>

namespace dewpoint::observation {

/// One range of a target's color in one camera while the light changes slowly (AdaptiveColor). Its
/// bounds follow the quantiles of the colors on the target.
class FollowedRange {
public:
  /// Number of bounds: low and high quantiles of hue (degrees from the center of the range),
  /// saturation, and the logarithm of the intensity.
  static constexpr std::size_t kBounds = 6;
  using Quantiles = std::array<double, kBounds>;

  /// Starts with `base`, the range in the first light.
  explicit FollowedRange(const ColorRange& base) : base_(base), inUse_(base) {}

  const ColorRange& base() const { return base_; }
  const ColorRange& inUse() const { return inUse_; }
  /// Range in use with all bounds moved outward. Colors inside are approximately the target's
  /// color.
  ColorRange widened() const;
  /// Coordinates of a color: hue in degrees from the center of the base, 0 for gray; saturation;
  /// logarithm of the intensity, which must not be 0.
  std::array<double, 3> placeOf(const Hsi& color) const;

  /// Adds quantiles of the first light to their mean. Returns true for the first `updates` calls,
  /// which do nothing else.
  bool takeReference(const Quantiles& measured, int updates);
  /// Quantiles `share` (0 to 1) of the way from the current ones to the measured ones.
  Quantiles toward(const Quantiles& measured, double share) const;
  /// Range that corresponds to these quantiles.
  ColorRange at(const Quantiles& quantiles) const { return rangeOf(quantiles, slack_); }
  /// Makes these the current quantiles and updates the range in use.
  void moveTo(const Quantiles& quantiles);

  /// Distance of a bound beyond its quantile, as a share of the learned distance.
  double slack(std::size_t bound) const { return slack_[bound]; }
  /// Range in use with another slack of one bound; the current range if that is not usable.
  ColorRange withSlack(std::size_t bound, double slack) const;
  /// Sets the slack of one bound and updates the range in use.
  void setSlack(std::size_t bound, double slack);

  /// Whether a computed range can contain colors.
  static bool isUsable(const ColorRange& range);

private:
  double center() const;
  Quantiles boundsOfBase() const;
  ColorRange rangeOf(const Quantiles& now, const Quantiles& slack) const;

  ColorRange base_;
  ColorRange inUse_;
  int updateCount_ = 0;
  Quantiles reference_{}; ///< quantiles in the first light
  Quantiles now_{};
  Quantiles slack_{1, 1, 1, 1, 1, 1};
};

} // namespace dewpoint::observation
