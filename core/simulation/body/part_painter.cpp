// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/body/part_painter.h"

#include "core/simulation/surface/sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace dewpoint::simulation {
namespace {

using Parts = std::vector<MovingPart>;

/// What the instants so far contribute to one pixel: color times coverage, and coverage.
struct Contribution {
  Vector3f color{0.0F, 0.0F, 0.0F};
  float coverage = 0.0F;
};

/// The pixels that can show a part.
cv::Rect boundsOf(const RoomView& view, const MovingPart& part) {
  const auto ball = [&](const Vector3f& center, float radius) {
    return view.boundsOfSphere(center.cast<double>(), radius);
  };
  if (part.shape == MovingShape::Capsule || part.shape == MovingShape::Frustum) {
    // Balls at its two ends: it is in their convex hull.
    const Vector3f half = part.size.z() * part.axes.row(2).transpose();
    const bool round = part.shape == MovingShape::Capsule;
    const cv::Rect low = ball(part.center - half, part.size.x());
    const cv::Rect high = ball(part.center + half, round ? part.size.x() : part.size.y());
    if (!low.empty() && !high.empty()) {
      return low | high;
    }
  }
  if ((part.center - view.center).norm() <= boundingRadius(part)) {
    return {0, 0, view.width, view.height}; // the camera is among its ends
  }
  return ball(part.center, boundingRadius(part));
}

/// The pixels that can show each part at one of three instants of an exposure.
std::vector<cv::Rect> boundsOf(const RoomView& view, const std::array<Parts, 3>& instants,
                               const cv::Rect& within) {
  std::vector<cv::Rect> areas(instants[0].size());
  for (std::size_t i = 0; i < areas.size(); ++i) {
    for (const Parts& parts : instants) {
      areas[i] |= boundsOf(view, parts[i]);
    }
    areas[i] &= within;
  }
  return areas;
}

/// Pixels that the fastest point of any part travels between two instants, by shift and turn.
double travelPx(const RoomView& view, const Parts& from, const Parts& to) {
  double most = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const float turned = (to[i].axes - from[i].axes).rowwise().norm().maxCoeff();
    const float meters = (to[i].center - from[i].center).norm() + turned * boundingRadius(from[i]);
    const float distance = std::max(0.01F, (from[i].center - view.center).norm());
    most = std::max(most, view.projector.intrinsics().focalX * double{meters / distance});
  }
  return most;
}

/// Draws one instant.
class InstantPainter {
public:
  InstantPainter(const RoomView& view, const Parts& parts, const std::vector<cv::Rect>& areas,
                 const Shading& shading)
      : view_(view), parts_(parts), areas_(areas), shading_(shading) {}

  void addTo(const cv::Rect& area, std::vector<Contribution>& all) {
    auto contribution = all.begin();
    for (int row = area.y; row < area.y + area.height; ++row) {
      for (int column = area.x; column < area.x + area.width; ++column, ++contribution) {
        choose(column, row);
        if (!chosen_.empty() && !view_.directions[view_.pixelIndex(column, row)].isZero(0.0F)) {
          addPixel(column, row, *contribution);
        }
      }
    }
  }

private:
  /// What a ray meets: nothing where `hit` has no part.
  struct Seen {
    PartHit hit;
    Vector3f direction;
    Vector3f color{0.0F, 0.0F, 0.0F};
    bool isSameAs(const Seen& other) const {
      return hit.part == other.hit.part && color == other.color;
    }
  };

  void choose(int column, int row) {
    chosen_.clear();
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if (areas_[i].contains(cv::Point(column, row))) {
        chosen_.push_back(&parts_[i]);
      }
    }
  }

  Seen seenAt(int column, int row, float right, float down) const {
    Seen seen;
    seen.direction = view_.rayDirection(column, row, right, down);
    seen.hit.distance = view_.distances[view_.pixelIndex(column, row)];
    for (const MovingPart* part : chosen_) {
      intersectPart(*part, view_.center, seen.direction, seen.hit);
    }
    if (seen.hit.part != nullptr) {
      seen.color = seen.hit.part->colorAt(seen.hit.normal);
    }
    return seen;
  }

  void add(const Seen& seen, float weight, Contribution& contribution) const {
    if (seen.hit.part != nullptr) {
      const Vector3f point = view_.center + seen.hit.distance * seen.direction;
      contribution.color += weight * shading_({point, seen.hit.normal, seen.direction, seen.color,
                                               seen.hit.part->gloss});
      contribution.coverage += weight;
    }
  }

  void addPixel(int column, int row, Contribution& contribution) const {
    const Seen middle = seenAt(column, row, 0.0F, 0.0F);
    bool even = true;
    for (const auto& [right, down] : {std::pair{-0.5F, -0.5F}, std::pair{0.5F, -0.5F},
                                      std::pair{-0.5F, 0.5F}, std::pair{0.5F, 0.5F}}) {
      even = even && seenAt(column, row, right, down).isSameAs(middle);
    }
    if (even) {
      add(middle, 1.0F, contribution);
      return;
    }
    constexpr int kSamples = kEdgeSamples * kEdgeSamples;
    for (int i = 0; i < kSamples; ++i) {
      const auto [right, down] = subpixelOffset(i, kEdgeSamples);
      add(seenAt(column, row, right, down), 1.0F / kSamples, contribution);
    }
  }

  const RoomView& view_;
  const Parts& parts_;
  const std::vector<cv::Rect>& areas_;
  const Shading& shading_;
  std::vector<const MovingPart*> chosen_; ///< that the pixel under way can show
};

void blend(const cv::Rect& area, const std::vector<Contribution>& contributions, float weight,
           cv::Mat& image) {
  auto contribution = contributions.begin();
  for (int row = area.y; row < area.y + area.height; ++row) {
    auto* pixels = image.ptr<cv::Vec3f>(row);
    for (int column = area.x; column < area.x + area.width; ++column, ++contribution) {
      const Vector3f color = weight * contribution->color;
      pixels[column] = pixels[column] * (1.0F - weight * contribution->coverage) +
                       cv::Vec3f{color.x(), color.y(), color.z()};
    }
  }
}

} // namespace

void paintParts(const RoomView& view, const PartsAt& partsAt, const Exposure& exposure,
                const cv::Rect& within, const Shading& shading, cv::Mat& image) {
  const double half = 0.5 * exposure.durationSeconds;
  const std::array<Parts, 3> instants{partsAt(exposure.centerTime - half),
                                      partsAt(exposure.centerTime),
                                      partsAt(exposure.centerTime + half)};
  const std::vector<cv::Rect> areas = boundsOf(view, instants, within);
  cv::Rect area;
  for (const cv::Rect& one : areas) {
    area |= one;
  }
  if (area.empty()) {
    return;
  }
  const double travel = travelPx(view, instants[0], instants[2]);
  const int count =
      std::clamp(static_cast<int>(std::ceil(travel / kPixelsPerInstant)), 1, kMaxInstants);
  std::vector<Contribution> contributions(static_cast<std::size_t>(area.area()));
  for (int k = 0; k < count; ++k) {
    const double at = exposure.centerTime + half * ((2.0 * k + 1.0) / count - 1.0);
    const Parts parts = count == 1 ? instants[1] : partsAt(at);
    InstantPainter(view, parts, areas, shading).addTo(area, contributions);
  }
  blend(area, contributions, 1.0F / static_cast<float>(count), image);
}

} // namespace dewpoint::simulation
