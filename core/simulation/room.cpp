// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/room.h"

#include "core/simulation/texture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dewpoint::simulation {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNear = 1e-4F;
constexpr float kAmbient = 0.30F;

Vector3f toSolid(const Solid& solid, const Vector3f& v) {
  return {solid.cosine * v.x() + solid.sine * v.y(), -solid.sine * v.x() + solid.cosine * v.y(),
          v.z()};
}

Vector3f toWorld(const Solid& solid, const Vector3f& v) {
  return {solid.cosine * v.x() - solid.sine * v.y(), solid.sine * v.x() + solid.cosine * v.y(),
          v.z()};
}

/// Slab test; the entry, or the exit when the origin is inside (`inside`: the room's own walls).
void castBox(const Vector3f& o, const Vector3f& d, const Vector3f& half, bool inside, Hit& hit) {
  float enter = -kInfinity;
  float leave = kInfinity;
  int enterAxis = 0;
  int leaveAxis = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const float slope = std::abs(d[axis]) < 1e-9F ? 1e-9F : d[axis];
    const float side = std::copysign(half[axis], slope);
    const float t0 = (-side - o[axis]) / slope;
    const float t1 = (side - o[axis]) / slope;
    if (t0 > enter) {
      enter = t0;
      enterAxis = axis;
    }
    if (t1 < leave) {
      leave = t1;
      leaveAxis = axis;
    }
  }
  const float t = inside ? leave : enter;
  const int axis = inside ? leaveAxis : enterAxis;
  if (enter <= leave && t > kNear && t < hit.distance) {
    hit.distance = t;
    hit.normal = Vector3f::Zero();
    hit.normal[axis] = d[axis] > 0.0F ? -1.0F : 1.0F;
  }
}

void castEllipsoid(const Vector3f& o, const Vector3f& d, const Vector3f& half, Hit& hit) {
  const Vector3f p = o.cwiseQuotient(half);
  const Vector3f q = d.cwiseQuotient(half);
  const float a = q.squaredNorm();
  const float b = p.dot(q);
  const float root = b * b - a * (p.squaredNorm() - 1.0F);
  if (root < 0.0F) {
    return;
  }
  const float t = (-b - std::sqrt(root)) / a;
  if (t > kNear && t < hit.distance) {
    hit.distance = t;
    hit.normal = (o + t * d).cwiseQuotient(half.cwiseProduct(half)).normalized();
  }
}

void castCylinder(const Vector3f& o, const Vector3f& d, const Vector3f& half, Hit& hit) {
  const float radius = half.x();
  const float a = d.head<2>().squaredNorm();
  const float b = o.head<2>().dot(d.head<2>());
  const float root = b * b - a * (o.head<2>().squaredNorm() - radius * radius);
  if (a > 1e-12F && root >= 0.0F) {
    const float t = (-b - std::sqrt(root)) / a;
    if (t > kNear && t < hit.distance && std::abs(o.z() + t * d.z()) <= half.z()) {
      hit.distance = t;
      hit.normal = {(o.x() + t * d.x()) / radius, (o.y() + t * d.y()) / radius, 0.0F};
    }
  }
  if (d.z() < -1e-9F) {
    const float t = (half.z() - o.z()) / d.z();
    if (t > kNear && t < hit.distance && (o + t * d).head<2>().norm() <= radius) {
      hit.distance = t;
      hit.normal = Vector3f::UnitZ();
    }
  }
}

void castSolid(const Solid& solid, const Vector3f& origin, const Vector3f& direction, Hit& hit) {
  const Vector3f relative = origin - solid.center;
  const float along = relative.dot(direction);
  if (relative.squaredNorm() - along * along > solid.bound * solid.bound) {
    return;
  }
  const Vector3f o = toSolid(solid, relative);
  const Vector3f d = toSolid(solid, direction);
  const float before = hit.distance;
  switch (solid.shape) {
  case Shape::Box:
    castBox(o, d, solid.halfSize, false, hit);
    break;
  case Shape::Ellipsoid:
    castEllipsoid(o, d, solid.halfSize, hit);
    break;
  case Shape::Cylinder:
    castCylinder(o, d, solid.halfSize, hit);
    break;
  }
  if (hit.distance < before) {
    hit.normal = toWorld(solid, hit.normal);
    hit.solid = &solid;
  }
}

Solid solidOf(Shape shape, const Vector3f& center, const Vector3f& halfSize,
              const Material& material, float yaw) {
  return {shape, center, halfSize, yaw, material, std::cos(yaw), std::sin(yaw), halfSize.norm()};
}

} // namespace

float shade(const Vector3f& point, const Vector3f& normal, float lit, const Vector3f& lamp) {
  const float lambert = std::max(0.0F, normal.dot((lamp - point).normalized()));
  return kAmbient + (1.0F - kAmbient - kLampShare) * (1.0F + normal.z()) * 0.5F +
         kLampShare * lambert * lit;
}

