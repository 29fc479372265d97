// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/table_reader.h"
#include "core/project/project.h"

#include <string>

namespace dewpoint::project {

/// Reads the corrections for people ([[person]]), ordered by frame.
void readPeople(TableReader& reader, const std::string& file, Project& project);
/// Returns the corrections for people as TOML.
std::string peopleText(const Project& project);
/// Checks the corrections for people. Returns BadValue, naming the correction, if one is invalid.
Status checkPeople(const Project& project);

} // namespace dewpoint::project
