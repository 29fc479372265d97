// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/studies/silhouette_overlap.h"

namespace dewpoint::experiment {

/// Mean of a sequence of numbers.
class RunningMean {
public:
  /// Adds a number; NaN is ignored.
  void add(double value);
  /// Mean of the numbers; NaN if there are none.
  double mean() const;

private:
  double sum_ = 0.0;
  int count_ = 0;
};

/// Results of a method for one person of a scene.
struct PersonResult {
  double height = 0.0; ///< true height, meters
  /// Share of the frames with an estimate within reach, among those in which at least two cameras
  /// see the person; NaN without such frames.
  double found = std::numeric_limits<double>::quiet_NaN();
  SilhouetteScores silhouette; ///< of the 95 % volume, over cameras and instants with an estimate
  /// Mean absolute error of the height, meters; NaN if the method does not estimate it.
  double heightError = std::numeric_limits<double>::quiet_NaN();
};

/// Accumulates the results of a method for one person, or for all.
class PersonTally {
public:
  /// Adds a frame in which at least two cameras see the person.
  void addFrame(bool found) { found_.add(found ? 1.0 : 0.0); }
  /// Adds the outline of the estimated volume in a camera that sees the person.
  void addSilhouette(const SilhouetteOverlap& overlap);
  /// Adds an estimated height minus the true one, meters.
  void addHeightError(double error);

  /// Returns the results. `height` is the true one in meters; 0 for a tally of several people.
  PersonResult result(double height) const;

private:
  RunningMean found_;
  RunningMean recall_;
  RunningMean precision_;
  RunningMean iou_;
  RunningMean heightError_;
};

} // namespace dewpoint::experiment
