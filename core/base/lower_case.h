// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>
#include <string_view>

namespace dewpoint::base {

/// A text with small letters for the capitals A to Z, to compare names and endings of files.
std::string inLowerCase(std::string_view text);

} // namespace dewpoint::base
