// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::filter {

/// Value that marks a row without a column in an `Assignment`.
inline constexpr Eigen::Index kUnassigned = -1;

/// Result of an assignment: the column of each row. No column is assigned twice.
struct Assignment {
  std::vector<Eigen::Index> columnOfRow; ///< one entry per row; kUnassigned if it has no column
  Eigen::Index pairCount = 0;            ///< number of rows with a column
  double cost = 0.0;                     ///< sum over the assigned pairs, in the unit of the costs
};

/// Assigns rows of `cost` to columns at minimum total cost; each row and each column is used at
/// most once. The matrix may have any shape and may be empty; costs may be negative. A pair whose
/// cost is not finite is forbidden. The number of pairs is maximized first, then their total cost
/// is minimized. Equal inputs give equal results, even when there are ties. Method: shortest
/// augmenting paths (Jonker & Volgenant 1987, in the rectangular form of Crouse 2016, "On
/// implementing 2D rectangular assignment algorithms"). The method takes at most s² l steps, where
/// s is the shorter and l the longer side of the matrix.
Assignment assignMinimumCost(const Eigen::MatrixXd& cost);

} // namespace dewpoint::filter
