// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/room/room.h"
#include "core/simulation/room/room_view.h"

#include <opencv2/core.hpp>

#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace dewpoint::simulation {

/// Lamp in addition to the room lamp. It casts no shadows.
struct AdditionalLamp {
  Vector3f position{0.0F, 0.0F, 1.0F}; ///< world frame, meters
  /// Color, BGR. 1 is full light on a surface perpendicular to the rays.
  Vector3f color{0.0F, 0.0F, 0.0F};
  /// Distance in meters up to which the light is constant (`color`), because the lamp is broad.
  /// Beyond this distance, the light decreases with the square of the distance, so near objects get
  /// more light than the walls. If the distance is infinite, the light is equal everywhere, like
  /// sunlight.
  float reach = std::numeric_limits<float>::infinity();

  /// Returns the fraction of `color` that remains at a distance (meters) from the lamp. The
  /// fraction is 1 up to `reach`.
  float falloffAt(float distance) const;
};

/// Shadow of a tall object that passes in front of the room lamp: a vertical band that moves over
/// walls, desk and bodies and darkens them.
struct MovingShadow {
  /// Direction in which the band moves: horizontal unit vector, world frame.
  Vector3f direction = Vector3f::UnitX();
  double initialPosition =
      0.0;            ///< position of the band's center along `direction` at time 0, meters
  double speed = 0.2; ///< speed of the band along `direction`, m/s
  /// Half width of the band, measured to the center of its soft border, meters.
  float halfWidth = 0.1F;
  float borderHalfWidth = 0.03F; ///< half width of the soft border, meters; chosen by judgment
  float blockedFraction = 0.0F;  ///< fraction of the lamp's light that is blocked, 0 to 1
};

/// Returns the fraction of the room lamp's light that the shadow blocks at a point (world, meters)
/// and time (seconds), 0 to `blockedFraction`.
float blockedFractionAt(const MovingShadow& shadow, const Vector3f& point, double time);

/// Light of a room. The default is the light of the room lamp alone.
struct Illumination {
  Vector3f lampPosition = kLampPosition; ///< position of the room lamp, world frame, meters
  float roomGain = 1.0F; ///< factor by which the room's own light (ambient and lamp) is multiplied
  std::vector<AdditionalLamp> additionalLamps;
  std::optional<MovingShadow> shadow;

  /// Returns whether the only light is the room lamp at its default position.
  bool isDefault() const {
    return lampPosition == kLampPosition && roomGain == 1.0F && additionalLamps.empty() && !shadow;
  }
};

/// Illumination at one time (seconds), for moving objects.
struct LightField {
  const Illumination* illumination = nullptr;
  double time = 0.0;

  /// Returns the light (BGR, 1 is full light) on a matte surface at `point` (world, meters) with
  /// unit normal `normal`.
  Vector3f lightAt(const Vector3f& point, const Vector3f& normal) const;
};

/// Image of a room at rest under an illumination, without the moving shadow.
struct RelitBackground {
  cv::Mat ambientLight; ///< CV_32FC3, BGR: image without the direct light of the room lamp
  cv::Mat directLight;  ///< CV_32FC3, BGR: contribution of the direct light of the room lamp
};

/// Returns the surface normal at a pixel: unit vector, world frame, toward the camera. The normal
/// is computed from the distances at the pixel and its neighbors (RoomView::distances).
Vector3f surfaceNormal(const RoomView& view, int column, int row);

/// Returns the image of a room at rest under an illumination, without the moving shadow.
RelitBackground relightBackground(const RoomView& view, const Illumination& illumination);

/// Returns the image of the room at rest (CV_32FC3) at a time in seconds, with the moving shadow.
/// `background` must come from relightBackground() with the same illumination.
cv::Mat backgroundAt(const RoomView& view, const RelitBackground& background,
                     const Illumination& illumination, double time);

} // namespace dewpoint::simulation
