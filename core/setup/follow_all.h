// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_assessment.h"
#include "core/project/project.h"

#include <cstddef>
#include <functional>
#include <string>

namespace dewpoint::setup {

/// How many targets are missing to follow all objects with the color and size of a target,
/// as an assessment of its color found them: those with its colors count as theirs. 0 unless the
/// assessment suggests to follow all.
int missingTargets(const Project& project, std::size_t target, const ColorAssessment& assessment);

/// Adds `count` targets like one, each without samples and with the name that `nameOf` gives it in
/// the project as it is then.
void addTargetsLike(Project& project, std::size_t target, int count,
                    const std::function<std::string(const Project&)>& nameOf);

/// A name that no target has yet, as `nameOf` gives them to numbers: the first from the number of
/// targets plus one on.
std::string freeTargetName(const Project& project,
                           const std::function<std::string(std::size_t)>& nameOf);

} // namespace dewpoint::setup
