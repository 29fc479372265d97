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

/// A lamp in addition to the room's own. It casts no shadows.
struct FurtherLamp {
  Vector3f position{0.0F, 0.0F, 1.0F}; ///< world frame, meters
  /// BGR; 1 is full light on a surface perpendicular to its rays.
  Vector3f color{0.0F, 0.0F, 0.0F};
  /// Distance in meters up to which its light is `color`. Beyond it, the light decreases with the
  /// square of the distance, so near objects are lit more than the walls; closer to the lamp, the
  /// source is too broad for this law. Infinite: equal light everywhere, like that of the sun.
  float reach = std::numeric_limits<float>::infinity();

  /// Returns the share of `color` that remains at a distance in meters; 1 within its reach.
  float falloff(float distance) const;
};

/// Shadow of a tall object that passes in front of the room's lamp: a vertical band that darkens
/// walls, desk and bodies.
struct MovingShadow {
  /// Direction of motion: horizontal unit vector, world frame.
  Vector3f direction = Vector3f::UnitX();
  double start = 0.0;     ///< position of the band's center along `direction` at time 0, meters
  double speed = 0.2;     ///< m/s
  float halfWidth = 0.1F; ///< meters, to the center of its border
  float edge = 0.03F;     ///< half width of its soft border, meters; chosen
  float depth = 0.0F;     ///< share of the lamp's light that is blocked, 0 to 1
};

/// Returns the share of the room's lamp blocked by the shadow at a point of the world, 0 to
/// `depth`.
float shadowAt(const MovingShadow& shadow, const Vector3f& point, double time);

/// Light of a room, if it differs from that of its lamp alone.
struct Illumination {
  Vector3f lamp = kLampPosition; ///< the room's own lamp
  float roomGain = 1.0F;         ///< factor on the room's own light, ambient and lamp
  std::vector<FurtherLamp> further;
  std::optional<MovingShadow> shadow;

  /// Returns whether there is only the light of the lamp at its default position.
  bool plain() const {
    return lamp == kLampPosition && roomGain == 1.0F && further.empty() && !shadow;
  }
};

/// An illumination at one time, for moving objects.
struct LightField {
  const Illumination* illumination = nullptr;
  double time = 0.0;

  /// Returns the light (BGR, 1 is full) on a matte surface with unit normal `normal`.
  Vector3f at(const Vector3f& point, const Vector3f& normal) const;
};

/// Image of a camera at rest under an illumination, without its moving shadow.
struct RelitBackground {
  cv::Mat ambient; ///< CV_32FC3, BGR: everything except the direct light of the room's lamp
  cv::Mat direct;  ///< CV_32FC3, BGR: the direct light of the room's lamp
};

/// Returns the surface normal at a pixel, from the distances around it: unit vector, world frame,
/// toward the camera.
Vector3f surfaceNormal(const RoomView& view, int column, int row);

/// Computes the image of a camera at rest under an illumination.
RelitBackground relit(const RoomView& view, const Illumination& illumination);

/// Returns the image of the room at rest (CV_32FC3) at a time in seconds.
cv::Mat backgroundAt(const RoomView& view, const RelitBackground& background,
                     const Illumination& illumination, double time);

} // namespace dewpoint::simulation
