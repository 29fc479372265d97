// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/body/exposure.h"
#include "core/simulation/body/moving_part.h"
#include "core/simulation/room/illumination.h"
#include "core/simulation/room/room_view.h"

#include <opencv2/core.hpp>

#include <functional>
#include <vector>

namespace dewpoint::simulation {

/// Moving object at one time: a ball, a box of any orientation, or an object made of parts. World
/// frame, meters.
struct Body {
  bool isBox = false;
  Vector3f center;
  float radius = 0.0F;                 ///< radius of the ball, or of a sphere around the box
  Vector3f color;                      ///< color, BGR in full light, [0, 255]
  Vector3f halfSize{0.0F, 0.0F, 0.0F}; ///< half size of the box along its own axes
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity(); ///< axes of the box in the world, as rows
  bool isPresent = true;             ///< true if the body is in the scene at this time
  const LightField* light = nullptr; ///< light on the body; null: lit only by the room lamp
  /// Parts, if the object is made of parts; only the parts are then drawn. The number of parts must
  /// not depend on the time. The object casts the shadow of a ball around `center` that has the
  /// same volume as all parts together.
  std::vector<MovingPart> parts{};
};

/// Function that returns all bodies at a time (seconds). The number and order of the bodies must
/// not depend on the time.
using BodiesAt = std::function<std::vector<Body>(double)>;

/// Draws bodies with motion blur, and their soft shadows on z = 0, into `image` (CV_32FC3), which
/// shows the room at rest as seen by `view`. A body is drawn if it is present at the center of the
/// exposure.
void paintBodies(const RoomView& view, const BodiesAt& bodiesAt, const Exposure& exposure,
                 cv::Mat& image);

} // namespace dewpoint::simulation
