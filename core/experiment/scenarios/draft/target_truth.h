// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/scenario.h"
#include "core/simulation/scene/stage.h"

namespace dewpoint::experiment::scenarios {

/// Where a target is and how large it is at one time.
struct TargetTruth {
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< world, meters
  TargetExtent extent;
};

/// Of a body of parts of which some are marked as target: the centroid and the extent of the space
/// that those fill together, hidden or not. Of any other body: its path and its radius.
TargetTruth targetTruth(const simulation::StageBody& body, double time);

} // namespace dewpoint::experiment::scenarios
