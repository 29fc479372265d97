// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/body/moving_part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace dewpoint::simulation {
namespace {

/// Nearer hits are the ray's own surface, meters.
constexpr float kNear = 1e-4F;
/// Squared sine of the angle between a ray and an axis below which they count as parallel: about
/// the rounding of a float.
constexpr float kParallel = 1e-8F;

/// A ray in a part's own axes; it begins at its point nearest to the part's center, so that no
/// digits are lost to the distance of the camera.
struct OwnRay {
  Vector3f o;
  Vector3f d;
  Vector3f at(float t) const { return o + t * d; }
};

/// The nearest of the points at which a ray meets a surface.
class Nearest {
public:
  void offer(float distance, const Vector3f& normal) {
    if (!found_ || distance < found_->first) {
      found_.emplace(distance, normal);
    }
  }
  const std::optional<std::pair<float, Vector3f>>& found() const { return found_; }

private:
  std::optional<std::pair<float, Vector3f>> found_;
};

void meetEllipsoid(const OwnRay& ray, const Vector3f& size, Nearest& nearest) {
  const Vector3f p = ray.o.cwiseQuotient(size);
  const Vector3f q = ray.d.cwiseQuotient(size);
  const float a = q.squaredNorm();
  const float b = p.dot(q);
  const float root = b * b - a * (p.squaredNorm() - 1.0F);
  if (root >= 0.0F) {
    const float t = (-b - std::sqrt(root)) / a;
    nearest.offer(t, ray.at(t).cwiseQuotient(size.cwiseProduct(size)).normalized());
  }
}

void meetCapsule(const OwnRay& ray, float radius, float half, Nearest& nearest) {
  const float a = ray.d.head<2>().squaredNorm();
  const float b = ray.o.head<2>().dot(ray.d.head<2>());
  const float root = b * b - a * (ray.o.head<2>().squaredNorm() - radius * radius);
  if (a > kParallel && root >= 0.0F) {
    const float t = (-b - std::sqrt(root)) / a;
    const Vector3f point = ray.at(t);
    if (std::abs(point.z()) <= half) {
      nearest.offer(t, {point.x() / radius, point.y() / radius, 0.0F});
    }
  }
  for (const float end : {-half, half}) {
    const Vector3f way = ray.o - Vector3f{0.0F, 0.0F, end};
    const float along = way.dot(ray.d);
    const float inside = along * along - way.squaredNorm() + radius * radius;
    if (inside >= 0.0F) {
      const float t = -along - std::sqrt(inside);
      nearest.offer(t, (way + t * ray.d) / radius);
    }
  }
}

void meetFrustum(const OwnRay& ray, const Vector3f& size, Nearest& nearest) {
  // The side is x² + y² = (middle + slope z)² between the two ends.
  const float half = size.z();
  const float middle = 0.5F * (size.x() + size.y());
  const float slope = 0.5F * (size.y() - size.x()) / half;
  const float here = middle + slope * ray.o.z();
  const float a = ray.d.head<2>().squaredNorm() - slope * slope * ray.d.z() * ray.d.z();
  const float b = ray.o.head<2>().dot(ray.d.head<2>()) - slope * ray.d.z() * here;
  const float c = ray.o.head<2>().squaredNorm() - here * here;
  const auto meetSide = [&](float t) {
    const Vector3f point = ray.at(t);
    if (std::abs(point.z()) <= half) {
      const float radius = middle + slope * point.z();
      nearest.offer(t, Vector3f(point.x(), point.y(), -slope * radius).normalized());
    }
  };
  const float root = b * b - a * c;
  if (std::abs(a) <= kParallel) {
    if (std::abs(b) > kParallel) {
      meetSide(-0.5F * c / b);
    }
  } else if (root >= 0.0F) {
    meetSide((-b - std::sqrt(root)) / a);
    meetSide((-b + std::sqrt(root)) / a);
  }
  if (std::abs(ray.d.z()) > kParallel) {
    for (const auto& [end, radius] : {std::pair{-1.0F, size.x()}, std::pair{1.0F, size.y()}}) {
      const float t = (end * half - ray.o.z()) / ray.d.z();
      if (ray.at(t).head<2>().norm() <= radius) {
        nearest.offer(t, {0.0F, 0.0F, end});
      }
    }
  }
}

void meetBox(const OwnRay& ray, const Vector3f& size, Nearest& nearest) {
  float enter = -std::numeric_limits<float>::infinity();
  float leave = std::numeric_limits<float>::infinity();
  int side = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const float slope = std::abs(ray.d[axis]) < 1e-9F ? 1e-9F : ray.d[axis];
    const float reach = std::copysign(size[axis], slope);
    const float first = (-reach - ray.o[axis]) / slope;
    if (first > enter) {
      enter = first;
      side = axis;
    }
    leave = std::min(leave, (reach - ray.o[axis]) / slope);
  }
  if (enter <= leave) {
    Vector3f normal = Vector3f::Zero();
    normal[side] = ray.d[side] > 0.0F ? -1.0F : 1.0F;
    nearest.offer(enter, normal);
  }
}

