// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <string_view>

namespace dewpoint::setup {

/// Returns the parameters used to track a project if none are given: the defaults of its method,
/// and values derived from its cameras.
ParameterValues defaultParameters(const Project& project);

/// Returns whether a parameter in use differs from defaultParameters(). For a parameter derived
/// from the cameras, the declared default also counts as unchanged.
bool isChanged(const ParameterValues& used, const ParameterValues& defaults,
               const ParameterDeclaration& declaration);

/// Resets a parameter, which must be declared (asserted), to its value in defaultParameters(). If
/// it is derived from the cameras, the other parameters derived from them keep the values in use.
/// If all of them then equal the derived values, they are no longer marked as given in the project.
void resetParameter(Project& project, std::string_view key);
/// Resets all parameters for which isChanged() is true.
void resetParameters(Project& project);

} // namespace dewpoint::setup
