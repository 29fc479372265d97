// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <filesystem>
#include <string>

namespace dewpoint::simulation {
struct OfficeScene;
} // namespace dewpoint::simulation

namespace dewpoint::app {

/// Writes a recording of a simulated office scene with people, ready to track, to a folder, and
/// returns the exit code. The files are a video and a background image per camera, project.toml,
/// calibration.toml, and truth.csv. Error messages name `option`, the command-line option that
/// gives the folder.
int recordOffice(const OfficeScene& scene, const std::filesystem::path& folder,
                 const std::string& option);

} // namespace dewpoint::app
