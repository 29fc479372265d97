// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <string>

namespace dewpoint::app {

/// Returns the token that remote commands must contain: the first line of a file. Returns the
/// errors of readTextFile(), and BadValue if the line is empty.
Result<std::string> readTokenFile(const std::string& file);

} // namespace dewpoint::app
