// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <string>

namespace dewpoint::experiment {

/// Creates a report folder and tries to write into it, so that a failure is detected before minutes
/// of computation. Returns FileUnwritable with the name of the folder if this fails, or with the
/// name of the report file if a folder has this name.
Status prepareReportFolder(const std::filesystem::path& folder,
                           const std::string& report = "report.html");

} // namespace dewpoint::experiment
