// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>

namespace dewpoint::capture {

/// Whether `left` comes before `right` when numbers inside names count as numbers ("2" < "10") and
/// all else by its bytes: the order of frames, which must not depend on what letters people take
/// for the same.
bool naturallyBefore(const std::string& left, const std::string& right);

} // namespace dewpoint::capture
