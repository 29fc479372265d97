// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/convex_hull.h"

#include "core/geometry/projector.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace dewpoint::geometry {
namespace {

using Points = std::vector<Eigen::Vector3d>;

struct Face {
  std::array<int, 3> corners;
  Eigen::Vector3d normal;
  double offset;
};

Face faceOf(const Points& points, int a, int b, int c) {
  const auto& origin = points[static_cast<std::size_t>(a)];
  const Eigen::Vector3d normal = (points[static_cast<std::size_t>(b)] - origin)
                                     .cross(points[static_cast<std::size_t>(c)] - origin)
                                     .normalized();
  return {{a, b, c}, normal, normal.dot(origin)};
}

template <class Measure> int farthest(const Points& points, const Measure& measure) {
  const auto best = std::ranges::max_element(points, {}, measure);
  return static_cast<int>(best - points.begin());
}

/// Four points that span a volume, or nothing if all lie within `slack` of a plane.
std::optional<std::array<int, 4>> firstCorners(const Points& points, double slack) {
  const auto at = [&](int index) { return points[static_cast<std::size_t>(index)]; };
  const int a = farthest(points, [](const auto& p) { return p.x(); });
  const int b = farthest(points, [&](const auto& p) { return (p - at(a)).squaredNorm(); });
  const Eigen::Vector3d line = (at(b) - at(a)).normalized();
  const int c =
      farthest(points, [&](const auto& p) { return (p - at(a)).cross(line).squaredNorm(); });
  if ((at(c) - at(a)).cross(line).norm() <= slack) {
    return std::nullopt;
  }
  const Eigen::Vector3d normal = line.cross(at(c) - at(a)).normalized();
  const int d = farthest(points, [&](const auto& p) { return std::abs(normal.dot(p - at(a))); });
  const double height = normal.dot(at(d) - at(a));
  if (std::abs(height) <= slack) {
    return std::nullopt;
  }
  return height > 0.0 ? std::array{a, c, b, d} : std::array{a, b, c, d};
}

/// The order in which most points turn out to lie inside already.
std::vector<int> outermostFirst(const Points& points, const Eigen::Vector3d& middle) {
  std::vector<std::pair<double, int>> order;
  for (std::size_t k = 0; k < points.size(); ++k) {
    order.emplace_back(-(points[k] - middle).squaredNorm(), static_cast<int>(k));
  }
  std::ranges::sort(order);
  std::vector<int> result;
  result.reserve(order.size());
  for (const auto& [distance, index] : order) {
    result.push_back(index);
  }
  return result;
}

/// Replaces the faces that see the point by a cone from the point to their rim.
void addPoint(const Points& points, int index, double slack, std::vector<Face>& faces) {
  const Eigen::Vector3d& point = points[static_cast<std::size_t>(index)];
  const auto sees = [&](const Face& face) { return face.normal.dot(point) - face.offset > slack; };
  if (std::ranges::none_of(faces, sees)) {
    return;
  }
  std::map<std::pair<int, int>, bool> edges; // directed, of the faces that are seen
  std::vector<Face> kept;
  for (const Face& face : faces) {
    if (!sees(face)) {
      kept.push_back(face);
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      edges[{face.corners[k], face.corners[(k + 1) % 3]}] = true;
    }
  }
  for (const auto& [edge, seen] : edges) {
    if (!edges.contains({edge.second, edge.first})) {
      kept.push_back(faceOf(points, edge.first, edge.second, index));
    }
  }
  faces = std::move(kept);
}

/// Only the points that are corners of faces, renumbered in their order.
ConvexHull compact(const Points& points, const std::vector<Face>& faces) {
  std::vector<int> number(points.size(), -1);
  for (const Face& face : faces) {
    for (const int corner : face.corners) {
      number[static_cast<std::size_t>(corner)] = 0;
    }
  }
  ConvexHull hull;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (number[k] == 0) {
      number[k] = static_cast<int>(hull.vertices.size());
      hull.vertices.push_back(points[k]);
    }
  }
  for (const Face& face : faces) {
    const auto of = [&](std::size_t k) {
      return number[static_cast<std::size_t>(face.corners[k])];
    };
    hull.faces.push_back({of(0), of(1), of(2)});
  }
  return hull;
}

double cross(const Eigen::Vector2d& o, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return (a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x());
}

} // namespace

double ConvexHull::volume() const {
  double sixfold = 0.0;
  for (const auto& face : faces) {
    const auto at = [&](std::size_t k) -> Eigen::Vector3d {
      return vertices[static_cast<std::size_t>(face[k])] - vertices.front();
    };
    sixfold += at(0).dot(at(1).cross(at(2)));
  }
  return sixfold / 6.0;
}

ConvexHull convexHull(const std::vector<Eigen::Vector3d>& points) {
  if (points.size() < 4) {
    return {points, {}};
  }
  Eigen::Vector3d low = points.front();
  Eigen::Vector3d high = points.front();
  for (const auto& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const double slack = 1e-9 * (high - low).norm();
  const auto first = firstCorners(points, slack);
  if (!first) {
    return {points, {}};
  }
  const auto [a, b, c, d] = *first;
  std::vector<Face> faces{faceOf(points, a, b, c), faceOf(points, a, d, b), faceOf(points, b, d, c),
                          faceOf(points, c, d, a)};
  for (const int k : outermostFirst(points, 0.5 * (low + high))) {
    addPoint(points, k, slack, faces);
  }
  return compact(points, faces);
}

std::vector<Eigen::Vector2d> convexHull(std::vector<Eigen::Vector2d> points) {
  if (points.size() < 3) {
    return points;
  }
  std::ranges::sort(points, [](const auto& a, const auto& b) {
    return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
  });
  std::vector<Eigen::Vector2d> hull;
  const auto addChain = [&hull](const auto& chain) {
    const std::size_t begin = hull.size();
    for (const auto& point : chain) {
      while (hull.size() >= begin + 2 && cross(hull[hull.size() - 2], hull.back(), point) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(point);
    }
    hull.pop_back(); // the other chain begins with it
  };
  addChain(points);
  std::ranges::reverse(points);
  addChain(points);
  return hull;
}

std::vector<Eigen::Vector2d> projectedHull(const Projector& projector, const ConvexHull& hull) {
  std::vector<Eigen::Vector2d> pixels;
  for (const auto& vertex : hull.vertices) {
    if (const auto pixel = projector.project(vertex)) {
      pixels.push_back(*pixel);
    }
  }
  return convexHull(std::move(pixels));
}

} // namespace dewpoint::geometry
