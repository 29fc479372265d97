// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>
#include <string_view>

namespace dewpoint::base {

/// Returns the text with the letters A to Z in lower case, for comparing names and file extensions.
std::string toLowerCase(std::string_view text);

} // namespace dewpoint::base
