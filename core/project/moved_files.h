// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <filesystem>
#include <map>

namespace dewpoint::project {

/// Current locations of files that have moved. The key is the absolute path given in the project;
/// the value is the current path.
using MovedFiles = std::map<std::filesystem::path, std::filesystem::path>;

} // namespace dewpoint::project
