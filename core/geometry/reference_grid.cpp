// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/reference_grid.h"

#include "core/geometry/image_bounds.h"
#include "core/geometry/ray.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dewpoint::geometry {
namespace {

constexpr double kLargest = 1e4;  ///< meters
constexpr double kFarthest = 1e3; ///< meters; a ray that meets the grid's plane beyond is level
constexpr double kTolerance = 1e-9;

/// Sides of the grid: pairs of axes that span one, the other axis being 0.
std::vector<std::pair<int, int>> sidesOf(GridKind kind) {
  switch (kind) {
  case GridKind::Floor:
    return {{0, 1}};
  case GridKind::Wall:
    return {{0, 2}};
  case GridKind::Box:
    break;
  }
  return {{0, 1}, {0, 2}, {1, 2}};
}

bool uses(GridKind kind, int axis) {
  return std::ranges::any_of(sidesOf(kind), [axis](const auto& side) {
    return side.first == axis || side.second == axis;
  });
}

/// 0, step, 2 step, ..., and the end.
std::vector<double> linesOf(double size, double step) {
  std::vector<double> all;
  for (int k = 0; k * step < size - 1e-6 * step; ++k) {
    all.push_back(k * step);
  }
  all.push_back(size);
  return all;
}

GridRole axisRole(int axis) {
  return axis == 0 ? GridRole::AxisX : axis == 1 ? GridRole::AxisY : GridRole::AxisZ;
}

Eigen::Vector3d placed(int first, double a, int second, double b) {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  point[first] = a;
  point[second] = b;
  return point;
}

/// The lines along `along` at every place of `across`, but for the axis itself.
void addLines(const ReferenceGrid& grid, int along, int across, std::vector<GridLine>& lines) {
  for (const double at : linesOf(grid.size[across], grid.step)) {
    if (at == 0.0) {
      continue;
    }
    const GridRole role = at == grid.size[across] ? GridRole::Border : GridRole::Line;
    lines.push_back(
        {role, placed(along, 0.0, across, at), placed(along, grid.size[along], across, at)});
  }
}

/// The edges of the box that do not lie on its three sides through the origin.
void addBoxEdges(const ReferenceGrid& grid, std::vector<GridLine>& lines) {
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::Vector3d from = grid.size;
    from[axis] = 0.0;
    lines.push_back({GridRole::Border, from, grid.size});
  }
}

double distanceToChord(const Eigen::Vector2d& point, const Eigen::Vector2d& a,
                       const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  const double length = along.norm();
  if (length < kTolerance) {
    return (point - a).norm();
  }
  return std::abs(along.x() * (point.y() - a.y()) - along.y() * (point.x() - a.x())) / length;
}

/// Follows one world line through the image.
class LineTracer {
public:
  LineTracer(const Camera& camera, const Eigen::Vector3d& from, const Eigen::Vector3d& to)
      : projector_(camera), from_(from), to_(to), right_(camera.intrinsics.width - 0.5),
        bottom_(camera.intrinsics.height - 0.5) {}

  std::vector<std::vector<Eigen::Vector2d>> trace() {
    constexpr int kPieces = 16;
    auto before = at(0.0);
    for (int k = 1; k <= kPieces; ++k) {
      const double end = double(k) / kPieces;
      const auto after = at(end);
      piece(double(k - 1) / kPieces, before, end, after, 0);
      before = after;
    }
    return std::move(strokes_);
  }

private:
  using Pixel = std::optional<Eigen::Vector2d>;
  Pixel at(double t) const { return projector_.project(from_ + t * (to_ - from_)); }

  void piece(double t0, const Pixel& a, double t1, const Pixel& b, int depth) {
    constexpr double kBend = 0.2; // pixels
    constexpr int kDeepest = 9;
    constexpr int kDeepestAtEdge = 24; // where the line leaves what the camera can see
    if ((!a && !b) || (a && b && besideImage(*a, *b))) {
      return;
    }
    const double middle = 0.5 * (t0 + t1);
    if (!a || !b) {
      if (depth < kDeepestAtEdge) {
        const Pixel m = at(middle);
        piece(t0, a, middle, m, depth + 1);
        piece(middle, m, t1, b, depth + 1);
      }
      return;
    }
    const Pixel m = depth < kDeepest ? at(middle) : std::nullopt;
    if (m && distanceToChord(*m, *a, *b) > kBend) {
      piece(t0, a, middle, m, depth + 1);
      piece(middle, m, t1, b, depth + 1);
    } else {
      add(*a, *b);
    }
  }

