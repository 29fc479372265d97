// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <filesystem>
#include <string>

namespace dewpoint::simulation {
struct OfficeScene;
} // namespace dewpoint::simulation

namespace dewpoint::app {

/// Writes a simulated office scene with people, ready to track: a video and a background image per
/// camera, project.toml, calibration.toml, and truth.csv. `option` is the command-line option that
/// gives the folder; errors name it. Returns the exit code.
int recordOffice(const OfficeScene& scene, const std::filesystem::path& folder,
                 const std::string& option);

} // namespace dewpoint::app
