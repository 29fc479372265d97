// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/target.h"

#include <cstddef>

namespace dewpoint::setup {

/// Takes one of several colors (an index of Target::colors()) away from a target, with the samples
/// that show it rather than any other. A target keeps its only color.
void removeColor(std::size_t index, Target& target);

/// Changes one of its colors (an index of Target::colors()).
void setColor(std::size_t index, const ColorRange& range, Target& target);

} // namespace dewpoint::setup
