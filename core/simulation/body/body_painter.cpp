// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/body/body_painter.h"

#include "core/simulation/body/part_painter.h"
#include "core/simulation/room/room.h"
#include "core/simulation/room/soft_shadow.h"
#include "core/simulation/surface/sampling.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

namespace dewpoint::simulation {
namespace {

/// What one instant contributes to one pixel: color times coverage, and coverage.
struct Share {
  Vector3f color{0.0F, 0.0F, 0.0F};
  float coverage = 0.0F;
};

/// The rows that an exposure is for, as an area of the image.
cv::Rect rowsOf(const RoomView& view, const Exposure& exposure) {
  const int first = std::max(0, exposure.firstRow);
  const int end = std::min(view.height, exposure.endRow);
  return {0, first, view.width, std::max(0, end - first)};
}

const Vector3f& lampOf(const Body& body) {
  return body.light != nullptr ? body.light->illumination->lampPosition : kLampPosition;
}

/// The color of a matte surface of a body in the light that falls on it.
Vector3f litColor(const Body& body, const Vector3f& point, const Vector3f& normal) {
  if (body.light != nullptr) {
    return body.light->lightAt(point, normal).cwiseProduct(body.color);
  }
  return matteSurfaceLight(point, normal, 1.0F) * body.color;
}

/// The color of a ball's surface at `normal`: matte, with a faint broad highlight, kBallGloss.
Vector3f ballColor(const Body& body, const Vector3f& point, const Vector3f& direction) {
  const Vector3f normal = (point - body.center) / body.radius;
  const Vector3f halfway = ((lampOf(body) - point).normalized() - direction).normalized();
  const float facing = std::max(0.0F, normal.dot(halfway));
  const float facing4 = facing * facing * facing * facing;
  static_assert(kBallGloss.exponent == 12.0F);
  const float gloss = kBallGloss.peakLevel * facing4 * facing4 * facing4;
  // A ball on a desk is dark below: it hides the room's light there from itself.
  const Vector3f color = litColor(body, point, normal) + Vector3f::Constant(gloss);
  // In other light it is the sensor that cuts.
  return body.light != nullptr ? color : Vector3f(color.cwiseMin(255.0F));
}

/// Where a ray enters the sphere; nothing when it misses it or the sphere lies behind.
std::optional<float> hitSphere(const Body& body, const Vector3f& origin,
                               const Vector3f& direction) {
  const Vector3f way = body.center - origin;
  const float along = way.dot(direction);
  const float root = along * along - way.squaredNorm() + body.radius * body.radius;
  if (root < 0.0F || along < 0.0F) {
    return std::nullopt;
  }
  return along - std::sqrt(root);
}

Share sample(const RoomView& view, const Body& body, const Vector3f& direction, float limit) {
  if (!body.isBox) {
    const auto distance = hitSphere(body, view.center, direction);
    if (!distance || *distance >= limit) {
      return {};
    }
    return {ballColor(body, view.center + *distance * direction, direction), 1.0F};
  }
  const Vector3f o = body.axes * (view.center - body.center);
  const Vector3f d = body.axes * direction;
  float enter = 0.0F;
  float leave = limit;
  int side = 2;
  for (int axis = 0; axis < 3; ++axis) {
    const float slope = std::abs(d[axis]) < 1e-9F ? 1e-9F : d[axis];
    const float reach = std::copysign(body.halfSize[axis], slope);
    if ((-reach - o[axis]) / slope > enter) {
      enter = (-reach - o[axis]) / slope;
      side = axis;
    }
    leave = std::min(leave, (reach - o[axis]) / slope);
  }
  if (enter >= leave || enter <= 0.0F) {
    return {};
  }
  Vector3f normal = body.axes.row(side).transpose();
  if (d[side] > 0.0F) {
    normal = -normal;
  }
  return {litColor(body, view.center + enter * direction, normal), 1.0F};
}

bool onEdge(const RoomView& view, const Body& body, int column, int row) {
  if (body.isBox) {
    return true;
  }
  const Vector3f way = body.center - view.center;
  const Vector3f& here = view.directions[view.pixelIndex(column, row)];
  const float along = way.dot(here);
  const float aside = std::sqrt(std::max(0.0F, way.squaredNorm() - along * along));
  const float pixel = along * (view.rayDirection(column, row, 0.5F, 0.5F) - here).norm();
  return std::abs(aside - body.radius) < 1.2F * pixel;
}

void addInstant(const RoomView& view, const Body& body, const cv::Rect& area,
                std::vector<Share>& shares) {
  auto share = shares.begin();
  for (int row = area.y; row < area.y + area.height; ++row) {
    for (int column = area.x; column < area.x + area.width; ++column, ++share) {
      const std::size_t pixel = view.pixelIndex(column, row);
      const Vector3f& here = view.directions[pixel];
      if (here.isZero(0.0F)) {
        continue;
      }
      const float limit = view.distances[pixel];
      if (!onEdge(view, body, column, row)) {
        const Share whole = sample(view, body, here, limit);
        share->color += whole.color;
        share->coverage += whole.coverage;
        continue;
      }
      constexpr float kWeight = 1.0F / (kEdgeSamples * kEdgeSamples);
      for (int i = 0; i < kEdgeSamples * kEdgeSamples; ++i) {
        const auto [right, down] = subpixelOffset(i, kEdgeSamples);
        const Share part = sample(view, body, view.rayDirection(column, row, right, down), limit);
        share->color += kWeight * part.color;
        share->coverage += kWeight * part.coverage;
      }
    }
  }
}

void castShadow(const RoomView& view, const Body& body, const cv::Rect& rows, cv::Mat& image) {
  // Only the shadow on the desk (z = 0) is drawn; a sphere around it bounds its pixels.
  const Vector3f lamp = lampOf(body);
  if (body.isBox || body.center.z() + body.radius >= lamp.z() || body.center.z() < 0.0F) {
    return;
  }
  const Vector3f spot = lamp + (body.center - lamp) * (lamp.z() / (lamp.z() - body.center.z()));
  const float penumbra = kLampRadius * body.center.z() / lamp.z();
  const cv::Rect area =
      rows & view.boundsOfSphere(spot.cast<double>(), 1.6 * (body.radius + penumbra));
  const ShadowCaster caster{body.center, body.radius, lamp, kLampRadius, 0.002F, 0.01F};
  forEachShadedPixel(view, area, caster,
                     [&](int row, int column, std::size_t pixel, float covered, float /*blur*/) {
                       image.at<cv::Vec3f>(row, column) *=
                           1.0F - covered * view.lampFractions[pixel];
                     });
}

/// The light that comes from a point of a body of parts; `light` is that of the body.
Vector3f partColor(const SurfacePoint& seen, const LightField* light) {
  const Vector3f& lamp = light != nullptr ? light->illumination->lampPosition : kLampPosition;
  const float gloss =
      seen.gloss.highlightAt(seen.normal, (lamp - seen.point).normalized(), seen.direction);
  if (light != nullptr) { // it is the sensor that cuts
    return light->lightAt(seen.point, seen.normal).cwiseProduct(seen.color) +
           Vector3f::Constant(gloss);
  }
  const float shaded = matteSurfaceLight(seen.point, seen.normal, 1.0F);
  return (shaded * seen.color + Vector3f::Constant(gloss)).cwiseMin(255.0F);
}

/// What casts a body's shadow: a body of parts casts that of a ball of their volume.
Body shadowBody(const Body& body) {
  if (body.parts.empty()) {
    return body;
  }
  double volume = 0.0;
  for (const MovingPart& part : body.parts) {
    volume += volumeOf(part);
  }
  Body ball;
  ball.center = body.center;
  ball.radius = static_cast<float>(std::cbrt(0.75 / std::numbers::pi * volume));
  ball.color = body.color;
  ball.light = body.light;
  return ball;
}

} // namespace

void paintBodies(const RoomView& view, const BodiesAt& bodiesAt, const Exposure& exposure,
                 cv::Mat& image) {
  const double time = exposure.centerTime;
  const double half = 0.5 * exposure.durationSeconds;
  const auto middle = bodiesAt(time);
  const auto opening = bodiesAt(time - half);
  const auto closing = bodiesAt(time + half);
  const cv::Rect rows = rowsOf(view, exposure);
  std::vector<std::size_t> order(middle.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i] = i;
    if (middle[i].isPresent) {
      castShadow(view, shadowBody(middle[i]), rows, image);
    }
  }
  // Far to near: what is nearer covers what is farther.
  std::ranges::sort(order, std::greater<>{},
                    [&](std::size_t i) { return (middle[i].center - view.center).squaredNorm(); });
  std::vector<Share> shares;
  for (const std::size_t i : order) {
    if (!middle[i].parts.empty()) {
      if (middle[i].isPresent) {
        paintParts(
            view, [&](double instant) { return bodiesAt(instant)[i].parts; }, exposure, rows,
            [&](const SurfacePoint& seen) { return partColor(seen, middle[i].light); }, image);
      }
      continue;
    }
    const auto boundsAt = [&](const Body& body) {
      return view.boundsOfSphere(body.center.cast<double>(), body.radius);
    };
    const cv::Rect first = boundsAt(opening[i]);
    const cv::Rect last = boundsAt(closing[i]);
    const cv::Rect area = (first | boundsAt(middle[i]) | last) & rows;
    if (area.empty() || !middle[i].isPresent) {
      continue;
    }
    const double travel = cv::norm((first.tl() + first.br() - last.tl() - last.br()) / 2);
    const int instants =
        std::clamp(static_cast<int>(std::ceil(travel / kPixelsPerInstant)), 1, kMaxInstants);
    shares.assign(static_cast<std::size_t>(area.area()), {});
    for (int k = 0; k < instants; ++k) {
      const double at = time + half * ((2.0 * k + 1.0) / instants - 1.0);
      addInstant(view, instants == 1 ? middle[i] : bodiesAt(at)[i], area, shares);
    }
    auto share = shares.begin();
    const float weight = 1.0F / static_cast<float>(instants);
    for (int row = area.y; row < area.y + area.height; ++row) {
      auto* pixels = image.ptr<cv::Vec3f>(row);
      for (int column = area.x; column < area.x + area.width; ++column, ++share) {
        const Vector3f color = weight * share->color;
        pixels[column] = pixels[column] * (1.0F - weight * share->coverage) +
                         cv::Vec3f{color.x(), color.y(), color.z()};
      }
    }
  }
}

} // namespace dewpoint::simulation
