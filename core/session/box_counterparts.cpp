// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/box_counterparts.h"

#include <numeric>

namespace dewpoint::session {

std::vector<int> newIndices(const std::vector<Target>& before, const std::vector<Target>& after) {
  std::vector<int> numbers;
  for (std::size_t k = 0; k < before.size(); ++k) {
    numbers.push_back(indexOfSameTarget(after, &Target::name, before.size(), k, before[k].name));
  }
  return numbers;
}

bool areIndicesUnchanged(const std::vector<int>& numbers) {
  std::vector<int> same(numbers.size());
  std::iota(same.begin(), same.end(), 0);
  return numbers == same;
}

std::optional<std::int64_t> firstChangedFrame(const std::vector<Target>& before,
                                              const std::vector<Target>& after) {
  std::optional<std::int64_t> first;
  for (std::size_t k = 0; k < after.size(); ++k) {
    const int old = indexOfSameTarget(before, &Target::name, after.size(), k, after[k].name);
    const auto oldBox = old >= 0 ? before[static_cast<std::size_t>(old)].box : std::nullopt;
    if (oldBox != after[k].box) {
      const std::int64_t frame = after[k].box ? after[k].box->frame : oldBox->frame;
      first = std::min(first.value_or(frame), frame);
    }
  }
  return first;
}

} // namespace dewpoint::session
