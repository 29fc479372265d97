// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/table_reader.h"
#include "core/project/project.h"

#include <cstddef>
#include <optional>
#include <string>

namespace dewpoint::project {

/// Reads a [[target]]; `index` counts from 0. The first thing that is wrong goes into `error`.
Target readTarget(const toml::table& table, const std::string& file, std::size_t index,
                  std::optional<Error>& error);
std::string targetText(const Target& target);

} // namespace dewpoint::project
