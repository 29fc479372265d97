// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/room/room_view.h"

#include <Eigen/Core>
#include <opencv2/core/types.hpp>

#include <algorithm>
#include <cstddef>

namespace dewpoint::simulation {

/// Ball that hides a round lamp from points on the floor or desk (world z = 0). Meters, world
/// frame.
struct ShadowCaster {
  Eigen::Vector3f center;
  float radius = 0.0F;
  Eigen::Vector3f lampPosition; ///< center of the lamp
  float lampRadius = 0.0F;
  /// Smallest half width of the shadow's soft edge; applies to a ball close to the floor.
  float minBlurHalfWidth = 0.0F;
  float maxFloorHeight = 0.0F; ///< only points up to this height (world z) count as floor
};

/// Calls `shade(row, column, pixel, covered, blur)` for each pixel of `area` that shows the floor
/// below the ball. `pixel` is view.pixelIndex(column, row). `covered` is the fraction of the lamp,
/// 0 to 1, that the ball hides from the floor at this pixel. The edge of the shadow is smooth, with
/// half width `blur` (meters).
template <class Shade>
void forEachShadedPixel(const RoomView& view, const cv::Rect& area, const ShadowCaster& caster,
                        const Shade& shade) {
  for (int row = area.y; row < area.y + area.height; ++row) {
    for (int column = area.x; column < area.x + area.width; ++column) {
      const std::size_t pixel = view.pixelIndex(column, row);
      const float distance = view.distances[pixel];
      if (!(distance < 100.0F)) {
        continue;
      }
      const Eigen::Vector3f point = view.center + distance * view.directions[pixel];
      const Eigen::Vector3f way = caster.lampPosition - point;
      const float length = way.norm();
      const float along = (caster.center - point).dot(way) / length;
      if (point.z() > caster.maxFloorHeight || along <= 0.0F) {
        continue;
      }
      const float aside = ((caster.center - point) - along / length * way).norm();
      const float blur = std::max(caster.minBlurHalfWidth, caster.lampRadius * along / length);
      const float t = std::clamp((aside - caster.radius + blur) / (2.0F * blur), 0.0F, 1.0F);
      shade(row, column, pixel, 1.0F - t * t * (3.0F - 2.0F * t), blur);
    }
  }
}

} // namespace dewpoint::simulation
