// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/studies/silhouette_overlap.h"

namespace dewpoint::experiment {

/// A mean of numbers that come one after the other.
class RunningMean {
public:
  /// NaN is left out.
  void add(double value);
  /// NaN without numbers.
  double mean() const;

private:
  double sum_ = 0.0;
  int count_ = 0;
};

/// How a method did on one person of a scene.
struct PersonResult {
  double height = 0.0; ///< true, meters
  /// Of the frames in which at least two cameras see the person, the share in which the method has
  /// an estimate within reach; NaN when there were none.
  double found = std::numeric_limits<double>::quiet_NaN();
  SilhouetteScores silhouette; ///< of the 95 % volume, over cameras and instants with an estimate
  /// Mean absolute error of the height, meters; NaN of a method that estimates none.
  double heightError = std::numeric_limits<double>::quiet_NaN();
};

/// Sums up what a method does on one person, or on all.
class PersonTally {
public:
  /// A frame in which at least two cameras see the person.
  void addFrame(bool found) { found_.add(found ? 1.0 : 0.0); }
  /// The outline of the estimated volume in a camera that sees the person.
  void addSilhouette(const SilhouetteOverlap& overlap);
  /// An estimated height minus the true one, meters.
  void addHeightError(double error);

  /// `height`: true, meters; 0 for a tally of several people.
  PersonResult result(double height) const;

private:
  RunningMean found_;
  RunningMean recall_;
  RunningMean precision_;
  RunningMean iou_;
  RunningMean heightError_;
};

} // namespace dewpoint::experiment
