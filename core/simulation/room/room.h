// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/room/furniture.h"
#include "core/simulation/surface/solid.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace dewpoint::simulation {

// Room sizes in meters, chosen by judgment.

/// Half the side length, in meters, of the living room, which is centered on the origin.
inline constexpr float kHallHalfSize = 2.25F;
/// Half the side length, in meters, of the office, which is centered on the origin.
inline constexpr float kOfficeHalfSize = 3.5F;
/// Half the side length, in meters, of the room with the desk.
inline constexpr float kDeskRoomHalfSize = 1.9F;
/// World x, and also world y, of the center of the room with the desk, in meters.
inline constexpr float kDeskRoomCenter = 0.4F;
/// Height of the desk top (world z = 0) above the floor, meters. Usual desks are 0.72 to 0.76 m
/// high.
inline constexpr float kDeskHeight = 0.75F;

// Light. The values are chosen so that shadows are distinct but not black.

/// Position of the room lamp in all rooms except the office, world frame, meters. This is the only
/// lamp unless an Illumination adds other lamps. The lamp is a small area light, so that shadows
/// have soft borders.
inline const Vector3f kLampPosition{0.15F, -0.25F, 1.7F};
/// Position of the room lamp in the office, above people's heads. World frame, meters.
inline const Vector3f kOfficeLampPosition{0.2F, -0.3F, 2.6F};
/// Radius of the lamp in meters: about the size of a table lamp's shade.
inline constexpr float kLampRadius = 0.12F;
/// Fraction of full light that comes from the lamp; the rest is ambient.
inline constexpr float kLampFraction = 0.62F;

/// Returns the light on a matte surface at `point` (world, meters) with unit normal `normal`, where
/// 1 is full light. The light is the sum of ambient light, which is brighter from above, and the
/// Lambertian light of a lamp at `lamp`. The light of the lamp is multiplied by `lit`, which ranges
/// from 0 (in shadow) to 1.
float matteSurfaceLight(const Vector3f& point, const Vector3f& normal, float lit,
                        const Vector3f& lamp = kLampPosition);

/// First intersection of a ray with the room. `distance` (meters) is measured along the ray, and is
/// infinite if there is no intersection.
struct RoomHit {
  float distance = std::numeric_limits<float>::infinity();
  Vector3f normal{0.0F, 0.0F, 1.0F};
  /// Object that the ray hits; the walls if the ray hits nothing else.
  const Solid* solid = nullptr;
};

/// Color of the room as a camera sees it at one point of its image.
struct ShadedColor {
  Vector3f color{0.0F, 0.0F, 0.0F}; ///< BGR, [0, 255]
  float lampFraction = 0.0F;        ///< fraction of the color that comes directly from the lamp
};

/// Type of furnishing in a room.
enum class Furnishing {
  Desk,          ///< a bare desk; its top is z = 0
  ClutteredDesk, ///< the desk with books, boxes, and wood- and skin-colored objects
  Hall,          ///< a living room of 4.5 x 4.5 x 2.5 m around the origin; its floor is z = 0
  Office,        ///< an office of 7 x 7 x 2.7 m around the origin; its floor is z = 0
};

/// Modifications of a furnished room.
struct RoomDesign {
  Furniture additionalFurniture; ///< furniture in addition to the furniture of the Furnishing
  std::optional<Material> wallMaterial; ///< material of the walls, if it differs from the default
  /// Lamp position, if it differs from the default; world frame, meters.
  std::optional<Vector3f> lampPosition;
};

/// Furnished room of the simulation, at rest. Textures are functions of the world position, so all
/// cameras see the same room.
class Room {
public:
  explicit Room(Furnishing furnishing, const RoomDesign& design = {});

  /// Returns the first intersection of a ray with the room; `direction` is a unit vector.
  RoomHit castRay(const Vector3f& origin, const Vector3f& direction) const;
  /// Returns the color of the room at the point `hit`, where a ray hits the room. Whether the point
  /// is in shadow is tested with a ray to one point on the lamp. Different values of `jitter`
  /// select different points on the lamp.
  ShadedColor shadedColorOf(const Vector3f& origin, const Vector3f& direction, const RoomHit& hit,
                            std::uint32_t jitter) const;
  /// Returns the lamp position (world frame, meters): RoomDesign::lampPosition if it is set,
  /// otherwise kOfficeLampPosition in the office and kLampPosition in other rooms.
  const Vector3f& lampPosition() const { return lamp_; }

private:
  bool isShadowed(const Vector3f& point, const Vector3f& towards) const;

  std::vector<Solid> solids_;
  Solid walls_;
  Vector3f lamp_ = kLampPosition;
};

} // namespace dewpoint::simulation
