// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/parameters.h"

#include <string>

namespace dewpoint::tracking {

/// Returns a description of a declared parameter in one line, without its key: "0.03 m (0 to 10).
/// Standard deviation of ...". If a value that is not given is derived from the cameras, the text
/// says so.
std::string parameterText(const ParameterDeclaration& declaration);

/// Returns the description of a method in plain text: what it tracks, its distinguishing feature,
/// its paper, and its parameters, one per line. Ends with a line break.
std::string methodReference(const Method& method);

} // namespace dewpoint::tracking
