// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <string_view>

namespace dewpoint::setup {

/// The parameters with which a project is tracked while none is given: the defaults of its method,
/// and what its cameras say.
ParameterValues defaultParameters(const Project& project);

/// Whether a parameter in use is otherwise than in defaultParameters(). Of those that come from the
/// cameras the declared default is one, too.
bool isChanged(const ParameterValues& used, const ParameterValues& defaults,
               const ParameterDeclaration& declaration);

/// Gives a declared parameter (asserted) the value that it has in defaultParameters(). Of those
/// that come from the cameras the others stay as they are in use; when all of them are as the
/// cameras say, none is given any more.
void resetParameter(Project& project, std::string_view key);
/// The same for all that isChanged().
void resetParameters(Project& project);

} // namespace dewpoint::setup
