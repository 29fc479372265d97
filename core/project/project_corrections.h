// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/table_reader.h"
#include "core/project/project.h"

#include <string>

namespace dewpoint::project {

/// Reads the corrections of positions, [[correction]], in the order of their frames.
void readCorrections(TableReader& reader, const std::string& file, Project& project);
/// Returns the corrections of positions as TOML.
std::string correctionsText(const Project& project);
/// Checks the corrections of positions. BadValue names an invalid one: unknown target or camera,
/// negative frame, number that is not finite, or invalid covariance.
Status checkCorrections(const Project& project);

} // namespace dewpoint::project
