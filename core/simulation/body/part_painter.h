// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/body/exposure.h"
#include "core/simulation/body/moving_part.h"
#include "core/simulation/room/room_view.h"

#include <opencv2/core.hpp>

#include <functional>
#include <vector>

namespace dewpoint::simulation {

/// Surface point as seen by a camera. World frame, meters.
struct SurfacePoint {
  Vector3f point;
  Vector3f normal;    ///< unit vector, outward
  Vector3f direction; ///< unit vector, from the camera to the point
  Vector3f color;     ///< BGR in full light, [0, 255]
  Gloss gloss;
};

/// Function that returns the light from a surface point to the camera: BGR, [0, 255].
using Shading = std::function<Vector3f(const SurfacePoint&)>;

/// Function that returns the parts of one body at a time (seconds). World frame, meters. The number
/// and order of the parts must not depend on the time.
using PartsAt = std::function<std::vector<MovingPart>(double)>;

/// Draws the parts of one body with motion blur into the area `within` of `image` (CV_32FC3), which
/// shows the scene behind the body. Nearer parts hide farther parts, and nearer objects at rest in
/// the room hide the parts. The edges of parts and the borders between colors are anti-aliased.
void paintParts(const RoomView& view, const PartsAt& partsAt, const Exposure& exposure,
                const cv::Rect& within, const Shading& shading, cv::Mat& image);

} // namespace dewpoint::simulation
