// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <string>

namespace dewpoint::experiment {

/// Creates a report folder and tries to write into it, so that a failure is detected before minutes
/// of computation. If this fails, returns FileUnwritable with the name of the folder. If there is a
/// folder with the name of the report file, returns FileUnwritable with this name.
Status prepareReportFolder(const std::filesystem::path& folder,
                           const std::string& report = "report.html");

} // namespace dewpoint::experiment