  /// Whether both lie on one side of the image, far enough that no bend leads back into it.
  bool besideImage(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const {
    const double marginX = right_;
    const double marginY = bottom_;
    return std::max(a.x(), b.x()) < -marginX || std::min(a.x(), b.x()) > right_ + marginX ||
           std::max(a.y(), b.y()) < -marginY || std::min(a.y(), b.y()) > bottom_ + marginY;
  }

  /// The part of a segment inside the image (Liang and Barsky 1984), joined to what went before.
  void add(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    double enter = 0.0;
    double leave = 1.0;
    const Eigen::Vector2d way = b - a;
    const double delta[4] = {-way.x(), way.x(), -way.y(), way.y()};
    const double room[4] = {a.x() + 0.5, right_ - a.x(), a.y() + 0.5, bottom_ - a.y()};
    for (int side = 0; side < 4; ++side) {
      if (delta[side] == 0.0 && room[side] < 0.0) {
        return;
      }
      const double t = room[side] / delta[side];
      enter = delta[side] < 0.0 ? std::max(enter, t) : enter;
      leave = delta[side] > 0.0 ? std::min(leave, t) : leave;
    }
    if (enter >= leave) {
      return;
    }
    const Eigen::Vector2d start = a + enter * way;
    const Eigen::Vector2d end = a + leave * way;
    if (strokes_.empty() || (strokes_.back().back() - start).norm() > 1e-6) {
      strokes_.push_back({start});
    }
    strokes_.back().push_back(end);
  }

  Projector projector_;
  Eigen::Vector3d from_;
  Eigen::Vector3d to_;
  double right_;
  double bottom_;
  std::vector<std::vector<Eigen::Vector2d>> strokes_;
};

/// How far along a ray (in the grid's frame) it meets a side of the grid; the plane of the only
/// side has no end.
std::optional<double> meets(const ReferenceGrid& grid, std::pair<int, int> side,
                            const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
  const int across = 3 - side.first - side.second;
  const double t = -origin[across] / direction[across];
  if (!(t > 0.0 && t < kFarthest)) { // also when the ray runs along the plane
    return std::nullopt;
  }
  const Eigen::Vector3d hit = origin + t * direction;
  const auto inside = [&](int axis) { return hit[axis] >= 0.0 && hit[axis] <= grid.size[axis]; };
  const bool endless = grid.kind != GridKind::Box;
  return endless || (inside(side.first) && inside(side.second)) ? std::optional(t) : std::nullopt;
}

} // namespace

