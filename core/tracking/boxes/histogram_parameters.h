// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/parameters.h"

#include <span>

namespace dewpoint::tracking {

/// Returns the parameters of the `histogram` method. Lengths are relative to the target's size (the
/// square root of its box's area), so they suit targets of any size.
std::span<const ParameterDeclaration> histogramParameters();

} // namespace dewpoint::tracking
