// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/experiment/report/experiment_options.h"

namespace dewpoint::experiment {

// Functions that reproduce figures of Barrera et al. 2005, section III-C. They are used as
// FigureExperiment::run.
Status writeDynamicsFigure6(const ExperimentOptions& options);
Status writeDynamicsFigure7(const ExperimentOptions& options);
Status writeDynamicsFigure8(const ExperimentOptions& options);

} // namespace dewpoint::experiment
