// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>

namespace dewpoint::base {

/// Text as HTML and SVG write it, also within an attribute in double quotes.
std::string escaped(const std::string& text);

} // namespace dewpoint::base
