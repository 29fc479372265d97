// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

namespace dewpoint::simulation {

/// Returns three cameras at the desk: the two cameras of demoRig(), and a third one, to the side
/// and above, that looks at the same point.
CameraRig threeCameraDeskRig();

/// Returns the first `count` (2 to 8) of eight 320x240 cameras around the desk, 1.1 m from the
/// center of the volume (0.5, 0.5, 0.15). The cameras are ordered so that consecutive cameras are
/// far apart.
CameraRig deskRingRig(int count);

/// Returns the first `count` (2 to 4) of four 640x480 cameras in the corners of the hall (the
/// simulated living room). The cameras are 1.9 m above the floor, look at the center of the hall,
/// and have focal lengths of 400 px.
CameraRig hallRig(int count);

} // namespace dewpoint::simulation
