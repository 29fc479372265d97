// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>

namespace dewpoint::base {

/// Returns the text with its special characters escaped for HTML and SVG. The result can be used as
/// content or as an attribute value in double quotes.
std::string htmlEscaped(const std::string& text);

} // namespace dewpoint::base
