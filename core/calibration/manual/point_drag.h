// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/manual/pose_change.h"
#include "core/geometry/camera.h"

#include <vector>

namespace dewpoint::calibration {

/// What a camera does while a point of the world is dragged through its image.
enum class DragMode {
  Turn, ///< it stays where it is and turns
  Slide ///< it keeps its direction and slides sideways
};

/// Why a drag went no further.
enum class DragLimit {
  None,
  OutOfSight, ///< a point would be behind the camera, or past where its lens model holds
  OneRay,     ///< the held points say too little: they lie on one ray or line with the dragged one
  OutOfReach, ///< no pose near this one shows the points there
  Fixed       ///< three points held fix the pose: only the focal length could still give way
};

struct DragSettings {
  DragMode mode = DragMode::Turn;
  /// With three points held, the focal length changes and the pose follows.
  bool focalMayChange = false;
};

struct Drag {
  Camera camera;                     ///< how far the drag came
  DragLimit limit = DragLimit::None; ///< what stopped it
  double miss = 0.0;                 ///< pixels between the dragged point and where it should be
};

/// Most points that can be held during a drag.
inline constexpr int kMostHeld = 3;

/// Moves a camera so that `dragged.world` comes to `dragged.pixel` while the held points stay at
/// their pixels (to 1e-6 px):
/// - none held: the smallest turn about its center, or the slide across the line of sight;
/// - one held: it rolls about the ray of the held point and moves along it; when sliding, the least
///   change of pose that does it;
/// - two held: the pose that does it (three points have finitely many, and this is the one reached
///   from the present pose without a jump);
/// - three held: the focal length changes, and the dragged point comes as near as that allows.
/// `camera` is as it was when the drag began, so that a drag back to its beginning changes nothing.
/// The way there is followed in steps of some pixels; where it ends, the last good pose is returned
/// with the reason. "Least change": sum of squares of turn (radians) and shift (in units of the
/// points' mean distance).
Drag dragPoint(const Camera& camera, const std::vector<ImageAnchor>& held,
               const ImageAnchor& dragged, const DragSettings& settings);

} // namespace dewpoint::calibration
