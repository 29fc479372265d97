// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/room/illumination.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dewpoint::simulation {
namespace {

Vector3f lightOfLamps(const Illumination& illumination, const Vector3f& point,
                      const Vector3f& normal) {
  Vector3f light = Vector3f::Zero();
  for (const AdditionalLamp& lamp : illumination.additionalLamps) {
    const Vector3f way = lamp.position - point;
    const float lambert = std::max(0.0F, normal.dot(way.normalized()));
    light += lambert * lamp.falloffAt(way.norm()) * lamp.color;
  }
  return light;
}

cv::Vec3f pixelOf(const Vector3f& color) {
  return {color.x(), color.y(), color.z()};
}

/// The neighbor of a pixel along one axis of the image whose distance is more like its own.
int likerNeighbor(const RoomView& view, int column, int row, bool across) {
  const int here = across ? column : row;
  const int last = (across ? view.width : view.height) - 1;
  const float distance = view.distances[view.pixelIndex(column, row)];
  const auto difference = [&](int other) {
    const std::size_t pixel = across ? view.pixelIndex(other, row) : view.pixelIndex(column, other);
    return std::abs(view.distances[pixel] - distance);
  };
  if (here == 0 || here == last) {
    return here == 0 ? std::min(1, last) : here - 1;
  }
  return difference(here + 1) <= difference(here - 1) ? here + 1 : here - 1;
}

} // namespace

float AdditionalLamp::falloffAt(float distance) const {
  if (distance <= reach) {
    return 1.0F;
  }
  const float share = reach / distance;
  return share * share;
}

float blockedFractionAt(const MovingShadow& shadow, const Vector3f& point, double time) {
  const auto middle = static_cast<float>(shadow.initialPosition + shadow.speed * time);
  const float aside = std::abs(shadow.direction.dot(point) - middle);
  const float t = std::clamp((aside - shadow.halfWidth + shadow.borderHalfWidth) /
                                 (2.0F * shadow.borderHalfWidth),
                             0.0F, 1.0F);
  return shadow.blockedFraction * (1.0F - t * t * (3.0F - 2.0F * t));
}

Vector3f LightField::lightAt(const Vector3f& point, const Vector3f& normal) const {
  const Illumination& here = *illumination;
  const float lit = here.shadow ? 1.0F - blockedFractionAt(*here.shadow, point, time) : 1.0F;
  const float room = here.roomGain * matteSurfaceLight(point, normal, lit, here.lampPosition);
  return Vector3f::Constant(room) + lightOfLamps(here, point, normal);
}

Vector3f surfaceNormal(const RoomView& view, int column, int row) {
  const Vector3f& direction = view.directions[view.pixelIndex(column, row)];
  const auto pointAt = [&](int c, int r) -> Vector3f {
    const std::size_t pixel = view.pixelIndex(c, r);
    return view.distances[pixel] * view.directions[pixel];
  };
  const Vector3f here = pointAt(column, row);
  const Vector3f across = pointAt(likerNeighbor(view, column, row, true), row) - here;
  const Vector3f down = pointAt(column, likerNeighbor(view, column, row, false)) - here;
  const Vector3f normal = across.cross(down);
  if (!normal.allFinite() || normal.isZero(0.0F)) {
    return -direction;
  }
  return normal.dot(direction) > 0.0F ? Vector3f(-normal.normalized()) : normal.normalized();
}

RelitBackground relightBackground(const RoomView& view, const Illumination& illumination) {
  RelitBackground result{cv::Mat::zeros(view.height, view.width, CV_32FC3),
                         cv::Mat::zeros(view.height, view.width, CV_32FC3)};
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; ++column) {
      const std::size_t pixel = view.pixelIndex(column, row);
      if (view.directions[pixel].isZero(0.0F) || !std::isfinite(view.distances[pixel])) {
        continue;
      }
      const auto& seen = view.background.at<cv::Vec3f>(row, column);
      const Vector3f color{seen[0], seen[1], seen[2]};
      const Vector3f point = view.center + view.distances[pixel] * view.directions[pixel];
      const Vector3f normal = surfaceNormal(view, column, row);
      const float direct = view.lampFractions[pixel];
      // What does not come from the lamp directly tells how much light there is in all.
      const float light =
          matteSurfaceLight(point, normal, 0.0F, illumination.lampPosition) / (1.0F - direct);
      const Vector3f further =
          color.cwiseProduct(lightOfLamps(illumination, point, normal)) / light;
      const Vector3f own = illumination.roomGain * color;
      result.ambientLight.at<cv::Vec3f>(row, column) = pixelOf((1.0F - direct) * own + further);
      result.directLight.at<cv::Vec3f>(row, column) = pixelOf(direct * own);
    }
  }
  return result;
}

cv::Mat backgroundAt(const RoomView& view, const RelitBackground& background,
                     const Illumination& illumination, double time) {
  cv::Mat image = background.ambientLight + background.directLight;
  if (!illumination.shadow) {
    return image;
  }
  for (int row = 0; row < view.height; ++row) {
    auto* pixels = image.ptr<cv::Vec3f>(row);
    const auto* direct = background.directLight.ptr<cv::Vec3f>(row);
    for (int column = 0; column < view.width; ++column) {
      const std::size_t pixel = view.pixelIndex(column, row);
      if (view.directions[pixel].isZero(0.0F)) {
        continue;
      }
      const Vector3f point = view.center + view.distances[pixel] * view.directions[pixel];
      pixels[column] -= blockedFractionAt(*illumination.shadow, point, time) * direct[column];
    }
  }
  return image;
}

} // namespace dewpoint::simulation
