// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace dewpoint::base {

/// Returns the number of bytes in the first UTF-8 character of a nonempty text, or 0 if the bytes
/// are not valid UTF-8.
std::size_t utf8CharacterSize(std::string_view text);

/// Returns the text as a single line, for use in a message. Line breaks, other control characters
/// and bytes that are not valid UTF-8 become question marks. Text of more than 4000 bytes is
/// truncated.
std::string toSingleLine(std::string_view text);

} // namespace dewpoint::base
