// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/table_reader.h"
#include "core/project/project.h"

namespace dewpoint::project {

/// What a project knows of the room, as its file states it: [volume_of_interest], [grid] and
/// [[point]].
void readRoom(TableReader& reader, const std::string& file, Project& project);
std::string roomText(const Project& project);
/// A volume of interest that is not empty; a grid that can be drawn; points with finite positions,
/// clicked in cameras that are there, in each at most once.
Status checkRoom(const Project& project);

} // namespace dewpoint::project
