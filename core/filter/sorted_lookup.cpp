// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/sorted_lookup.h"

#include "core/base/vector_kernel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dewpoint {
namespace {

/// The cell of each value. Never falls with the value, whatever the rounding: so an element of an
/// earlier cell cannot be greater than the value.
struct CellKernel {
  DEWPOINT_KERNEL void run(const double* __restrict values, std::int64_t count, double low,
                           double cellsPerValue, std::int32_t lastCell,
                           std::int32_t* __restrict cells) {
    const double last = lastCell;
    for (std::int64_t i = 0; i < count; ++i) {
      const double cell = (values[i] - low) * cellsPerValue;
      const double positive = cell > 0.0 ? cell : 0.0; // NaN too
      cells[i] = static_cast<std::int32_t>(positive < last ? positive : last);
    }
  }
};

} // namespace

void SortedLookup::build(const double* sequence, std::int32_t count, double low,
                         std::int32_t cellsPerElement) {
  sequence_ = sequence;
  const double high = sequence[count - 1];
  greatest_ =
      static_cast<std::int32_t>(std::lower_bound(sequence, sequence + count, high) - sequence);
  const std::int32_t cellCount = count * cellsPerElement;
  lastCell_ = cellCount - 1;
  low_ = low;
  cellsPerValue_ = cellCount / (high - low);
  cellOf_.resize(static_cast<std::size_t>(count));
  runKernel<CellKernel>(sequence, std::int64_t{count}, low_, cellsPerValue_, lastCell_,
                        cellOf_.data());
  // Backwards, so that the first element of a cell is the one that stays; cells without elements
  // then take that of the next. No step depends on a comparison: branches here cannot be foreseen.
  first_.assign(static_cast<std::size_t>(cellCount) + 1, greatest_);
  for (std::int32_t i = greatest_; i >= 0; --i) {
    first_[static_cast<std::size_t>(cellOf_[static_cast<std::size_t>(i)])] = i;
  }
  std::int32_t next = greatest_;
  for (std::int32_t cell = lastCell_; cell >= 0; --cell) {
    std::int32_t& first = first_[static_cast<std::size_t>(cell)];
    next = std::min(next, first);
    first = next;
  }
}

void SortedLookup::find(const double* values, std::int64_t count, std::int32_t* found) const {
  runKernel<CellKernel>(values, count, low_, cellsPerValue_, lastCell_, found);
  const double* sequence = sequence_;
  const std::int32_t* first = first_.data();
  const double high = sequence[greatest_];
  const double belowHigh = std::nextafter(high, low_);
  for (std::int64_t i = 0; i < count; ++i) {
    const double value = values[i] < high ? values[i] : belowHigh;
    // The elements of the cell are begin to end - 1; those of later cells are greater. Mostly the
    // cell is empty or all of it lies on one side, and no branch is needed to see that.
    const std::int32_t begin = first[found[i]];
    const std::int32_t end = first[found[i] + 1];
    std::int32_t at = sequence[begin] > value ? begin : end;
    if (at > begin + 1 && sequence[end - 1] > value) [[unlikely]] {
      at = begin + 1;
      while (sequence[at] <= value) {
        ++at;
      }
    }
    found[i] = at;
  }
}

} // namespace dewpoint
