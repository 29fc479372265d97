// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <string_view>

namespace dewpoint::setup {

/// Returns the parameters with which a project is tracked if it specifies none: the defaults of its
/// method, and values derived from its cameras.
ParameterValues defaultParameters(const Project& project);

/// Returns whether a parameter in use (`used`) differs from its default in the project (`defaults`,
/// from defaultParameters()). For a parameter derived from the cameras, the declared default also
/// counts as unchanged.
bool isChanged(const ParameterValues& used, const ParameterValues& defaults,
               const ParameterDeclaration& declaration);

/// Resets a parameter to its value in defaultParameters(). The parameter must be declared
/// (asserted). If it is derived from the cameras, the other parameters derived from the cameras
/// keep the values in use. If all of these parameters then equal the derived values, they are no
/// longer marked as given in the project.
void resetParameter(Project& project, std::string_view key);
/// Resets all parameters of a project that differ from their defaults.
void resetParameters(Project& project);

} // namespace dewpoint::setup
