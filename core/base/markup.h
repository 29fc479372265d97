// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace dewpoint {

/// Text as HTML and SVG write it, also within an attribute in double quotes.
std::string escaped(const std::string& text);

} // namespace dewpoint
