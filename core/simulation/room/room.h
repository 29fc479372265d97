// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/room/furniture.h"
#include "core/simulation/surface/solid.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace dewpoint::simulation {

// The rooms' sizes, chosen; meters.

/// Half the sides of the living room, which lies around the origin.
inline constexpr float kHallHalf = 2.25F;
/// Half the sides of the office, around the origin.
inline constexpr float kOfficeHalf = 3.5F;
/// Half the sides of the room with the desk, and world x and y of its center.
inline constexpr float kDeskRoomHalf = 1.9F;
inline constexpr float kDeskRoomMiddle = 0.4F;
/// Of the desk's top, world z = 0, above the floor; within 0.72 to 0.76 m, as desks usually are.
inline constexpr float kDeskHeight = 0.75F;

// Light, chosen so that shadows are plain but not black.

/// The one lamp: a small area light, so that shadows have soft borders. World frame, meters.
inline const Vector3f kLampPosition{0.15F, -0.25F, 1.7F};
/// That of the office, above the heads.
inline const Vector3f kOfficeLampPosition{0.2F, -0.3F, 2.6F};
/// Of the lamp, meters: a shade as of a table lamp.
inline constexpr float kLampRadius = 0.12F;
inline constexpr float kLampShare = 0.62F; ///< of full light; the rest comes from all around

/// Light on a matte surface with unit normal `normal`: ambient, brighter from above, and `lit`
/// (0 in shadow to 1) times Lambert's share of the lamp.
float shade(const Vector3f& point, const Vector3f& normal, float lit,
            const Vector3f& lamp = kLampPosition);

/// A ray's first hit. `distance` is along the unit direction; infinite when there is none.
struct Hit {
  float distance = std::numeric_limits<float>::infinity();
  Vector3f normal{0.0F, 0.0F, 1.0F};
  const Solid* solid = nullptr; ///< the walls' own when the ray hits nothing else
};

/// What a camera sees of the room at one point of its image.
struct Sight {
  Vector3f color{0.0F, 0.0F, 0.0F}; ///< BGR, [0, 255]
  float lit = 0.0F;                 ///< share of the color that comes from the lamp directly
};

/// What stands in the room.
enum class Furnishing {
  Desk,          ///< a bare desk; its top is z = 0
  ClutteredDesk, ///< the desk with books, boxes, wood- and skin-colored objects
  Hall,          ///< a living room of 4.5 x 4.5 x 2.5 m around the origin; its floor is z = 0
  Office,        ///< an office of 7 x 7 x 2.7 m around the origin; its floor is z = 0
};

/// What makes a room another one than its furnishing says.
struct RoomDesign {
  Furniture further;             ///< stands there as well
  std::optional<Material> walls; ///< of another color
  std::optional<Vector3f> lamp;  ///< that hangs elsewhere, world, meters
};

/// The furnished room of the simulation, at rest. Its textures are functions of the position in the
/// world, so that all cameras see the same room.
class Room {
public:
  explicit Room(Furnishing furnishing, const RoomDesign& design = {});

  Hit cast(const Vector3f& origin, const Vector3f& direction) const;
  /// The color of a hit; `jitter` varies the point on the lamp that shadows are cast from.
  Sight sightOf(const Vector3f& origin, const Vector3f& direction, const Hit& hit,
                std::uint32_t jitter) const;
  /// Where its lamp hangs: kLampPosition, or higher in a room for people.
  const Vector3f& lamp() const { return lamp_; }

private:
  bool shadowed(const Vector3f& point, const Vector3f& towards) const;

  std::vector<Solid> solids_;
  Solid walls_;
  Vector3f lamp_ = kLampPosition;
};

} // namespace dewpoint::simulation
