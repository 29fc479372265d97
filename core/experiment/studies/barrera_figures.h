// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/experiment/report/experiment_options.h"

namespace dewpoint::experiment {

// Functions that reproduce figures of Barrera et al. 2005, section III-A, on the simulated demo.
// They are used as FigureExperiment::run.
Status writeBarreraFigure3(const ExperimentOptions& options);
Status writeBarreraFigure4(const ExperimentOptions& options);

} // namespace dewpoint::experiment
