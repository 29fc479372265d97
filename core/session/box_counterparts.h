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

/// Returns the index in `all` of a target that had the index `index` and the name `name` when there
/// were `count` targets. If `all` has `count` targets too, this is `index`, even if the target
/// there has another name, since it may have been renamed. Otherwise, it is the index of the target
/// called `name`, or -1 if there is none.
template <class Targets, class NameOf>
int indexOfSameTarget(const Targets& all, const NameOf& nameOf, std::size_t count,
                      std::size_t index, const std::string& name) {
  if (all.size() == count) {
    return static_cast<int>(index);
  }
  const auto found = std::ranges::find(all, name, nameOf);
  return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

/// Returns, for each target in `before`, its index in `after`, or -1 if it no longer exists.
std::vector<int> newIndices(const std::vector<Target>& before, const std::vector<Target>& after);

/// Returns whether every target has kept its index. `numbers` is the result of newIndices().
bool areIndicesUnchanged(const std::vector<int>& numbers);

/// Returns the first frame whose result differs after the boxes have changed from those of `before`
/// to those of `after`. This is the first frame in which a box was added, changed or removed. Only
/// targets that still exist count: a removed target does not affect the others. Returns nothing if
/// no result differs.
std::optional<std::int64_t> firstChangedFrame(const std::vector<Target>& before,
                                              const std::vector<Target>& after);

} // namespace dewpoint::session
