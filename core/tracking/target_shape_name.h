// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/target.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::tracking {

/// Returns the name of a shape in files and on the command line: `auto`, `ball` or `any`.
std::string nameOf(TargetShape shape);
/// Returns the shape with this name, or nothing for an unknown name.
std::optional<TargetShape> targetShapeFromName(std::string_view name);
/// Returns the names of all shapes, in the order of TargetShape.
std::vector<std::string> targetShapeNames();

} // namespace dewpoint::tracking
