// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>

namespace dewpoint::capture {

/// Returns whether `left` comes before `right` in natural order: digits inside names are compared
/// as numbers ("2" < "10"), everything else by byte. The images of a recording are sorted in this
/// order. It does not depend on language settings.
bool isBeforeInNaturalOrder(const std::string& left, const std::string& right);

} // namespace dewpoint::capture
