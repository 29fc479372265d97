// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/table_reader.h"
#include "core/project/project.h"

#include <string>

namespace dewpoint::project {

/// Reads the corrections of people, [[person]], in the order of their frames.
void readPeople(TableReader& reader, const std::string& file, Project& project);
/// Returns the corrections of people as TOML.
std::string peopleText(const Project& project);
/// Checks the corrections of people. BadValue names an invalid one.
Status checkPeople(const Project& project);

} // namespace dewpoint::project
