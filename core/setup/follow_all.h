// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_assessment.h"
#include "core/project/project.h"

#include <cstddef>
#include <functional>
#include <string>

namespace dewpoint::setup {

/// Returns how many targets must be added to track all objects that have the color and size of a
/// target. `assessment` is the assessment of this target's color. Targets that already have the
/// same colors are subtracted. Returns 0 unless the assessment suggests tracking all these objects.
int missingTargetCount(const Project& project, std::size_t target,
                       const ColorAssessment& assessment);

/// Adds `count` copies of a target, without its samples. Before each copy is added, `nameOf` is
/// called with the project and returns the name of the copy.
void addTargetCopies(Project& project, std::size_t target, int count,
                     const std::function<std::string(const Project&)>& nameOf);

/// Returns a name that no target has yet. `nameOf` converts a number to a name. Numbers are tried
/// in ascending order, starting at the number of targets plus one.
std::string unusedTargetName(const Project& project,
                             const std::function<std::string(std::size_t)>& nameOf);

} // namespace dewpoint::setup
