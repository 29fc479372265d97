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

/// Index in `all` of the target that was number `index` of `count`: the same while there are as
/// many (a target may have been renamed), else that of the same name; -1 if there is none.
template <class Targets, class NameOf>
int counterpart(const Targets& all, const NameOf& nameOf, std::size_t count, std::size_t index,
                const std::string& name) {
  if (all.size() == count) {
    return static_cast<int>(index);
  }
  const auto found = std::ranges::find(all, name, nameOf);
  return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

/// Where those of `before` are in `after`; -1 where they are not.
std::vector<int> numbersOf(const std::vector<Target>& before, const std::vector<Target>& after);

/// Whether all are where they were.
bool keepTheirNumbers(const std::vector<int>& numbers);

/// The first frame that is otherwise with other boxes: of each box that is new or another one, and
/// of each that a target has no more. Targets that are gone change nothing for the others.
std::optional<std::int64_t> firstChange(const std::vector<Target>& before,
                                        const std::vector<Target>& after);

} // namespace dewpoint::session
