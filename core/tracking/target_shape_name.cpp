// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/target_shape_name.h"

#include <algorithm>
#include <array>
#include <utility>

namespace dewpoint::tracking {
namespace {

constexpr std::array<std::pair<TargetShape, const char*>, 3> kNames{
    {{TargetShape::Auto, "auto"}, {TargetShape::Ball, "ball"}, {TargetShape::Any, "any"}}};

} // namespace

std::string nameOf(TargetShape shape) {
  const auto* const row =
      std::ranges::find(kNames, shape, &std::pair<TargetShape, const char*>::first);
  return row->second;
}

std::optional<TargetShape> targetShapeFromName(std::string_view name) {
  const auto* const row =
      std::ranges::find_if(kNames, [&](const auto& entry) { return name == entry.second; });
  return row != kNames.end() ? std::optional(row->first) : std::nullopt;
}

std::vector<std::string> targetShapeNames() {
  std::vector<std::string> names;
  names.reserve(kNames.size());
  for (const auto& [shape, name] : kNames) {
    names.emplace_back(name);
  }
  return names;
}

} // namespace dewpoint::tracking
