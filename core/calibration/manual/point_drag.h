// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/manual/camera_variation.h"
#include "core/geometry/camera.h"

#include <vector>

namespace dewpoint::calibration {

/// Motion of a camera while the user drags a world point through its image.
enum class DragMode {
  Turn, ///< the camera rotates and keeps its position
  Slide ///< the camera moves parallel to its image plane and keeps its orientation
};

/// Reason why a drag could not continue.
enum class DragLimit {
  None,
  OutOfSight, ///< a point would be behind the camera, or outside the range of its lens model
  /// The held points (which keep their pixels during the drag) do not determine the motion, because
  /// they lie on one ray or line with the dragged point.
  OneRay,
  OutOfReach, ///< no pose near the current one shows the points at these pixels
  Fixed ///< three points that keep their pixels fix the pose; only the focal length could change
};

/// Settings of a drag.
struct DragSettings {
  DragMode mode = DragMode::Turn;
  /// True if the focal length may change, together with the pose, while three points keep their
  /// pixels. If false, such a drag stops with DragLimit::Fixed.
  bool focalMayChange = false;
};

/// Result of a drag.
struct DragResult {
  Camera camera;                     ///< camera at the end of the drag
  DragLimit limit = DragLimit::None; ///< reason why the drag stopped early; None if it did not
  /// Distance at the end between the pixel of the dragged point and the requested pixel, in pixels.
  double distanceToRequestedPx = 0.0;
};

/// Maximum number of points that can be held during a drag, which means that they keep their
/// pixels.
inline constexpr int kMaxHeldPoints = 3;

/// Moves a camera so that `dragged.world` is seen at `dragged.pixel`, while the held points stay
/// within 1e-6 px of where the camera sees them now. (The pixels in `held` are not used.) What
/// changes depends on the number of held points:
/// - 0: the smallest rotation about the camera center; in slide mode, a motion parallel to the
///   image;
/// - 1: the camera rolls about the ray of the held point and moves along it; in slide mode, the
///   smallest change of pose that meets the conditions;
/// - 2: the pose that meets the conditions (three points allow finitely many poses; this is the one
///   reached from the current pose without a jump);
/// - 3: the focal length changes, and the dragged point comes as close as that allows.
///
/// `camera` is the camera at the start of the drag, so that dragging back to the start changes
/// nothing. The dragged point moves to its requested pixel in steps of a few pixels. If a step is
/// not possible, the last valid pose is returned with the reason. The "smallest change" has the
/// smallest sum of squares of its rotation (radians) and its displacement (in units of the mean
/// distance of the points).
DragResult dragPoint(const Camera& camera, const std::vector<ImageAnchor>& held,
                     const ImageAnchor& dragged, const DragSettings& settings);

} // namespace dewpoint::calibration
