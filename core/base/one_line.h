// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace dewpoint::base {

/// The bytes of the UTF-8 character that a text begins with; 0: there is none, or the bytes are not
/// UTF-8.
std::size_t utf8Bytes(std::string_view text);

/// A part of a message on one line: what a file said may hold line breaks, other control characters
/// and bytes that are no UTF-8, which become question marks. Of more than 4000 bytes the end is
/// cut.
std::string onOneLine(std::string_view text);

} // namespace dewpoint::base
