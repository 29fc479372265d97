// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>

namespace dewpoint::project {

/// Returns the TOML text `fresh` with comments inserted: the comments that the user wrote in
/// `former`, an earlier version of the same file. For each table or key that still exists, the
/// comments directly above it and after its value are kept. Comments at the beginning and at the
/// end of the file are also kept. Entries of arrays of tables are matched by `name`, or by index if
/// they have none. Applying the function again changes nothing. Comments inside values that span
/// several lines are lost.
std::string withComments(const std::string& fresh, const std::string& former);

} // namespace dewpoint::project
