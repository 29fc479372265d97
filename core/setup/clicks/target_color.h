// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/target.h"

#include <cstddef>

namespace dewpoint::setup {

/// Removes the color with this index in Target::colors() from a target, together with the samples
/// that match it better than any other color of the target. The only color of a target is not
/// removed.
void removeColor(std::size_t index, Target& target);

/// Replaces the color with this index in Target::colors().
void setColor(std::size_t index, const ColorRange& range, Target& target);

} // namespace dewpoint::setup
