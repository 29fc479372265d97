// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/room/hall.h"

#include <array>
#include <cstddef>

namespace dewpoint::simulation {

void furnishHall(Furniture& room) {
  // Along the walls, so that the middle stays free: shelf, sofa, cupboard, table, lamp stand.
  const Material oak{Pattern::Wood, rgb(186, 138, 88)};
  const Material walnut{Pattern::Wood, rgb(112, 78, 50)};
  const Material skin{Pattern::Skin, rgb(222, 168, 134)};
  room.add(Shape::Box, {-0.9F, 2.05F, 0.55F}, {0.65F, 0.18F, 0.55F}, walnut);
  const std::array<Vector3f, 6> spines{rgb(44, 82, 140), rgb(186, 152, 60), rgb(60, 112, 74),
                                       rgb(150, 84, 44), rgb(52, 54, 66),   rgb(88, 140, 150)};
  float x = -1.45F;
  for (std::size_t i = 0; i < 2 * spines.size(); ++i) {
    const float thick = 0.03F + 0.008F * static_cast<float>((i * 7) % 4);
    const float tall = 0.12F + 0.015F * static_cast<float>((i * 5) % 4);
    room.add(Shape::Box, {x + thick, 2.05F, 1.1F + tall}, {thick - 0.002F, 0.12F, tall},
             {Pattern::Plain, spines[i % spines.size()]});
    x += 2.0F * thick;
  }
  room.add(Shape::Box, {1.0F, 1.95F, 0.22F}, {0.85F, 0.30F, 0.22F},
           {Pattern::Plaster, rgb(74, 98, 128)});
  room.add(Shape::Box, {1.0F, 2.15F, 0.6F}, {0.85F, 0.09F, 0.25F},
           {Pattern::Plaster, rgb(66, 90, 120)});
  room.add(Shape::Box, {2.0F, -0.9F, 0.5F}, {0.22F, 0.55F, 0.5F}, oak);
  room.add(Shape::Cylinder, {2.0F, -0.7F, 1.12F}, {0.09F, 0.09F, 0.12F},
           {Pattern::Plain, rgb(62, 128, 132)});
  room.add(Shape::Ellipsoid, {2.0F, -1.1F, 1.09F}, {0.1F, 0.1F, 0.09F},
           {Pattern::Plain, rgb(228, 138, 42)});
  room.add(Shape::Box, {-1.95F, 0.6F, 0.68F}, {0.28F, 0.55F, 0.02F}, oak);
  for (const float y : {0.12F, 1.08F}) {
    room.add(Shape::Box, {-1.75F, y, 0.33F}, {0.03F, 0.03F, 0.33F}, oak);
  }
  room.add(Shape::Ellipsoid, {-1.95F, 0.75F, 0.82F}, {0.09F, 0.1F, 0.12F}, skin);
  room.add(Shape::Box, {-1.95F, 0.4F, 0.76F}, {0.12F, 0.1F, 0.06F},
           {Pattern::Plain, rgb(140, 168, 176)}, 0.4F);
  // A rug, pictures and a door: large things of other colors behind the target.
  room.add(Shape::Box, {0.1F, 0.2F, 0.004F}, {1.1F, 0.8F, 0.004F},
           {Pattern::Plaster, rgb(150, 138, 96)}, 0.2F);
  room.add(Shape::Box, {0.5F, 2.24F, 1.55F}, {0.45F, 0.012F, 0.32F}, walnut);
  room.add(Shape::Box, {0.5F, 2.225F, 1.55F}, {0.40F, 0.01F, 0.27F},
           {Pattern::Plain, rgb(92, 132, 164)});
  room.add(Shape::Box, {2.24F, 0.8F, 1.0F}, {0.012F, 0.42F, 1.0F},
           {Pattern::Wood, rgb(168, 128, 84)});
  room.add(Shape::Box, {-2.24F, -0.9F, 1.5F}, {0.012F, 0.35F, 0.45F}, oak);
  room.add(Shape::Box, {-2.225F, -0.9F, 1.5F}, {0.01F, 0.3F, 0.4F},
           {Pattern::Plain, rgb(214, 206, 178)});
  room.add(Shape::Cylinder, {-1.9F, -1.85F, 0.2F}, {0.16F, 0.16F, 0.2F},
           {Pattern::Plain, rgb(120, 92, 70)});
}

} // namespace dewpoint::simulation