Room::Room(Furnishing furnishing) {
  const Material plaster{Pattern::Plaster, rgb(226, 219, 203)};
  if (furnishing == Furnishing::Hall) {
    walls_ = solidOf(Shape::Box, {0.0F, 0.0F, 1.25F}, {2.25F, 2.25F, 1.25F}, plaster, 0.0F);
    furnishHall();
    return;
  }
  if (furnishing == Furnishing::Office) {
    walls_ = solidOf(Shape::Box, {0.0F, 0.0F, 1.35F}, {3.5F, 3.5F, 1.35F}, plaster, 0.0F);
    lamp_ = kOfficeLampPosition;
    furnishOffice();
    return;
  }
  walls_ = solidOf(Shape::Box, {0.4F, 0.4F, 0.65F}, {1.9F, 1.9F, 1.4F}, plaster, 0.0F);
  furnish();
  if (furnishing == Furnishing::ClutteredDesk) {
    clutterDesk();
  }
}

void Room::add(Shape shape, const Vector3f& center, const Vector3f& halfSize,
               const Material& material, float yaw) {
  solids_.push_back(solidOf(shape, center, halfSize, material, yaw));
}

void Room::furnish() {
  // The desk's top is the world's z = 0.
  add(Shape::Box, {0.47F, 0.47F, -0.02F}, {0.78F, 0.78F, 0.02F},
      {Pattern::Wood, rgb(196, 148, 98)});
  // Pictures on the two walls that the demo's cameras face: frame, sheet, motif.
  add(Shape::Box, {0.95F, 2.29F, 0.62F}, {0.36F, 0.012F, 0.27F}, {Pattern::Wood, rgb(104, 72, 46)});
  add(Shape::Box, {0.95F, 2.275F, 0.62F}, {0.32F, 0.01F, 0.23F},
      {Pattern::Plain, rgb(92, 132, 164)});
  add(Shape::Ellipsoid, {1.0F, 2.268F, 0.5F}, {0.2F, 0.01F, 0.09F},
      {Pattern::Plain, rgb(72, 116, 84)});
  add(Shape::Box, {2.29F, 0.05F, 0.5F}, {0.012F, 0.3F, 0.36F}, {Pattern::Wood, rgb(120, 84, 52)});
  add(Shape::Box, {2.275F, 0.05F, 0.5F}, {0.01F, 0.26F, 0.32F},
      {Pattern::Plain, rgb(214, 206, 178)});
  add(Shape::Box, {2.29F, 1.15F, 0.45F}, {0.02F, 0.42F, 0.03F}, {Pattern::Wood, rgb(168, 120, 74)});
}

void Room::addBook(const Vector3f& center, const Vector3f& halfSize, const Vector3f& color,
                   float yaw) {
  add(Shape::Box, center, halfSize, {Pattern::Plain, color}, yaw);
  // Its pages: a slightly smaller block that sticks out of the cover on one side.
  const Solid turn = solidOf(Shape::Box, center, halfSize, {}, yaw);
  const Vector3f inset{0.004F, halfSize.y(), halfSize.z() - 0.003F};
  add(Shape::Box, center + toWorld(turn, {halfSize.x() - 0.002F, 0.0F, 0.0F}),
      {inset.x(), inset.y() - 0.004F, inset.z()}, {Pattern::Pages, rgb(232, 224, 200)}, yaw);
}

