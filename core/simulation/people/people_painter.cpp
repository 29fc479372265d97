// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/people/people_painter.h"

#include "core/simulation/room/soft_shadow.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace dewpoint::simulation {
namespace {

/// Rays as a part sees them: in its own axes, in units of its half sizes.
struct PartRay {
  Vector3f origin;
  Eigen::Matrix3f toPart;
  PartShape shape;

  PartRay(const BodyPart& part, const Vector3f& from)
      : toPart(part.halfSize.cwiseInverse().asDiagonal() * part.axes), shape(part.shape) {
    origin = toPart * (from - part.center);
  }
  /// Distance along the unit direction to where the ray enters the part.
  std::optional<float> enter(const Vector3f& direction) const {
    const Vector3f d = toPart * direction;
    return shape == PartShape::Box ? enterBox(d) : enterEllipsoid(d);
  }
  Vector3f normal(float distance, const Vector3f& direction) const {
    Vector3f surface = origin + distance * (toPart * direction);
    if (shape == PartShape::Box) { // the face is that of the coordinate of largest size
      Eigen::Index face = 0;
      surface.cwiseAbs().maxCoeff(&face);
      surface = std::copysign(1.0F, surface[face]) * Vector3f::Unit(face);
    }
    return (toPart.transpose() * surface).normalized();
  }

private:
  std::optional<float> enterEllipsoid(const Vector3f& d) const {
    const float a = d.squaredNorm();
    const float b = origin.dot(d);
    const float root = b * b - a * (origin.squaredNorm() - 1.0F);
    if (root < 0.0F || b > 0.0F) {
      return std::nullopt;
    }
    return (-b - std::sqrt(root)) / a;
  }
  /// The slab test on the cube from -1 to 1; nothing when the ray begins inside.
  std::optional<float> enterBox(const Vector3f& d) const {
    float enter = -std::numeric_limits<float>::infinity();
    float leave = std::numeric_limits<float>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      const float slope = std::abs(d[axis]) < 1e-9F ? 1e-9F : d[axis];
      const float side = std::copysign(1.0F, slope);
      enter = std::max(enter, (-side - origin[axis]) / slope);
      leave = std::min(leave, (side - origin[axis]) / slope);
    }
    return enter <= leave && enter > 0.0F ? std::optional(enter) : std::nullopt;
  }
};

cv::Rect boundsOf(const RoomView& view, const BodyPart& part) {
  if (part.shape == PartShape::Box) {
    return view.boundsOfSphere(part.center.cast<double>(), part.halfSize.norm());
  }
  // Along a thin limb a ball around it would be far too large: three balls along it.
  const float radius = std::max(part.halfSize.x(), part.halfSize.y());
  const float reach = std::max(0.0F, part.halfSize.z() - radius);
  cv::Rect area;
  for (const float along : {-1.0F, 0.0F, 1.0F}) {
    const Vector3f middle = part.center + along * reach * part.axes.row(2).transpose();
    area |= view.boundsOfSphere(middle.cast<double>(), 1.05 * radius);
  }
  return area;
}

/// The color of a part in full light at a point of the world.
Vector3f colorAt(const BodyPart& part, const Vector3f& point) {
  return part.cloth.pattern == ClothPattern::Plain
             ? part.color
             : clothColor(part.cloth, part.color, part.axes * (point - part.center));
}

/// Calls `enter(row, column, pixel, distance)` for the pixels whose ray enters the part, at a
/// distance along `ray` in meters.
template <class Enter>
void forEachPixelOf(const RoomView& view, const BodyPart& part, const PartRay& ray,
                    const Enter& enter) {
  const cv::Rect area = boundsOf(view, part);
  for (int row = area.y; row < area.y + area.height; ++row) {
    for (int column = area.x; column < area.x + area.width; ++column) {
      const std::size_t pixel = view.pixelIndex(column, row);
      const Vector3f& direction = view.directions[pixel];
      const auto distance = direction.isZero(0.0F) ? std::nullopt : ray.enter(direction);
      if (distance && *distance > 0.0F) {
        enter(row, column, pixel, *distance);
      }
    }
  }
}

class Canvas {
public:
  Canvas(const RoomView& view, cv::Mat& image, cv::Mat* who)
      : view_(view), image_(image), who_(who), depth_(view.distances) {}

  /// `lit(point, normal, color)`: the color that is seen of a surface of a color in full light.
  template <class Lit> void paint(const BodyPart& part, std::uint8_t person, const Lit& lit) {
    const PartRay ray(part, view_.center);
    forEachPixelOf(view_, part, ray, [&](int row, int column, std::size_t pixel, float distance) {
      if (distance >= depth_[pixel]) {
        return;
      }
      depth_[pixel] = distance;
      const Vector3f& direction = view_.directions[pixel];
      const Vector3f point = view_.center + distance * direction;
      const Vector3f color = lit(point, ray.normal(distance, direction), colorAt(part, point));
      image_.at<cv::Vec3f>(row, column) = {color.x(), color.y(), color.z()};
      if (who_ != nullptr) {
        who_->at<std::uint8_t>(row, column) = part.belongsToBody ? person : 0;
      }
    });
  }

private:
  const RoomView& view_;
  cv::Mat& image_;
  cv::Mat* who_;
  std::vector<float> depth_;
};

