// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/studies/figure_experiments.h"

#include <span>

namespace dewpoint::experiment {

/// Studies of boxes and of people, as experiments with defaults that take minutes: sugandi-rmse,
/// and people-<scenario> for every scene of people. The command line has all their options.
std::span<const FigureExperiment> studyExperiments();

} // namespace dewpoint::experiment
