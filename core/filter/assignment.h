// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::filter {

/// The value for "no column" in an Assignment.
inline constexpr Eigen::Index kUnassigned = -1;

/// The column assigned to each row. A column is assigned at most once.
struct Assignment {
  std::vector<Eigen::Index> columnOfRow; ///< one entry per row; kUnassigned for none
  Eigen::Index pairCount = 0;            ///< rows with a column
  double cost = 0.0;                     ///< sum over the pairs, in the unit of the costs
};

/// Minimum-cost assignment of the rows of `cost` to its columns, each used at most once; any shape,
/// any sign, empty too. A pair whose cost is not finite is forbidden. First as many pairs as
/// possible are made, then their sum is made as small as possible. Equal inputs give equal results,
/// ties included. Shortest augmenting paths (Jonker & Volgenant 1987, in the rectangular form of
/// Crouse 2016, "On implementing 2D rectangular assignment algorithms"): at most s²l steps, s the
/// shorter and l the longer side.
Assignment assignMinimumCost(const Eigen::MatrixXd& cost);

} // namespace dewpoint::filter
