// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/scenario.h"
#include "core/simulation/scene/stage.h"

namespace dewpoint::experiment::scenarios {

/// Position and size of a target at one time.
struct TargetTruth {
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< world, meters
  TargetExtent extent;
};

/// Truth of a body. If some parts of the body are marked as target, it is the centroid and the
/// extent of the space that these fill together, hidden or not. Otherwise it is the body's path and
/// radius.
TargetTruth targetTruth(const simulation::StageBody& body, double time);

} // namespace dewpoint::experiment::scenarios
