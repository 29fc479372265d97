// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/room/room.h"

#include "core/simulation/room/desk.h"
#include "core/simulation/room/furniture.h"
#include "core/simulation/room/hall.h"
#include "core/simulation/room/office_room.h"
#include "core/simulation/surface/texture.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::simulation {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
/// Meters: nearer hits are the surface itself; far above what rounding makes of 3 m.
constexpr float kNearestHit = 1e-4F;
/// Share of full light that comes from everywhere; chosen, see kLampFraction.
constexpr float kAmbient = 0.30F;

/// Slab test; the entry, or the exit when the origin is inside (`inside`: the room's own walls).
void castBox(const Vector3f& o, const Vector3f& d, const Vector3f& half, bool inside,
             RoomHit& hit) {
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
  if (enter <= leave && t > kNearestHit && t < hit.distance) {
    hit.distance = t;
    hit.normal = Vector3f::Zero();
    hit.normal[axis] = d[axis] > 0.0F ? -1.0F : 1.0F;
  }
}

void castEllipsoid(const Vector3f& o, const Vector3f& d, const Vector3f& half, RoomHit& hit) {
  const Vector3f p = o.cwiseQuotient(half);
  const Vector3f q = d.cwiseQuotient(half);
  const float a = q.squaredNorm();
  const float b = p.dot(q);
  const float root = b * b - a * (p.squaredNorm() - 1.0F);
  if (root < 0.0F) {
    return;
  }
  const float t = (-b - std::sqrt(root)) / a;
  if (t > kNearestHit && t < hit.distance) {
    hit.distance = t;
    hit.normal = (o + t * d).cwiseQuotient(half.cwiseProduct(half)).normalized();
  }
}

void castCylinder(const Vector3f& o, const Vector3f& d, const Vector3f& half, RoomHit& hit) {
  const float radius = half.x();
  const float a = d.head<2>().squaredNorm();
  const float b = o.head<2>().dot(d.head<2>());
  const float root = b * b - a * (o.head<2>().squaredNorm() - radius * radius);
  if (a > 1e-12F && root >= 0.0F) {
    const float t = (-b - std::sqrt(root)) / a;
    if (t > kNearestHit && t < hit.distance && std::abs(o.z() + t * d.z()) <= half.z()) {
      hit.distance = t;
      hit.normal = {(o.x() + t * d.x()) / radius, (o.y() + t * d.y()) / radius, 0.0F};
    }
  }
  if (d.z() < -1e-9F) {
    const float t = (half.z() - o.z()) / d.z();
    if (t > kNearestHit && t < hit.distance && (o + t * d).head<2>().norm() <= radius) {
      hit.distance = t;
      hit.normal = Vector3f::UnitZ();
    }
  }
}

void castSolid(const Solid& solid, const Vector3f& origin, const Vector3f& direction,
               RoomHit& hit) {
  const Vector3f relative = origin - solid.center;
  const float along = relative.dot(direction);
  if (relative.squaredNorm() - along * along > solid.boundingRadius * solid.boundingRadius) {
    return;
  }
  const Vector3f o = toSolidFrame(solid, relative);
  const Vector3f d = toSolidFrame(solid, direction);
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

} // namespace

float matteSurfaceLight(const Vector3f& point, const Vector3f& normal, float lit,
                        const Vector3f& lamp) {
  const float lambert = std::max(0.0F, normal.dot((lamp - point).normalized()));
  return kAmbient + (1.0F - kAmbient - kLampFraction) * (1.0F + normal.z()) * 0.5F +
         kLampFraction * lambert * lit;
}

Room::Room(Furnishing furnishing, const RoomDesign& design) {
  const Material plaster =
      design.wallMaterial.value_or(Material{Pattern::Plaster, rgb(226, 219, 203)});
  Furniture furniture;
  switch (furnishing) {
  case Furnishing::Hall:
    walls_ = makeSolid(Shape::Box, {0.0F, 0.0F, 1.25F}, {kHallHalfSize, kHallHalfSize, 1.25F},
                       plaster, 0.0F);
    furnishHall(furniture);
    break;
  case Furnishing::Office:
    walls_ = makeSolid(Shape::Box, {0.0F, 0.0F, 1.35F}, {kOfficeHalfSize, kOfficeHalfSize, 1.35F},
                       plaster, 0.0F);
    lamp_ = kOfficeLampPosition;
    furnishOffice(furniture);
    break;
  case Furnishing::Desk:
  case Furnishing::ClutteredDesk:
    walls_ = makeSolid(Shape::Box, {kDeskRoomCenter, kDeskRoomCenter, 1.4F - kDeskHeight},
                       {kDeskRoomHalfSize, kDeskRoomHalfSize, 1.4F}, plaster, 0.0F);
    furnishDesk(furniture);
    if (furnishing == Furnishing::ClutteredDesk) {
      clutterDesk(furniture);
    }
    break;
  }
  solids_ = furniture.solids();
  solids_.insert(solids_.end(), design.additionalFurniture.solids().begin(),
                 design.additionalFurniture.solids().end());
  lamp_ = design.lampPosition.value_or(lamp_);
}

RoomHit Room::castRay(const Vector3f& origin, const Vector3f& direction) const {
  RoomHit hit;
  castBox(origin - walls_.center, direction, walls_.halfSize, true, hit);
  hit.solid = &walls_;
  for (const Solid& solid : solids_) {
    castSolid(solid, origin, direction, hit);
  }
  return hit;
}

bool Room::isShadowed(const Vector3f& point, const Vector3f& towards) const {
  const Vector3f way = towards - point;
  const float distance = way.norm();
  RoomHit hit;
  hit.distance = distance;
  for (const Solid& solid : solids_) {
    castSolid(solid, point, way / distance, hit);
    if (hit.distance < distance) {
      return true;
    }
  }
  return false;
}

ShadedColor Room::shadedColorOf(const Vector3f& origin, const Vector3f& direction,
                                const RoomHit& hit, std::uint32_t jitter) const {
  if (!(hit.distance < kInfinity)) {
    return {};
  }
  constexpr int kRays = 2; // to the lamp, of each of a pixel's samples: soft borders of shadows
  const Vector3f point = origin + hit.distance * direction;
  const Vector3f start = point + 1e-3F * hit.normal;
  float lit = 0.0F;
  for (std::uint32_t ray = 0; ray < kRays; ++ray) {
    const std::uint32_t word = hashOfIntegers(jitter * kRays + ray, 17, 0);
    const Vector3f offset{static_cast<float>(word & 0x3FFU) / 511.5F - 1.0F,
                          static_cast<float>((word >> 10U) & 0x3FFU) / 511.5F - 1.0F, 0.0F};
    lit += isShadowed(start, lamp_ + kLampRadius * offset) ? 0.0F : 1.0F / kRays;
  }
  const bool isWall = hit.solid == &walls_;
  const Pattern pattern =
      isWall && hit.normal.z() > 0.5F ? Pattern::Floor : hit.solid->material.pattern;
  const Vector3f position = isWall ? point : toSolidFrame(*hit.solid, point - hit.solid->center);
  const Vector3f color = textureColor(pattern, hit.solid->material.color, position);
  const float light = matteSurfaceLight(point, hit.normal, lit, lamp_);
  const float dark = matteSurfaceLight(point, hit.normal, 0.0F, lamp_);
  return {(light * color).cwiseMin(255.0F), 1.0F - dark / light};
}

} // namespace dewpoint::simulation
