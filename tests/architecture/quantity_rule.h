// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::tests {

/// Where a source file of the window writes a quantity by hand, as it stands there: a text with a
/// unit behind a number ("%1 px"), a number brought to another unit as it is written, or the number
/// of a frame with its 1 added. One function for each quantity does this (ui/text/quantity_text.h).
/// In the files of core and of the command line: where a number is brought to another unit other
/// than by core/base/units.h.
std::vector<std::string> quantitiesByHand(const std::string& path, std::string_view text);

} // namespace dewpoint::tests
