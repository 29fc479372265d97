// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <toml++/toml.h>

#include <cstdint>

namespace dewpoint::project {

/// Turns the tables of an older project file into those of the present format, step by step, so
/// that only one format has to be read. Formats:
/// 1: head, [parameters], [[target]], [[camera]];
/// 2: the same, and [[target.sample]], [[mark]] and [window], which nothing of format 1 has to
///    change for.
/// A step that renames or restates something belongs here, with a file of the old format in the
/// tests. The format itself is changed to the present one.
void migrateProject(toml::table& project, std::int64_t format);

} // namespace dewpoint::project
