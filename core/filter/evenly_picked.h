// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <algorithm>

namespace dewpoint::filter {

/// Copies at most `limit` particles for display, evenly spaced in the order of the set. Copies the
/// first `columns` columns of the states, and the weights without normalizing them again. `Weights`
/// is any type with operator[].
template <class States, class Weights>
void pickEvenly(const States& states, const Weights& weights, int limit, Eigen::Index columns,
                Eigen::ArrayXXd& shownStates, Eigen::ArrayXd& shownWeights) {
  const Eigen::Index count = states.rows();
  const Eigen::Index shown = std::clamp<Eigen::Index>(limit, 0, count);
  shownStates.resize(shown, columns);
  shownWeights.resize(shown);
  for (Eigen::Index i = 0; i < shown; ++i) {
    const Eigen::Index picked = i * count / shown;
    shownStates.row(i) = states.row(picked).leftCols(columns);
    shownWeights[i] = weights[picked];
  }
}

} // namespace dewpoint::filter
