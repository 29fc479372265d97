// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/experiment/report/experiment_options.h"

#include <vector>

namespace dewpoint::experiment {

/// Of particles evenly spread over the cross-section of a cone at `depth` meters from its apex
/// (radius `slope` times the depth), the share that is still in the cone after a step of that
/// length in meters along the axis, away from the apex, and of N(0, motionSigma) sideways; one per
/// step. What figure 5 of Barrera et al. 2005 sketches. Drawn from a fixed seed.
std::vector<double> shareThatStaysInCone(double slope, double depth, double motionSigma,
                                         const std::vector<double>& steps);

// Barrera et al. 2005, section III-B, on the simulated demo, as FigureExperiment::run.
Status barreraFigure5(const ExperimentOptions& options);
Status barreraDrift(const ExperimentOptions& options);
Status barreraStarts(const ExperimentOptions& options);

} // namespace dewpoint::experiment