Eigen::Isometry3d ReferenceGrid::worldFromGrid() const {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::AngleAxisd(rotationAngle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  pose.translation() = origin;
  return pose;
}

Eigen::Vector3d ReferenceGrid::center() const {
  Eigen::Vector3d half = 0.5 * size;
  for (int axis = 0; axis < 3; ++axis) {
    half[axis] = uses(kind, axis) ? half[axis] : 0.0;
  }
  return worldFromGrid() * half;
}

Status checkGrid(const ReferenceGrid& grid) {
  if (!grid.origin.allFinite() || grid.origin.cwiseAbs().maxCoeff() > kLargest ||
      !std::isfinite(grid.rotationAngle)) {
    return failure(ErrorCode::BadValue, "", "origin",
                   fmt::format("numbers up to {} m are expected", kLargest));
  }
  if (!(grid.step > 0.0 && grid.step <= kLargest)) {
    return failure(ErrorCode::BadValue, "", "step", "a positive length is expected");
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (!(grid.size[axis] > 0.0 && grid.size[axis] <= kLargest)) {
      return failure(ErrorCode::BadValue, "", "size", "positive lengths are expected");
    }
    if (uses(grid.kind, axis) && grid.size[axis] > kMaxGridLines * grid.step * (1.0 + 1e-9)) {
      return failure(ErrorCode::BadValue, "", "step",
                     fmt::format("more than {} lines along one side", kMaxGridLines));
    }
  }
  return {};
}

std::vector<GridLine> gridLines(const ReferenceGrid& grid) {
  std::vector<GridLine> lines;
  for (const auto& [first, second] : sidesOf(grid.kind)) {
    addLines(grid, first, second, lines);
    addLines(grid, second, first, lines);
  }
  if (grid.kind == GridKind::Box) {
    addBoxEdges(grid, lines);
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (uses(grid.kind, axis)) {
      lines.push_back(
          {axisRole(axis), Eigen::Vector3d::Zero(), grid.size[axis] * Eigen::Vector3d::Unit(axis)});
    }
  }
  std::ranges::stable_sort(lines, {}, &GridLine::role);
  const Eigen::Isometry3d worldFromGrid = grid.worldFromGrid();
  for (GridLine& line : lines) {
    line.from = worldFromGrid * line.from;
    line.to = worldFromGrid * line.to;
  }
  return lines;
}

std::vector<GridText<3>> gridLabels(const ReferenceGrid& grid) {
  constexpr int kMostLabels = 10;
  const Eigen::Isometry3d worldFromGrid = grid.worldFromGrid();
  std::vector<GridText<3>> labels;
  for (int axis = 0; axis < 3; ++axis) {
    if (!uses(grid.kind, axis)) {
      continue;
    }
    const Eigen::Vector3d unit = Eigen::Vector3d::Unit(axis);
    const int every = std::max(1, int(std::ceil(grid.size[axis] / (grid.step * kMostLabels))));
    for (int k = every; k * grid.step < grid.size[axis] - 0.5 * grid.step; k += every) {
      labels.push_back({axisRole(axis), worldFromGrid * Eigen::Vector3d(k * grid.step * unit),
                        fmt::format("{:.6g}", k * grid.step)});
    }
    labels.push_back({axisRole(axis), worldFromGrid * Eigen::Vector3d(grid.size[axis] * unit),
                      fmt::format("{} {:.6g} m", "xyz"[axis], grid.size[axis])});
  }
  return labels;
}

ProjectedGrid projectGrid(const Camera& camera, const ReferenceGrid& grid) {
  ProjectedGrid result;
  for (const GridLine& line : gridLines(grid)) {
    for (auto& points : LineTracer(camera, line.from, line.to).trace()) {
      result.strokes.push_back({line.role, std::move(points)});
    }
  }
  const Projector projector(camera);
  for (const GridText<3>& label : gridLabels(grid)) {
    const auto at = projector.project(label.at);
    if (at && isInImage(camera.intrinsics, *at)) {
      result.labels.push_back({label.role, *at, label.text});
    }
  }
  return result;
}

std::optional<Eigen::Vector3d> gridCrossingAt(const Camera& camera, const ReferenceGrid& grid,
                                              const Eigen::Vector2d& pixel, double reach) {
  const Projector projector(camera);
  const Eigen::Isometry3d worldFromGrid = grid.worldFromGrid();
  std::optional<Eigen::Vector3d> nearest;
  for (const auto& [first, second] : sidesOf(grid.kind)) {
    for (const double a : linesOf(grid.size[first], grid.step)) {
      for (const double b : linesOf(grid.size[second], grid.step)) {
        const Eigen::Vector3d world = worldFromGrid * placed(first, a, second, b);
        const auto seen = projector.project(world);
        if (seen && (*seen - pixel).norm() < reach) {
          reach = (*seen - pixel).norm();
          nearest = world;
        }
      }
    }
  }
  return nearest;
}

std::optional<Eigen::Vector3d> gridPointAt(const Camera& camera, const ReferenceGrid& grid,
                                           const Eigen::Vector2d& pixel, double reach) {
  if (const auto crossing = gridCrossingAt(camera, grid, pixel, reach)) {
    return crossing;
  }
  const auto ray = Unprojector(camera).ray(pixel);
  if (!ray) {
    return std::nullopt;
  }
  const Eigen::Isometry3d gridFromWorld = grid.worldFromGrid().inverse();
  const Eigen::Vector3d origin = gridFromWorld * ray->origin;
  const Eigen::Vector3d direction = gridFromWorld.linear() * ray->direction;
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& side : sidesOf(grid.kind)) {
    nearest = std::min(nearest, meets(grid, side, origin, direction).value_or(nearest));
  }
  if (!std::isfinite(nearest)) {
    nearest = std::max(0.1, (grid.center() - ray->origin).norm());
  }
  return ray->origin + nearest * ray->direction;
}

} // namespace dewpoint::geometry
