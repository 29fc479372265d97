// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>

namespace dewpoint::capture {

/// Returns whether `left` comes before `right` in natural order: digits inside names are compared
/// as numbers ("2" < "10"), everything else by byte. Frames are sorted in this order because it
/// does not depend on language settings.
bool naturallyBefore(const std::string& left, const std::string& right);

} // namespace dewpoint::capture
