// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <string>

namespace dewpoint::experiment {

/// Makes the folder of a report and tries to write into it, so that this is known before minutes
/// are spent. FileUnwritable names the folder, or the report when a folder has its name.
Status prepareReportFolder(const std::filesystem::path& folder,
                           const std::string& report = "report.html");

} // namespace dewpoint::experiment
