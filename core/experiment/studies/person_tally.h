// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/studies/silhouette_overlap.h"

namespace dewpoint::experiment {

/// Mean of a sequence of numbers.
class RunningMean {
public:
  /// Adds a number; NaN is ignored.
  void add(double value);
  /// Returns the mean of the numbers, or NaN if there are none.
  double mean() const;

private:
  double sum_ = 0.0;
  int count_ = 0;
};

/// Results of a method for one person in a scene.
struct PersonResult {
  double height = 0.0; ///< true height, meters
  /// Fraction of frames with an estimate near the person, among the frames in which at least two
  /// cameras see the person. NaN without such frames.
  double found = std::numeric_limits<double>::quiet_NaN();
  /// Scores of the silhouette of the 95 % volume, averaged over all cameras and frames with an
  /// estimate.
  SilhouetteScores silhouette;
  /// Mean absolute height error, meters. NaN if the method does not estimate the height.
  double heightError = std::numeric_limits<double>::quiet_NaN();
};

/// Accumulates the results of a method for one person or for all people.
class PersonTally {
public:
  /// Adds a frame in which at least two cameras see the person. `found` states whether there is an
  /// estimate near the person.
  void addFrame(bool found) { found_.add(found ? 1.0 : 0.0); }
  /// Adds the overlap of the estimated volume's outline in a camera that sees the person.
  void addSilhouette(const SilhouetteOverlap& overlap);
  /// Adds a height error: the estimated height minus the true height, meters.
  void addHeightError(double error);

  /// Returns the results. `height` is the true height in meters, or 0 for a tally of several
  /// people.
  PersonResult result(double height) const;

private:
  RunningMean found_;
  RunningMean recall_;
  RunningMean precision_;
  RunningMean iou_;
  RunningMean heightError_;
};

} // namespace dewpoint::experiment
