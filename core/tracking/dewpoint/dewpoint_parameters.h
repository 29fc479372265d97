// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/parameters.h"

#include <span>

namespace dewpoint::tracking {

/// Returns the declarations of the parameters of the `dewpoint` method.
std::span<const ParameterDeclaration> dewpointParameters();

} // namespace dewpoint::tracking
