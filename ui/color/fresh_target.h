// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>

namespace dewpoint::project {
struct Project;
} // namespace dewpoint::project

namespace dewpoint::ui {

/// Returns an unused target name, translated: "target 1", "target 2", ...
std::string newTargetName(const Project& project);

} // namespace dewpoint::ui