/// Adds the shadow that a part casts on the floor, as that of a ball: `covered` becomes the share
/// of the lamp that is hidden, per pixel.
void addShadow(const RoomView& view, const BodyPart& part, const Vector3f& lamp, cv::Mat& covered) {
  constexpr float kPanel = 0.35F; // radius of the office's lamp, meters: of a panel of 0.6 x 0.6 m
  constexpr float kBelowLamp = 0.3F; // meters: nearer to it shadows would be endless
  const float radius = std::cbrt(part.halfSize.prod());
  const float height = std::min(part.center.z(), lamp.z() - kBelowLamp);
  const Vector3f spot = lamp + (part.center - lamp) * (lamp.z() / (lamp.z() - height));
  const float reach =
      radius * lamp.z() / (lamp.z() - height) + kPanel * height / (lamp.z() - height);
  const cv::Rect area = view.boundsOfSphere({spot.x(), spot.y(), 0.0}, 1.2 * reach);
  const ShadowCaster caster{part.center, radius, lamp, kPanel, 0.01F, 0.02F};
  forEachShadedPixel(view, area, caster,
                     [&](int row, int column, std::size_t /*pixel*/, float hidden, float blur) {
                       const float share = hidden * std::min(1.0F, radius * radius / (blur * blur));
                       float& most = covered.at<float>(row, column);
                       most = 1.0F - (1.0F - most) * (1.0F - share);
                     });
}

/// The share of the lamp that people hide, per pixel (CV_32FC1).
cv::Mat shadowsOf(const RoomView& view, const std::vector<std::vector<BodyPart>>& people,
                  const Vector3f& lamp) {
  cv::Mat covered = cv::Mat::zeros(view.height, view.width, CV_32FC1);
  for (const auto& parts : people) {
    for (const BodyPart& part : parts) {
      addShadow(view, part, lamp, covered);
    }
  }
  return covered;
}

/// Calls `darken(row, column, share)` for the pixels in a shadow.
template <class Darken> void forEachCovered(const cv::Mat& covered, const Darken& darken) {
  for (int row = 0; row < covered.rows; ++row) {
    for (int column = 0; column < covered.cols; ++column) {
      if (const float share = covered.at<float>(row, column); share > 0.0F) {
        darken(row, column, share);
      }
    }
  }
}

template <class Lit>
void paintAll(const std::vector<std::vector<BodyPart>>& people, Canvas& canvas, const Lit& lit) {
  for (std::size_t person = 0; person < people.size(); ++person) {
    for (const BodyPart& part : people[person]) {
      canvas.paint(part, static_cast<std::uint8_t>(person + 1), lit);
    }
  }
}

} // namespace

cv::Mat wholeSilhouette(const RoomView& view, const std::vector<BodyPart>& parts) {
  cv::Mat mask = cv::Mat::zeros(view.height, view.width, CV_8UC1);
  for (const BodyPart& part : parts) {
    if (part.belongsToBody) {
      forEachPixelOf(view, part, PartRay(part, view.center),
                     [&](int row, int column, std::size_t /*pixel*/, float /*distance*/) {
                       mask.at<std::uint8_t>(row, column) = 255;
                     });
    }
  }
  return mask;
}

void paintPeople(const RoomView& view, const std::vector<std::vector<BodyPart>>& people,
                 const Vector3f& lamp, cv::Mat& image, cv::Mat* who) {
  if (who != nullptr) {
    *who = cv::Mat::zeros(image.size(), CV_8UC1);
  }
  if (people.empty()) {
    return;
  }
  forEachCovered(shadowsOf(view, people, lamp), [&](int row, int column, float share) {
    image.at<cv::Vec3f>(row, column) *=
        1.0F - share * view.lampFractions[view.pixelIndex(column, row)];
  });
  Canvas canvas(view, image, who);
  paintAll(people, canvas,
           [&](const Vector3f& point, const Vector3f& normal, const Vector3f& color) -> Vector3f {
             return matteSurfaceLight(point, normal, 1.0F, lamp) * color;
           });
}

void paintPeople(const RoomView& view, const std::vector<std::vector<BodyPart>>& people,
                 const PeopleLight& light, cv::Mat& image) {
  if (people.empty()) {
    return;
  }
  const Illumination& illumination = *light.lightField.illumination;
  const cv::Mat& direct = light.background->directLight;
  forEachCovered(shadowsOf(view, people, illumination.lampPosition), [&](int row, int column,
                                                                         float share) {
    const std::size_t pixel = view.pixelIndex(column, row);
    const Vector3f point = view.center + view.distances[pixel] * view.directions[pixel];
    const float passing =
        illumination.shadow ? blockedFractionAt(*illumination.shadow, point, light.lightField.time)
                            : 0.0F;
    image.at<cv::Vec3f>(row, column) -=
        share * (1.0F - passing) * direct.at<cv::Vec3f>(row, column);
  });
  Canvas canvas(view, image, nullptr);
  paintAll(people, canvas,
           [&](const Vector3f& point, const Vector3f& normal, const Vector3f& color) -> Vector3f {
             return light.lightField.lightAt(point, normal).cwiseProduct(color);
           });
}

} // namespace dewpoint::simulation
