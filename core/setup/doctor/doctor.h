// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/project.h"
#include "core/setup/doctor/examination.h"
#include "core/setup/doctor/finding.h"

#include <filesystem>
#include <vector>

namespace dewpoint::setup {

/// Runs all checks of a project, one after another, and returns what is wrong and what is correct.
/// `project` has its cameras, also those of a scene. Reads files, which may take some seconds,
/// longer with `everyFrame`. It opens no cameras and writes nothing.
std::vector<Finding> examine(const Project& project, const ExaminationWishes& wishes);

/// Returns findings about a project file that could not be read.
std::vector<Finding> examineUnreadable(const std::filesystem::path& file, const Error& error);

} // namespace dewpoint::setup
