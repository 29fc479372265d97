// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/table_reader.h"
#include "core/project/project.h"

#include <string>

namespace dewpoint::project {

/// Reads the corrections of positions, [[correction]], in the order of their frames.
void readCorrections(TableReader& reader, const std::string& file, Project& project);
std::string correctionsText(const Project& project);
/// BadValue names the one that cannot be: of a target or camera that is not there, of a negative
/// frame, not finite, or with a covariance that is none.
Status checkCorrections(const Project& project);

} // namespace dewpoint::project
