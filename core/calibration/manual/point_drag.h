// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/manual/pose_change.h"
#include "core/geometry/camera.h"

#include <vector>

namespace dewpoint::calibration {

/// How a camera follows while a point of the world is dragged through its image.
enum class DragMode {
  Turn, ///< keeps its position and rotates
  Slide ///< keeps its orientation and moves sideways
};

/// Reason why a drag could not continue.
enum class DragLimit {
  None,
  OutOfSight, ///< a point would be behind the camera, or outside the range of its lens model
  OneRay,     ///< the held points are not sufficient: they lie on one ray or line with the dragged
              ///< point
  OutOfReach, ///< no pose near this one shows the points at these pixels
  Fixed       ///< three held points fix the pose: only the focal length could still change
};

/// Settings of a drag.
struct DragSettings {
  DragMode mode = DragMode::Turn;
  /// Whether the focal length changes and the pose follows when three points are held.
  bool focalMayChange = false;
};

/// Result of a drag.
struct Drag {
  Camera camera;                     ///< camera at the end of the drag
  DragLimit limit = DragLimit::None; ///< reason why the drag stopped early
  double miss = 0.0; ///< distance between the dragged point and its target pixel, in pixels
};

/// Maximum number of points that can be held during a drag.
inline constexpr int kMostHeld = 3;

/// Moves a camera so that `dragged.world` is seen at `dragged.pixel` while the held points stay at
/// their pixels (to 1e-6 px):
/// - none held: the smallest rotation about its center, or the sideways motion across the line of
///   sight;
/// - one held: it rolls about the ray of the held point and moves along it; in slide mode, the
///   smallest change of pose that meets the conditions;
/// - two held: the pose that meets the conditions (three points allow finitely many poses; this is
///   the one reached from the current pose without a jump);
/// - three held: the focal length changes, and the dragged point comes as near as that allows.
///
/// `camera` is the camera at the beginning of the drag, so that dragging back to the start changes
/// nothing. The path is followed in steps of a few pixels; if it ends early, the last valid pose is
/// returned with the reason. The "smallest change" is the smallest sum of squares of rotation
/// (radians) and displacement (in units of the points' mean distance).
Drag dragPoint(const Camera& camera, const std::vector<ImageAnchor>& held,
               const ImageAnchor& dragged, const DragSettings& settings);

} // namespace dewpoint::calibration