void meet(const MovingPart& part, const OwnRay& ray, Nearest& nearest) {
  switch (part.shape) {
  case MovingShape::Ellipsoid:
    meetEllipsoid(ray, part.size, nearest);
    break;
  case MovingShape::Capsule:
    meetCapsule(ray, part.size.x(), part.size.z(), nearest);
    break;
  case MovingShape::Frustum:
    meetFrustum(ray, part.size, nearest);
    break;
  case MovingShape::Box:
    meetBox(ray, part.size, nearest);
    break;
  }
}

} // namespace

float boundingRadius(const MovingPart& part) {
  switch (part.shape) {
  case MovingShape::Ellipsoid:
    return part.size.maxCoeff();
  case MovingShape::Capsule:
    return part.size.x() + part.size.z();
  case MovingShape::Frustum:
    return std::hypot(std::max(part.size.x(), part.size.y()), part.size.z());
  case MovingShape::Box:
    return part.size.norm();
  }
  return 0.0F;
}

double volumeOf(const MovingPart& part) {
  const Eigen::Vector3d size = part.size.cast<double>();
  const double x = size.x();
  const double y = size.y();
  switch (part.shape) {
  case MovingShape::Ellipsoid:
    return 4.0 / 3.0 * std::numbers::pi * size.prod();
  case MovingShape::Capsule:
    return std::numbers::pi * x * x * (2.0 * size.z() + 4.0 / 3.0 * x);
  case MovingShape::Frustum:
    return 2.0 / 3.0 * std::numbers::pi * size.z() * (x * x + x * y + y * y);
  case MovingShape::Box:
    return 8.0 * size.prod();
  }
  return 0.0;
}

bool contains(const MovingPart& part, const Vector3f& point) {
  const Vector3f way = point - part.center;
  const float bound = boundingRadius(part);
  if (way.squaredNorm() > bound * bound) {
    return false;
  }
  const Vector3f p = part.axes * way;
  const Vector3f& size = part.size;
  switch (part.shape) {
  case MovingShape::Ellipsoid:
    return p.cwiseQuotient(size).squaredNorm() <= 1.0F;
  case MovingShape::Capsule: {
    const float along = std::clamp(p.z(), -size.z(), size.z());
    return (p - Vector3f{0.0F, 0.0F, along}).norm() <= size.x();
  }
  case MovingShape::Frustum: {
    const float share = 0.5F * (1.0F + p.z() / size.z()); // 0 at -Z, 1 at +Z
    return share >= 0.0F && share <= 1.0F &&
           p.head<2>().norm() <= size.x() + share * (size.y() - size.x());
  }
  case MovingShape::Box:
    return (p.cwiseAbs().array() <= size.array()).all();
  }
  return false;
}

void intersectPart(const MovingPart& part, const Vector3f& origin, const Vector3f& direction,
                   PartHit& hit) {
  const float shift = (part.center - origin).dot(direction);
  const Vector3f nearest = origin + shift * direction - part.center;
  const float bound = boundingRadius(part);
  if (nearest.squaredNorm() > bound * bound || shift + bound < 0.0F) {
    return;
  }
  Nearest met;
  meet(part, {part.axes * nearest, part.axes * direction}, met);
  if (!met.found()) {
    return;
  }
  const float distance = shift + met.found()->first;
  if (distance > kNear && distance < hit.distance) {
    hit.distance = distance;
    hit.normal = part.axes.transpose() * met.found()->second;
    hit.part = &part;
  }
}

} // namespace dewpoint::simulation
