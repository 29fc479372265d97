// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/room/office_room.h"

#include <array>
#include <cstddef>

namespace dewpoint::simulation {

void furnishOffice(Furniture& room) {
  const Material oak{Pattern::Wood, rgb(186, 138, 88)};
  const Material gray{Pattern::Plaster, rgb(148, 152, 158)};
  const Material dark{Pattern::Plain, rgb(44, 46, 52)};
  const Material white{Pattern::Plaster, rgb(214, 212, 206)};
  // Two desks with screens, which hide legs; a partition that hides nearly a whole person.
  for (const float side : {-1.0F, 1.0F}) {
    const float x = side * 2.35F;
    const float y = side * 0.9F;
    room.add(Shape::Box, {x, y, 0.72F}, {0.42F, 0.85F, 0.02F}, oak);
    room.add(Shape::Box, {x, y - 0.8F, 0.35F}, {0.40F, 0.03F, 0.35F}, gray);
    room.add(Shape::Box, {x, y + 0.8F, 0.35F}, {0.40F, 0.03F, 0.35F}, gray);
    room.add(Shape::Box, {x + 0.1F * side, y - 0.25F, 1.02F}, {0.03F, 0.30F, 0.19F}, dark);
    room.add(Shape::Box, {x + 0.1F * side, y + 0.45F, 1.02F}, {0.03F, 0.30F, 0.19F}, dark);
  }
  room.add(Shape::Box, {-2.0F, -1.75F, 0.65F}, {0.70F, 0.03F, 0.65F},
           {Pattern::Plaster, rgb(112, 132, 150)}, 0.5F);
  // Along the walls: cupboards, shelves, a sofa, a board, doors, plants.
  room.add(Shape::Box, {1.3F, 3.2F, 0.95F}, {0.8F, 0.25F, 0.95F}, white);
  room.add(Shape::Box, {-1.2F, -3.25F, 0.55F}, {0.9F, 0.2F, 0.55F}, oak);
  room.add(Shape::Box, {-1.2F, 3.2F, 0.22F}, {0.85F, 0.28F, 0.22F},
           {Pattern::Plaster, rgb(74, 98, 128)});
  room.add(Shape::Box, {1.6F, -3.48F, 1.5F}, {1.0F, 0.015F, 0.5F}, white);
  room.add(Shape::Box, {3.48F, -1.2F, 1.0F}, {0.012F, 0.45F, 1.0F},
           {Pattern::Wood, rgb(168, 128, 84)});
  room.add(Shape::Box, {-3.48F, 2.4F, 1.5F}, {0.012F, 0.4F, 0.5F},
           {Pattern::Plain, rgb(92, 132, 164)});
  room.add(Shape::Cylinder, {2.75F, -2.6F, 0.2F}, {0.2F, 0.2F, 0.2F},
           {Pattern::Plain, rgb(120, 92, 70)});
  room.add(Shape::Ellipsoid, {2.75F, -2.6F, 0.85F}, {0.3F, 0.3F, 0.5F},
           {Pattern::Plaster, rgb(66, 104, 62)});
  room.add(Shape::Box, {0.0F, 0.0F, 0.003F}, {1.5F, 1.1F, 0.003F},
           {Pattern::Plaster, rgb(132, 120, 104)}, 0.15F);
  const std::array<Vector3f, 4> spines{rgb(44, 82, 140), rgb(186, 152, 60), rgb(60, 112, 74),
                                       rgb(150, 84, 44)};
  float x = -1.95F;
  for (std::size_t i = 0; i < 3 * spines.size(); ++i) {
    const float thick = 0.03F + 0.008F * static_cast<float>((i * 7) % 4);
    const float tall = 0.12F + 0.015F * static_cast<float>((i * 5) % 4);
    room.add(Shape::Box, {x + thick, -3.25F, 1.1F + tall}, {thick - 0.002F, 0.13F, tall},
             {Pattern::Plain, spines[i % spines.size()]});
    x += 2.0F * thick;
  }
}

} // namespace dewpoint::simulation
