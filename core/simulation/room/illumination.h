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

/// A lamp besides the room's own. It casts no shadows.
struct FurtherLamp {
  Vector3f position{0.0F, 0.0F, 1.0F}; ///< world, meters
  Vector3f color{0.0F, 0.0F, 0.0F};    ///< BGR; 1 is full light on a surface square to its rays
  /// Distance up to which its light is `color`, meters: from there on it falls with the square of
  /// the distance, so that it lights what is near more than the walls; nearer it is too broad a
  /// source for that. Infinite: it lights everything as much, as the sun does.
  float reach = std::numeric_limits<float>::infinity();

  /// Share of `color` that is left at a distance, meters; 1 within its reach.
  float falloff(float distance) const;
};

/// The shadow of something tall that passes before the room's lamp: an upright band, which covers
/// walls, desk and bodies alike.
struct MovingShadow {
  Vector3f direction = Vector3f::UnitX(); ///< it moves along; unit vector, world, horizontal
  double start = 0.0;                     ///< of the band's center along `direction` at time 0, m
  double speed = 0.2;                     ///< m/s
  float halfWidth = 0.1F;                 ///< meters, to the center of its border
  float edge = 0.03F;                     ///< half width of its soft border, meters; chosen
  float depth = 0.0F;                     ///< share of the lamp that it takes, 0 to 1
};

/// Share of the room's lamp that the shadow takes at a point of the world, 0 to `depth`.
float shadowAt(const MovingShadow& shadow, const Vector3f& point, double time);

/// The light of a room, where it is not simply that of its lamp.
struct Illumination {
  Vector3f lamp = kLampPosition; ///< the room's own lamp
  float roomGain = 1.0F;         ///< of the room's own light, ambient and lamp
  std::vector<FurtherLamp> further;
  std::optional<MovingShadow> shadow;

  /// True where there is nothing but the light of the lamp where it usually hangs.
  bool plain() const {
    return lamp == kLampPosition && roomGain == 1.0F && further.empty() && !shadow;
  }
};

/// An illumination at one time, for what moves in it.
struct LightField {
  const Illumination* illumination = nullptr;
  double time = 0.0;

  /// Light (BGR, 1 is full) on a matte surface with unit normal `normal`.
  Vector3f at(const Vector3f& point, const Vector3f& normal) const;
};

/// What a camera sees at rest under an illumination, apart from its moving shadow.
struct RelitBackground {
  cv::Mat ambient; ///< CV_32FC3, BGR: everything but the direct light of the room's lamp
  cv::Mat direct;  ///< CV_32FC3: that light
};

/// Surface normal at a pixel, from the distances around it: unit vector, world, towards the camera.
Vector3f surfaceNormal(const RoomView& view, int column, int row);

RelitBackground relit(const RoomView& view, const Illumination& illumination);

/// The image of the room at rest (CV_32FC3) at a time.
cv::Mat backgroundAt(const RoomView& view, const RelitBackground& background,
                     const Illumination& illumination, double time);

} // namespace dewpoint::simulation
