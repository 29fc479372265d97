// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/table_reader.h"
#include "core/project/project.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::project {

/// Reads a [[target]] table; `index` counts from 0. If the table has errors, the first one is
/// stored in `error`.
Target readTarget(const toml::table& table, const std::string& file, std::size_t index,
                  std::optional<Error>& error);
/// Returns a target as TOML.
std::string targetText(const Target& target);

/// Replaces the targets of a project. Corrections are kept for targets with the same name, and
/// removed for targets that no longer exist.
void replaceTargets(Project& project, std::vector<Target> targets);

} // namespace dewpoint::project
