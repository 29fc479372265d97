// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace dewpoint::base {

/// Number of bytes of the UTF-8 character at the beginning of a text, which is not empty; 0 when
/// the bytes are not valid UTF-8.
std::size_t utf8Bytes(std::string_view text);

/// Puts a part of a message on one line. Line breaks, other control characters and invalid UTF-8,
/// which a file may contain, become question marks. Texts of more than 4000 bytes are truncated.
std::string onOneLine(std::string_view text);

} // namespace dewpoint::base
