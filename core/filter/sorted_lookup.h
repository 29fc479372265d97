// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace dewpoint {

/// Finds the first element of a rising sequence that is greater than a value, as std::upper_bound
/// does, in constant time on average for values spread evenly: the span of the values is cut into
/// equal cells, and a table says where each begins ("guide table", Chen & Asau 1974).
class SortedLookup {
public:
  /// The sequence stays where it is: at least one element, fewer than 2^31, finite, none below
  /// `low`. With more cells for each element fewer steps are left to walk.
  void build(const double* sequence, std::int32_t count, double low, std::int32_t cellsPerElement);

  /// found[i] = index of the first element greater than values[i]; where there is none, the first
  /// of the greatest elements.
  void find(const double* values, std::int64_t count, std::int32_t* found) const;

private:
  const double* sequence_ = nullptr;
  std::int32_t greatest_ = 0; ///< the first of the greatest elements
  std::int32_t lastCell_ = 0;
  double low_ = 0.0;
  double cellsPerValue_ = 0.0;
  std::vector<std::int32_t> first_; ///< the first element of this cell or a later one
  std::vector<std::int32_t> cellOf_;
};

} // namespace dewpoint
