// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <filesystem>
#include <map>

namespace dewpoint::project {

/// Where files are that a project names elsewhere, by the absolute path that it names.
using MovedFiles = std::map<std::filesystem::path, std::filesystem::path>;

} // namespace dewpoint::project
