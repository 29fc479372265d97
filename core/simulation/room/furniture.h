// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/surface/solid.h"

#include <vector>

namespace dewpoint::simulation {

/// The solids that a room is furnished with, in the order in which they were put there.
class Furniture {
public:
  /// Sizes and positions in meters, world frame; `yaw` in radians about Z.
  void add(Shape shape, const Vector3f& center, const Vector3f& halfSize, const Material& material,
           float yaw = 0.0F);
  /// A book that lies or stands: its cover and its pages.
  void addBook(const Vector3f& center, const Vector3f& halfSize, const Vector3f& color, float yaw);

  const std::vector<Solid>& solids() const { return solids_; }

private:
  std::vector<Solid> solids_;
};

} // namespace dewpoint::simulation
