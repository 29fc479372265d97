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

/// Returns the true position and size of a body at a time (seconds). If parts of the body are
/// marked as target, these are the centroid and extent of the space that these parts fill together,
/// whether they are hidden or not. Otherwise, they follow from the path and radius of the body.
TargetTruth targetTruth(const simulation::StageBody& body, double time);

} // namespace dewpoint::experiment::scenarios
