// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/project.h"
#include "core/setup/doctor/examination.h"
#include "core/setup/doctor/finding.h"

#include <filesystem>
#include <vector>

namespace dewpoint::setup {

/// What is wrong with a project, and what is right: all checks, one after the other. `project` has
/// its cameras, also those of a scene. Reads files, may take some seconds, more with everyFrame;
/// cameras are not opened, nor is anything written.
std::vector<Finding> examine(const Project& project, const ExaminationOptions& options);

/// Returns findings about a project file that could not be read.
std::vector<Finding> examineUnreadable(const std::filesystem::path& file, const Error& error);

} // namespace dewpoint::setup