void Room::clutterDesk() {
  // What camera 1 has behind the ball: a row of books, a wooden box, a head and a hand.
  const std::array<Vector3f, 6> spines{rgb(44, 82, 140), rgb(186, 152, 60), rgb(60, 112, 74),
                                       rgb(150, 84, 44), rgb(52, 54, 66),   rgb(88, 140, 150)};
  float x = 0.52F;
  for (std::size_t i = 0; i < spines.size(); ++i) {
    const float thick = 0.013F + 0.004F * static_cast<float>((i * 7) % 4);
    const float tall = 0.085F + 0.008F * static_cast<float>((i * 5) % 4);
    add(Shape::Box, {x + thick, 1.08F, tall}, {thick - 0.0008F, 0.07F, tall},
        {Pattern::Plain, spines[i]});
    x += 2.0F * thick;
  }
  add(Shape::Box, {0.84F, 0.98F, 0.06F}, {0.09F, 0.07F, 0.06F}, {Pattern::Wood, rgb(176, 118, 66)},
      0.35F);
  add(Shape::Ellipsoid, {0.16F, 1.05F, 0.14F}, {0.075F, 0.085F, 0.11F},
      {Pattern::Skin, rgb(226, 172, 138)});
  add(Shape::Cylinder, {0.16F, 1.06F, 0.03F}, {0.04F, 0.04F, 0.03F},
      {Pattern::Skin, rgb(216, 162, 128)});
  addBook({0.30F, 0.90F, 0.014F}, {0.075F, 0.055F, 0.014F}, rgb(58, 96, 150), 0.2F);
  addBook({0.305F, 0.90F, 0.039F}, {0.065F, 0.05F, 0.011F}, rgb(196, 166, 84), -0.15F);
  addBook({0.30F, 0.90F, 0.059F}, {0.06F, 0.045F, 0.009F}, rgb(70, 122, 92), 0.45F);
  const Material skin{Pattern::Skin, rgb(222, 168, 134)};
  add(Shape::Ellipsoid, {0.435F, 0.93F, 0.022F}, {0.038F, 0.045F, 0.017F}, skin, 0.3F);
  for (int finger = 0; finger < 4; ++finger) {
    const float side = static_cast<float>(finger) * 0.018F;
    add(Shape::Ellipsoid, {0.424F + side, 0.872F + 0.3F * side, 0.013F}, {0.008F, 0.038F, 0.009F},
        skin, 0.25F - 0.08F * static_cast<float>(finger));
  }
  // What camera 2 has behind the ball: a mug, blocks, an orange, a cork-brown tin and an arm.
  add(Shape::Cylinder, {1.0F, 0.66F, 0.05F}, {0.041F, 0.041F, 0.05F},
      {Pattern::Plain, rgb(62, 128, 132)});
  add(Shape::Box, {1.02F, 0.50F, 0.035F}, {0.045F, 0.06F, 0.035F},
      {Pattern::Wood, rgb(206, 160, 108)}, 0.5F);
  add(Shape::Box, {1.02F, 0.50F, 0.10F}, {0.035F, 0.035F, 0.03F}, {Pattern::Wood, rgb(150, 98, 56)},
      0.15F);
  add(Shape::Ellipsoid, {0.90F, 0.55F, 0.034F}, {0.036F, 0.036F, 0.034F},
      {Pattern::Plain, rgb(228, 138, 42)});
  add(Shape::Cylinder, {1.1F, 0.34F, 0.065F}, {0.045F, 0.045F, 0.065F},
      {Pattern::Plain, rgb(120, 92, 70)});
  add(Shape::Ellipsoid, {0.98F, 0.30F, 0.03F}, {0.06F, 0.10F, 0.03F}, skin, 0.9F);
  addBook({1.12F, 0.80F, 0.09F}, {0.05F, 0.012F, 0.09F}, rgb(46, 76, 128), 1.3F);
  // Small things on the desk before the ball: a pencil, a ruler and a sheet of paper.
  add(Shape::Box, {0.40F, 0.62F, 0.004F}, {0.004F, 0.08F, 0.004F},
      {Pattern::Plain, rgb(222, 178, 40)}, 0.9F);
  add(Shape::Box, {0.66F, 0.78F, 0.0015F}, {0.11F, 0.015F, 0.0015F},
      {Pattern::Plain, rgb(140, 168, 176)}, -0.4F);
  add(Shape::Box, {0.50F, 0.70F, 0.0005F}, {0.074F, 0.105F, 0.0005F},
      {Pattern::Plain, rgb(236, 234, 226)}, 0.2F);
}

Hit Room::cast(const Vector3f& origin, const Vector3f& direction) const {
  Hit hit;
  castBox(origin - walls_.center, direction, walls_.halfSize, true, hit);
  hit.solid = &walls_;
  for (const Solid& solid : solids_) {
    castSolid(solid, origin, direction, hit);
  }
  return hit;
}

bool Room::shadowed(const Vector3f& point, const Vector3f& towards) const {
  const Vector3f way = towards - point;
  const float distance = way.norm();
  Hit hit;
  hit.distance = distance;
  for (const Solid& solid : solids_) {
    castSolid(solid, point, way / distance, hit);
    if (hit.distance < distance) {
      return true;
    }
  }
  return false;
}

Sight Room::look(const Vector3f& origin, const Vector3f& direction, const Hit& hit,
                 std::uint32_t jitter) const {
  if (!(hit.distance < kInfinity)) {
    return {};
  }
  constexpr int kRays = 2;
  const Vector3f point = origin + hit.distance * direction;
  const Vector3f start = point + 1e-3F * hit.normal;
  float lit = 0.0F;
  for (std::uint32_t ray = 0; ray < kRays; ++ray) {
    const std::uint32_t word = hashed(jitter * kRays + ray, 17, 0);
    const Vector3f offset{static_cast<float>(word & 0x3FFU) / 511.5F - 1.0F,
                          static_cast<float>((word >> 10U) & 0x3FFU) / 511.5F - 1.0F, 0.0F};
    lit += shadowed(start, lamp_ + kLampRadius * offset) ? 0.0F : 1.0F / kRays;
  }
  const bool isWall = hit.solid == &walls_;
  const Pattern pattern =
      isWall && hit.normal.z() > 0.5F ? Pattern::Floor : hit.solid->material.pattern;
  const Vector3f place = isWall ? point : toSolid(*hit.solid, point - hit.solid->center);
  const Vector3f color = texture(pattern, hit.solid->material.color, place);
  const float light = shade(point, hit.normal, lit, lamp_);
  const float dark = shade(point, hit.normal, 0.0F, lamp_);
  return {(light * color).cwiseMin(255.0F), 1.0F - dark / light};
}

} // namespace dewpoint::simulation
