// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/parameters.h"

#include <string>

namespace dewpoint::tracking {

/// A declared parameter in one line, without its key: "0.03 m (0 to 10). Standard deviation of
/// ..."; a value that comes from the cameras unless it is given says so.
std::string parameterText(const ParameterDeclaration& declaration);

/// A method in plain text: what it follows, what sets it apart, its paper, and its parameters, a
/// line each. Ends with a line break.
std::string methodReference(const Method& method);

} // namespace dewpoint::tracking
