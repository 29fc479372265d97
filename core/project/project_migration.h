// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <toml++/toml.h>

#include <cstdint>

namespace dewpoint::project {

/// Converts the tables of a project file in an older format to the current format, one version at a
/// time. The reader therefore has to support only the current format. The format number in the
/// table is also updated. If a new format renames or converts entries, add a step here and a file
/// of the old format to the tests.
///
/// Formats:
/// - 1: general keys, [parameters], [[target]], [[camera]].
/// - 2: as format 1, plus [[target.sample]], [[mark]] and [window]. Files of format 1 need no
///   conversion for these.
void migrateProject(toml::table& project, std::int64_t format);

} // namespace dewpoint::project
