// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/project.h"
#include "core/setup/doctor/examination.h"
#include "core/setup/doctor/finding.h"

#include <filesystem>
#include <vector>

namespace dewpoint::setup {

/// Runs all checks on a project and returns their findings, both good and bad. `project` must
/// include its cameras, even if they come from a scene. Reads files, which may take a few seconds,
/// or longer with `decodesEveryFrame`. Opens no camera devices and writes nothing.
std::vector<Finding> examine(const Project& project, const ExaminationOptions& options);

/// Returns findings about a project file that could not be read.
std::vector<Finding> examineUnreadableProject(const std::filesystem::path& file,
                                              const Error& error);

} // namespace dewpoint::setup
