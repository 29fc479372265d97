// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

class BirdsEyeView;
class TrajectoryPanel;
struct Workbench;

/// Adds the dock with the trajectory of the run to the window. A range selected in the trajectory
/// is highlighted in the bird's-eye view. A click on a target's tail (its drawn recent path) in the
/// bird's-eye view selects this position in the trajectory.
TrajectoryPanel* installTrajectory(const Workbench& bench, BirdsEyeView& birdsEye);

} // namespace dewpoint::ui
