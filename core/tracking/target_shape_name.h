// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/target.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::tracking {

/// The name of a shape in files and on the command line: `auto`, `ball` or `any`.
std::string nameOf(TargetShape shape);
/// The shape of this name; nothing where there is none.
std::optional<TargetShape> targetShapeNamed(std::string_view name);
/// All names, in the order of TargetShape.
std::vector<std::string> targetShapeNames();

} // namespace dewpoint::tracking
