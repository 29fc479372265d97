// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/experiment/report/experiment_options.h"

#include <vector>

namespace dewpoint::experiment {

/// Returns the fraction of particles that stay in a cone after one step, as sketched in figure 5 of
/// Barrera et al. 2005; one value per step length. The particles start spread evenly over the
/// cross-section of the cone at `depth` meters from its apex (radius `slope` times the depth). A
/// step moves a particle along the axis, away from the apex, by one of the lengths `steps`
/// (meters), and sideways by N(0, motionSigma) meters. Random numbers use a fixed seed.
std::vector<double> fractionStayingInCone(double slope, double depth, double motionSigma,
                                          const std::vector<double>& steps);

// Functions that reproduce figures of Barrera et al. 2005, section III-B, on the simulated demo.
// They are used as FigureExperiment::run.
Status writeBarreraFigure5(const ExperimentOptions& options);
Status writeBarreraDrift(const ExperimentOptions& options);
Status writeBarreraStarts(const ExperimentOptions& options);

} // namespace dewpoint::experiment
