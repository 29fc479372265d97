// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/room/desk.h"

#include <array>
#include <cstddef>

namespace dewpoint::simulation {

void furnishDesk(Furniture& room) {
  // The desk's top is the world's z = 0.
  room.add(Shape::Box, {0.47F, 0.47F, -0.02F}, {0.78F, 0.78F, 0.02F},
           {Pattern::Wood, rgb(196, 148, 98)});
  // Pictures on the two walls that the demo's cameras face: frame, sheet, motif.
  room.add(Shape::Box, {0.95F, 2.29F, 0.62F}, {0.36F, 0.012F, 0.27F},
           {Pattern::Wood, rgb(104, 72, 46)});
  room.add(Shape::Box, {0.95F, 2.275F, 0.62F}, {0.32F, 0.01F, 0.23F},
           {Pattern::Plain, rgb(92, 132, 164)});
  room.add(Shape::Ellipsoid, {1.0F, 2.268F, 0.5F}, {0.2F, 0.01F, 0.09F},
           {Pattern::Plain, rgb(72, 116, 84)});
  room.add(Shape::Box, {2.29F, 0.05F, 0.5F}, {0.012F, 0.3F, 0.36F},
           {Pattern::Wood, rgb(120, 84, 52)});
  room.add(Shape::Box, {2.275F, 0.05F, 0.5F}, {0.01F, 0.26F, 0.32F},
           {Pattern::Plain, rgb(214, 206, 178)});
  room.add(Shape::Box, {2.29F, 1.15F, 0.45F}, {0.02F, 0.42F, 0.03F},
           {Pattern::Wood, rgb(168, 120, 74)});
}

void clutterDesk(Furniture& room) {
  // What camera 1 has behind the ball: a row of books, a wooden box, a head and a hand.
  const std::array<Vector3f, 6> spines{rgb(44, 82, 140), rgb(186, 152, 60), rgb(60, 112, 74),
                                       rgb(150, 84, 44), rgb(52, 54, 66),   rgb(88, 140, 150)};
  float x = 0.52F;
  for (std::size_t i = 0; i < spines.size(); ++i) {
    const float thick = 0.013F + 0.004F * static_cast<float>((i * 7) % 4);
    const float tall = 0.085F + 0.008F * static_cast<float>((i * 5) % 4);
    room.add(Shape::Box, {x + thick, 1.08F, tall}, {thick - 0.0008F, 0.07F, tall},
             {Pattern::Plain, spines[i]});
    x += 2.0F * thick;
  }
  room.add(Shape::Box, {0.84F, 0.98F, 0.06F}, {0.09F, 0.07F, 0.06F},
           {Pattern::Wood, rgb(176, 118, 66)}, 0.35F);
  room.add(Shape::Ellipsoid, {0.16F, 1.05F, 0.14F}, {0.075F, 0.085F, 0.11F},
           {Pattern::Skin, rgb(226, 172, 138)});
  room.add(Shape::Cylinder, {0.16F, 1.06F, 0.03F}, {0.04F, 0.04F, 0.03F},
           {Pattern::Skin, rgb(216, 162, 128)});
  room.addBook({0.30F, 0.90F, 0.014F}, {0.075F, 0.055F, 0.014F}, rgb(58, 96, 150), 0.2F);
  room.addBook({0.305F, 0.90F, 0.039F}, {0.065F, 0.05F, 0.011F}, rgb(196, 166, 84), -0.15F);
  room.addBook({0.30F, 0.90F, 0.059F}, {0.06F, 0.045F, 0.009F}, rgb(70, 122, 92), 0.45F);
  const Material skin{Pattern::Skin, rgb(222, 168, 134)};
  room.add(Shape::Ellipsoid, {0.435F, 0.93F, 0.022F}, {0.038F, 0.045F, 0.017F}, skin, 0.3F);
  for (int finger = 0; finger < 4; ++finger) {
    const float side = static_cast<float>(finger) * 0.018F;
    room.add(Shape::Ellipsoid, {0.424F + side, 0.872F + 0.3F * side, 0.013F},
             {0.008F, 0.038F, 0.009F}, skin, 0.25F - 0.08F * static_cast<float>(finger));
  }
  // What camera 2 has behind the ball: a mug, blocks, an orange, a cork-brown tin and an arm.
  room.add(Shape::Cylinder, {1.0F, 0.66F, 0.05F}, {0.041F, 0.041F, 0.05F},
           {Pattern::Plain, rgb(62, 128, 132)});
  room.add(Shape::Box, {1.02F, 0.50F, 0.035F}, {0.045F, 0.06F, 0.035F},
           {Pattern::Wood, rgb(206, 160, 108)}, 0.5F);
  room.add(Shape::Box, {1.02F, 0.50F, 0.10F}, {0.035F, 0.035F, 0.03F},
           {Pattern::Wood, rgb(150, 98, 56)}, 0.15F);
  room.add(Shape::Ellipsoid, {0.90F, 0.55F, 0.034F}, {0.036F, 0.036F, 0.034F},
           {Pattern::Plain, rgb(228, 138, 42)});
  room.add(Shape::Cylinder, {1.1F, 0.34F, 0.065F}, {0.045F, 0.045F, 0.065F},
           {Pattern::Plain, rgb(120, 92, 70)});
  room.add(Shape::Ellipsoid, {0.98F, 0.30F, 0.03F}, {0.06F, 0.10F, 0.03F}, skin, 0.9F);
  room.addBook({1.12F, 0.80F, 0.09F}, {0.05F, 0.012F, 0.09F}, rgb(46, 76, 128), 1.3F);
  // Small things on the desk before the ball: a pencil, a ruler and a sheet of paper.
  room.add(Shape::Box, {0.40F, 0.62F, 0.004F}, {0.004F, 0.08F, 0.004F},
           {Pattern::Plain, rgb(222, 178, 40)}, 0.9F);
  room.add(Shape::Box, {0.66F, 0.78F, 0.0015F}, {0.11F, 0.015F, 0.0015F},
           {Pattern::Plain, rgb(140, 168, 176)}, -0.4F);
  room.add(Shape::Box, {0.50F, 0.70F, 0.0005F}, {0.074F, 0.105F, 0.0005F},
           {Pattern::Plain, rgb(236, 234, 226)}, 0.2F);
}

} // namespace dewpoint::simulation
