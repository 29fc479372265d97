// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/room/furniture.h"

namespace dewpoint::simulation {

void Furniture::add(Shape shape, const Vector3f& center, const Vector3f& halfSize,
                    const Material& material, float yaw) {
  solids_.push_back(makeSolid(shape, center, halfSize, material, yaw));
}

void Furniture::addBook(const Vector3f& center, const Vector3f& halfSize, const Vector3f& color,
                        float yaw) {
  add(Shape::Box, center, halfSize, {Pattern::Plain, color}, yaw);
  // Its pages: a slightly smaller block that sticks out of the cover on one side.
  const Solid turn = makeSolid(Shape::Box, center, halfSize, {}, yaw);
  const Vector3f inset{0.004F, halfSize.y(), halfSize.z() - 0.003F};
  add(Shape::Box, center + toWorld(turn, {halfSize.x() - 0.002F, 0.0F, 0.0F}),
      {inset.x(), inset.y() - 0.004F, inset.z()}, {Pattern::Pages, rgb(232, 224, 200)}, yaw);
}

} // namespace dewpoint::simulation
