// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/table_reader.h"
#include "core/project/project.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::project {

/// Reads a [[target]]; `index` counts from 0. The first thing that is wrong goes into `error`.
Target readTarget(const toml::table& table, const std::string& file, std::size_t index,
                  std::optional<Error>& error);
std::string targetText(const Target& target);

/// Puts other targets in place of those of a project. Corrections go with the target of their name,
/// and are removed where there is none any more.
void replaceTargets(Project& project, std::vector<Target> targets);

} // namespace dewpoint::project
