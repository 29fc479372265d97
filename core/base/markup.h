// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>

namespace dewpoint::base {

/// Escapes text for HTML and SVG, including attributes in double quotes.
std::string htmlEscaped(const std::string& text);

} // namespace dewpoint::base
