// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/table_reader.h"
#include "core/project/project.h"

#include <string>

namespace dewpoint::project {

/// Reads the position corrections ([[correction]]), ordered by frame.
void readCorrections(TableReader& reader, const std::string& file, Project& project);
/// Returns the position corrections as TOML.
std::string correctionsText(const Project& project);
/// Checks the position corrections. Returns BadValue, naming the correction, if one has an unknown
/// target or camera, a negative frame, a number that is not finite, or an invalid covariance.
Status checkCorrections(const Project& project);

} // namespace dewpoint::project
