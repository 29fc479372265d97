// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/person_tally.h"

#include <cmath>

namespace dewpoint::experiment {

void RunningMean::add(double value) {
  if (!std::isnan(value)) {
    sum_ += value;
    ++count_;
  }
}

double RunningMean::mean() const {
  return count_ > 0 ? sum_ / count_ : std::numeric_limits<double>::quiet_NaN();
}

void PersonTally::addSilhouette(const SilhouetteOverlap& overlap) {
  recall_.add(overlap.recall());
  precision_.add(overlap.precision());
  iou_.add(overlap.iou());
}

void PersonTally::addHeightError(double error) {
  heightError_.add(std::abs(error));
}

PersonResult PersonTally::result(double height) const {
  return {
      height, found_.mean(), {recall_.mean(), precision_.mean(), iou_.mean()}, heightError_.mean()};
}

} // namespace dewpoint::experiment
