// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

class BirdsEyeView;
class TrajectoryPanel;
struct Workbench;

/// Adds the run's trajectory to the window. A range selected in it is highlighted in the bird's-eye
/// view. A click on a target's tail there (its drawn recent path) selects that position in the
/// trajectory.
TrajectoryPanel* installTrajectory(const Workbench& bench, BirdsEyeView& birdsEye);

} // namespace dewpoint::ui
