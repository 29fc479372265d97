// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/studies/figure_experiments.h"

#include <span>

namespace dewpoint::experiment {

/// Returns the studies of boxes and people as experiments: sugandi-rmse, and people-<scenario> for
/// every scenario with people. With default settings, each takes minutes. Only the command line
/// offers all options of these studies.
std::span<const FigureExperiment> boxAndPeopleExperiments();

} // namespace dewpoint::experiment
