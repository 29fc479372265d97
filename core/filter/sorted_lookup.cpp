// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/sorted_lookup.h"

#include "core/base/vector_kernel.h"

#include <algorithm>
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
  first_.assign(static_cast<std::size_t>(cellCount), greatest_);
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
  for (std::int64_t i = 0; i < count; ++i) {
    std::int32_t at = first_[static_cast<std::size_t>(found[i])];
    // Two steps without a branch, then as many as it takes, mostly none. The greatest element ends
    // the walk: past it there is nothing but its equals.
    at += static_cast<std::int32_t>((at < greatest_) & (sequence_[at] <= values[i]));
    at += static_cast<std::int32_t>((at < greatest_) & (sequence_[at] <= values[i]));
    while (at < greatest_ && sequence_[at] <= values[i]) {
      ++at;
    }
    found[i] = at;
  }
}

} // namespace dewpoint
