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

/// Returns the current index, in `all`, of a target that had the index `index` and the name `name`
/// when there were `count` targets. If `all` still has `count` targets, returns `index`: the target
/// may only have been renamed. Otherwise, returns the index of the target called `name`, or -1 if
/// there is none.
template <class Targets, class NameOf>
int indexOfSameTarget(const Targets& all, const NameOf& nameOf, std::size_t count,
                      std::size_t index, const std::string& name) {
  if (all.size() == count) {
    return static_cast<int>(index);
  }
  const auto found = std::ranges::find(all, name, nameOf);
  return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

/// Returns the new index of each target: for each target in `before`, its index in `after`, or -1
/// if the target no longer exists.
std::vector<int> newIndices(const std::vector<Target>& before, const std::vector<Target>& after);

/// Returns whether every target has kept its index. `numbers` is the result of newIndices(): the
/// new index of each target.
bool areIndicesUnchanged(const std::vector<int>& numbers);

/// Returns the first frame that must be tracked again after the user has changed the boxes of
/// targets: the first frame in which a box was added, changed or removed. `before` are the targets
/// with their old boxes, `after` with their new ones. Targets that were removed are ignored because
/// they do not affect the others. Returns nothing if no result changes.
std::optional<std::int64_t> firstChangedFrame(const std::vector<Target>& before,
                                              const std::vector<Target>& after);

} // namespace dewpoint::session
