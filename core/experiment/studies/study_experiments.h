// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/studies/figure_experiments.h"

#include <span>

namespace dewpoint::experiment {

/// Returns the studies of boxes and people as experiments: sugandi-rmse, and people-<scenario> for
/// every scene with people. With their default settings, they take minutes. All their options are
/// available on the command line.
std::span<const FigureExperiment> studyExperiments();

} // namespace dewpoint::experiment
