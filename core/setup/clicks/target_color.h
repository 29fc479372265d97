// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/target.h"

#include <cstddef>

namespace dewpoint::setup {

/// Removes one of several colors (an index of Target::colors()) from a target, with the samples
/// that match it better than any other color. The only color of a target is not removed.
void removeColor(std::size_t index, Target& target);

/// Replaces one of the target's colors (an index of Target::colors()).
void setColor(std::size_t index, const ColorRange& range, Target& target);

} // namespace dewpoint::setup
