// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/room/furniture.h"
#include "core/simulation/surface/solid.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace dewpoint::simulation {

// Sizes of the rooms, chosen; meters.

/// Half the side length of the living room, which is centered on the origin.
inline constexpr float kHallHalf = 2.25F;
/// Half the side length of the office, centered on the origin.
inline constexpr float kOfficeHalf = 3.5F;
/// Half the side length of the room with the desk, and world x and y of its center.
inline constexpr float kDeskRoomHalf = 1.9F;
inline constexpr float kDeskRoomMiddle = 0.4F;
/// Height of the desk's top (world z = 0) above the floor, within the usual 0.72 to 0.76 m.
inline constexpr float kDeskHeight = 0.75F;

// Light, chosen so that shadows are distinct but not black.

/// Position of the only lamp: a small area light, so that shadows have soft borders. World frame,
/// meters.
inline const Vector3f kLampPosition{0.15F, -0.25F, 1.7F};
/// Position of the office lamp, above the heads.
inline const Vector3f kOfficeLampPosition{0.2F, -0.3F, 2.6F};
/// Radius of the lamp in meters: a shade as of a table lamp.
inline constexpr float kLampRadius = 0.12F;
inline constexpr float kLampShare = 0.62F; ///< share of full light; the rest is ambient

/// Returns the light on a matte surface with unit normal `normal`: ambient light, brighter from
/// above, plus the Lambertian light of the lamp times `lit` (0 in shadow to 1).
float shade(const Vector3f& point, const Vector3f& normal, float lit,
            const Vector3f& lamp = kLampPosition);

/// First intersection of a ray with the room. `distance` is along the unit direction; infinite if
/// there is none.
struct Hit {
  float distance = std::numeric_limits<float>::infinity();
  Vector3f normal{0.0F, 0.0F, 1.0F};
  const Solid* solid = nullptr; ///< the walls if the ray hits nothing else
};

/// Color of the room as a camera sees it at one point of its image.
struct Sight {
  Vector3f color{0.0F, 0.0F, 0.0F}; ///< BGR, [0, 255]
  float lit = 0.0F;                 ///< share of the color that comes directly from the lamp
};

/// Furniture of a room.
enum class Furnishing {
  Desk,          ///< a bare desk; its top is z = 0
  ClutteredDesk, ///< the desk with books, boxes, wood- and skin-colored objects
  Hall,          ///< a living room of 4.5 x 4.5 x 2.5 m around the origin; its floor is z = 0
  Office,        ///< an office of 7 x 7 x 2.7 m around the origin; its floor is z = 0
};

/// Differences of a room from its furnishing.
struct RoomDesign {
  Furniture further;             ///< additional furniture
  std::optional<Material> walls; ///< walls of another color
  std::optional<Vector3f> lamp;  ///< another position of the lamp, world frame, meters
};

/// The furnished room of the simulation, at rest. Its textures are functions of the world position,
/// so all cameras see the same room.
class Room {
public:
  explicit Room(Furnishing furnishing, const RoomDesign& design = {});

  /// Returns the first intersection of a ray with the room; `direction` is a unit vector.
  Hit cast(const Vector3f& origin, const Vector3f& direction) const;
  /// Returns the color of a hit; `jitter` varies the point on the lamp that is used for shadows.
  Sight sightOf(const Vector3f& origin, const Vector3f& direction, const Hit& hit,
                std::uint32_t jitter) const;
  /// Returns the position of its lamp: kLampPosition, or higher in a room for people.
  const Vector3f& lamp() const { return lamp_; }

private:
  bool shadowed(const Vector3f& point, const Vector3f& towards) const;

  std::vector<Solid> solids_;
  Solid walls_;
  Vector3f lamp_ = kLampPosition;
};

} // namespace dewpoint::simulation
