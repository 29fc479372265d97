// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::tracking {

/// Prior knowledge about a target's radius. A radius given by the user is usually more accurate
/// than a radius measured in images, so it is used unchanged until an outline contradicts it. The
/// given radius may be wrong, for example by a quarter. After a contradiction, or if no radius is
/// given, the radius is measured and stored.
class RadiusPrior {
public:
  /// Creates the prior for a radius `given` by the user, in meters; 0 if unknown.
  explicit RadiusPrior(double given = 0.0) : given_(given) {}

  /// Discards the measured radius.
  void restart() { measured_ = 0.0; }
  /// Stores the radius (m) of a target that is certainly visible, if the radius was measured
  /// accurately enough. `logVariance` is the variance of the radius' logarithm, or 0 if the radius
  /// was not measured.
  void learn(double radius, double logVariance);

  bool isGiven() const { return given_ > 0.0; }
  /// Returns whether the given radius has not been contradicted.
  bool isTrusted() const { return isGiven() && measured_ <= 0.0; }
  /// Returns whether an outline of this radius (m) contradicts the given radius.
  bool contradicts(double radius) const;
  /// Returns the expected radius in meters: the measured radius if there is one, otherwise the
  /// given radius, otherwise a typical radius.
  double expectedRadius() const;
  /// Returns the variance of the radius' logarithm at the start of a fit; 0 for a trusted radius.
  double logVariance() const { return isTrusted() ? 0.0 : unknownRadiusLogVariance(); }
  /// Returns the variance of the logarithm of an unknown radius.
  static double unknownRadiusLogVariance();
  /// Returns the cost in nats (units of the natural logarithm) of a radius that differs from the
  /// expected radius: half the squared distance of the logarithms in standard deviations. The cost
  /// has an upper limit, because the given radius may have been measured wrongly. Returns 0 if the
  /// radius is unknown.
  double penaltyFor(double radius) const;
  /// Returns whether an object of this radius (m) may be the target.
  bool allowsRadius(double radius) const;

private:
  double given_;
  double measured_ = 0.0; ///< meters; 0: not measured yet
};

} // namespace dewpoint::tracking
