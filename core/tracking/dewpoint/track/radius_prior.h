// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::tracking {

/// What is known of a target's radius before an outline shows it. One that somebody gave is taken
/// as it is, and is more exact than what images show, until an outline contradicts it: it may be
/// wrong by a quarter. Then, as where none is given, the radius is measured and remembered.
class RadiusPrior {
public:
  /// Meters; 0: nobody gave one.
  explicit RadiusPrior(double given = 0.0) : given_(given) {}

  /// Forgets what was measured.
  void restart() { measured_ = 0.0; }
  /// A surely seen target has this radius (m), with this variance of its logarithm; 0: it was not
  /// measured.
  void learn(double radius, double logVariance);

  bool isGiven() const { return given_ > 0.0; }
  /// Whether the given radius holds so far.
  bool isTrusted() const { return isGiven() && measured_ <= 0.0; }
  /// Whether an outline of this radius (m) does not agree with the given one.
  bool contradicts(double radius) const;
  /// Meters: the measured radius, else the given one, else a usual one.
  double expected() const;
  /// Variance of the logarithm with which a fit begins; 0 for a trusted radius.
  double logVariance() const { return isTrusted() ? 0.0 : unknownLogVariance(); }
  /// The same where nothing is known.
  static double unknownLogVariance();
  /// What another radius than the expected one costs, in nats: half the squared distance (standard
  /// deviations) of the logarithms, with an upper bound, since somebody may have measured wrongly.
  /// 0 where nothing is known.
  double penalty(double radius) const;
  /// Whether an object of this radius (m) may be the target.
  bool allows(double radius) const;

private:
  double given_;
  double measured_ = 0.0; ///< meters; 0: not yet
};

} // namespace dewpoint::tracking
