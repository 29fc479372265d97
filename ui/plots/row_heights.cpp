// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/row_heights.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace dewpoint::ui {

namespace {

int totalHeight(std::span<const int> heights) {
  return std::accumulate(heights.begin(), heights.end(), 0);
}

/// Enlarges rows in proportion to their heights until they take so many pixels together.
void enlarge(std::span<int> rows, int total) {
  int before = totalHeight(rows);
  for (int& row : rows) { // each takes its share of what is left, so that the sum is exact
    const int after = static_cast<int>(std::lround(static_cast<double>(row) * total / before));
    before -= row;
    total -= after;
    row = after;
  }
}

} // namespace

std::vector<int> heightsForWholeRows(const std::vector<int>& least, int visible) {
  if (totalHeight(least) <= visible) {
    return {};
  }
  std::vector<int> heights = least;
  std::size_t first = 0; // number of rows at the beginning that are visible as a whole
  for (int used = least[0]; used <= visible; used += least[first]) {
    ++first;
  }
  if (first == 0) {
    return heights;
  }
  enlarge(std::span(heights).first(first), visible);
  // At the end of the stack, only rows after the first ones may still change.
  std::size_t begin = heights.size(); // where the rows begin that are visible there
  int used = 0;
  while (used + heights[begin - 1] <= visible) {
    used += heights[--begin];
  }
  const std::size_t changing = std::max(begin, first);
  if (changing < heights.size()) {
    const auto rows = std::span(heights).subspan(changing);
    enlarge(rows, totalHeight(rows) + visible - used);
  }
  return heights;
}

} // namespace dewpoint::ui
