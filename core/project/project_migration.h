// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <toml++/toml.h>

#include <cstdint>

namespace dewpoint::project {

/// Converts the tables of a project file in an older format to the present format, step by step, so
/// that the reader has to support only one format. Formats:
/// 1: general keys, [parameters], [[target]], [[camera]];
/// 2: as format 1, plus [[target.sample]], [[mark]] and [window]. Files of format 1 need no
///    conversion for these.
/// Each step that renames or converts an entry belongs here, with a file of the old format in the
/// tests. The format number in the table is also updated.
void migrateProject(toml::table& project, std::int64_t format);

} // namespace dewpoint::project
