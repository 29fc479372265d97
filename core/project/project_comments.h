// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>

namespace dewpoint::project {

/// Returns the TOML text `fresh` with the user's comments from `former`, an earlier version of it.
/// It keeps comments directly above a table or key that still exists, comments after its value, and
/// those at the beginning and end of the file. Entries of arrays of tables are matched by `name`,
/// or by index if they have none. Applying the function again changes nothing. Comments inside
/// values that span several lines are lost.
std::string withComments(const std::string& fresh, const std::string& former);

} // namespace dewpoint::project
