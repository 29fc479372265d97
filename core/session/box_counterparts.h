// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/target.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::session {

/// Returns the index in `all` of the target that had the given index and name when there were
/// `count` targets. If there are still `count` targets, the index is unchanged, since a target may
/// have been renamed. Otherwise it is the index of the target with the same name, or -1 if there is
/// none.
template <class Targets, class NameOf>
int counterpart(const Targets& all, const NameOf& nameOf, std::size_t count, std::size_t index,
                const std::string& name) {
  if (all.size() == count) {
    return static_cast<int>(index);
  }
  const auto found = std::ranges::find(all, name, nameOf);
  return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

/// Returns the index in `after` for each target in `before`; -1 if the target no longer exists.
std::vector<int> newIndices(const std::vector<Target>& before, const std::vector<Target>& after);

/// Returns whether every target has kept its index.
bool areIndicesUnchanged(const std::vector<int>& numbers);

/// Returns the first frame whose result differs after the boxes have changed. It is the first frame
/// with a box that was added, changed, or removed from a target that still exists. A removed target
/// does not affect the others. Returns nothing if no result differs.
std::optional<std::int64_t> firstChangedFrame(const std::vector<Target>& before,
                                              const std::vector<Target>& after);

} // namespace dewpoint::session
