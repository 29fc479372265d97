// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>

namespace dewpoint::project {

/// The TOML text `fresh` with the comments that the user wrote into `former`, an earlier version of
/// it: those directly above a table or key that still exists, those behind its value, and the ones
/// at the beginning and the end of the file. Entries of arrays of tables are matched by their
/// `name`, else by their index. A second call changes nothing. Comments inside of values that go
/// over several lines are lost.
std::string withComments(const std::string& fresh, const std::string& former);

} // namespace dewpoint::project
