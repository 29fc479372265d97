// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/surface/solid.h"

#include <vector>

namespace dewpoint::simulation {

/// Solids that furnish a room, in the order in which they were added.
class Furniture {
public:
  /// Adds a solid. Sizes and positions are in meters in the world frame. `yaw` is in radians about
  /// Z.
  void add(Shape shape, const Vector3f& center, const Vector3f& halfSize, const Material& material,
           float yaw = 0.0F);
  /// Adds a book, lying or standing, as two solids: the cover and the pages. Arguments are as for
  /// add().
  void addBook(const Vector3f& center, const Vector3f& halfSize, const Vector3f& color, float yaw);

  const std::vector<Solid>& solids() const { return solids_; }

private:
  std::vector<Solid> solids_;
};

} // namespace dewpoint::simulation
