// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/body/exposure.h"
#include "core/simulation/body/moving_part.h"
#include "core/simulation/room/room_view.h"

#include <opencv2/core.hpp>

#include <functional>
#include <vector>

namespace dewpoint::simulation {

/// A point of a surface as a camera sees it. World frame, meters.
struct SurfacePoint {
  Vector3f point;
  Vector3f normal;    ///< unit vector, outwards
  Vector3f direction; ///< unit vector, from the camera to the point
  Vector3f color;     ///< BGR in full light, [0, 255]
  Gloss gloss;
};

/// The light that comes from a point of a surface to the camera: BGR, [0, 255].
using Shading = std::function<Vector3f(const SurfacePoint&)>;

/// The parts of one body at an instant, seconds: the same number in the same order at every
/// instant. World frame, meters.
using PartsAt = std::function<std::vector<MovingPart>(double)>;

/// Draws the parts of one body with their motion blur into `within` of `image` (CV_32FC3), which
/// shows what is behind the body. The parts hide each other point by point; what of the room at
/// rest is nearer hides them. Edges of parts and borders of colors are smoothed.
void paintParts(const RoomView& view, const PartsAt& partsAt, const Exposure& exposure,
                const cv::Rect& within, const Shading& shading, cv::Mat& image);

} // namespace dewpoint::simulation
