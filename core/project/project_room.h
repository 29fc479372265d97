// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/table_reader.h"
#include "core/project/project.h"

namespace dewpoint::project {

/// Reads the entries about the room from the project file: [volume_of_interest], [grid] and
/// [[point]].
void readRoom(TableReader& reader, const std::string& file, Project& project);
/// Returns [volume_of_interest], [grid] and [[point]] as TOML.
std::string roomText(const Project& project);
/// Checks that the volume of interest is not empty, that the grid can be drawn, and that every
/// measured point has a finite position and at most one click per camera. Clicks in cameras that do
/// not exist are errors.
Status checkRoom(const Project& project);

} // namespace dewpoint::project
