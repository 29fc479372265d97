// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/draft/scenario_paths.h"

#include <cmath>

namespace dewpoint::experiment::scenarios {

Eigen::Vector3d LissajousPath::operator()(double time) const {
  const double angle = kFullTurn * time / periodSeconds;
  return center + Eigen::Vector3d(extent.x() * std::sin(angle + phase.x()),
                                  extent.y() * std::sin(2.0 * angle + phase.y()),
                                  extent.z() * std::sin(3.0 * angle + phase.z()));
}

namespace {

/// Whether all points of the outline are in the image and `isShown(column, row, distance)`; the
/// distance is that of the center.
template <typename IsShown>
bool isOutlineShown(const simulation::RoomView& view, const Eigen::Vector3d& center, double radius,
                    const IsShown& isShown) {
  constexpr int kPoints = 12;     // of the outline, every 30 degrees; chosen
  constexpr double kMargin = 1.1; // of the radius: a little of what is around it is seen as well
  const Eigen::Vector3d eye = view.center.cast<double>();
  const Eigen::Vector3d way = center - eye;
  const double distance = way.norm();
  if (distance < 2.0 * radius) {
    return false;
  }
  const Eigen::Vector3d u = way.unitOrthogonal();
  const Eigen::Vector3d v = way.cross(u) / distance;
  for (int i = 0; i <= kPoints; ++i) {
    const double angle = kFullTurn * i / kPoints;
    const double aside = i == kPoints ? 0.0 : kMargin * radius;
    const auto pixel =
        view.projector.project(center + aside * (std::cos(angle) * u + std::sin(angle) * v));
    if (!pixel) {
      return false;
    }
    const auto column = static_cast<int>(std::lround(pixel->x()));
    const auto row = static_cast<int>(std::lround(pixel->y()));
    if (column < 0 || row < 0 || column >= view.width || row >= view.height ||
        !isShown(column, row, distance)) {
      return false;
    }
  }
  return true;
}

} // namespace

bool isFullyVisible(const simulation::RoomView& view, const Eigen::Vector3d& center,
                    double radius) {
  return isOutlineShown(view, center, radius, [&](int column, int row, double distance) {
    // What lies beside a ball on the desk may be a little nearer than its middle.
    return view.distances[view.pixelIndex(column, row)] >= distance - 0.5 * radius;
  });
}

bool isWithinImage(const simulation::RoomView& view, const Eigen::Vector3d& center, double radius) {
  return isOutlineShown(view, center, radius, [](int, int, double) { return true; });
}

bool isFullyVisible(const simulation::Stage& stage, const Eigen::Vector3d& center, double radius) {
  for (const auto& view : stage.views) {
    if (!isFullyVisible(*view, center, radius)) {
      return false;
    }
  }
  return true;
}

bool staysVisible(const ScenarioDraft& draft, const simulation::Path& path, double radius) {
  for (std::int64_t frame = 0; frame < draft.frameCount; ++frame) {
    if (!isFullyVisible(draft.stage, path(draft.timeOf(frame)), radius)) {
      return false;
    }
  }
  return true;
}

bool areSeparated(const simulation::RoomView& view, const Eigen::Vector3d& one, double oneRadius,
                  const Eigen::Vector3d& other, double otherRadius, double gap) {
  const Eigen::Vector3d eye = view.center.cast<double>();
  const Eigen::Vector3d toOne = one - eye;
  const Eigen::Vector3d toOther = other - eye;
  if (toOne.norm() <= oneRadius || toOther.norm() <= otherRadius) {
    return false;
  }
  const double between = std::atan2(toOne.cross(toOther).norm(), toOne.dot(toOther));
  return between >
         std::asin(oneRadius / toOne.norm()) + std::asin(otherRadius / toOther.norm()) + gap;
}

std::optional<LissajousPath> randomDeskPath(ScenarioDraft& draft, bool fast, double radius) {
  /// Half size of a path, meters: about what both cameras of the demo rig show.
  const Eigen::Vector3d kExtent{0.11, 0.08, 0.05};
  RandomDraws& draws = draft.draws;
  for (int i = 0; i < kMaxDrawAttempts; ++i) {
    LissajousPath path;
    path.center = draws.drawPointInBox(kPathLow, kPathHigh);
    path.extent = draft.pathScale * draws.drawUniform(0.8, 1.1) * kExtent;
    path.phase =
        draws.drawPointInBox(Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(kFullTurn));
    path.periodSeconds = fast ? kFastPathPeriod : kSlowPathPeriod;
    if (staysVisible(draft, path, radius)) {
      return path;
    }
  }
  return std::nullopt;
}

bool addDeskBall(ScenarioDraft& draft, std::int64_t frames, bool fast) {
  draft.frameCount = frames;
  const auto path = randomDeskPath(draft, fast);
  if (!path) {
    return false;
  }
  addTarget(draft, *path);
  startNearTruth(draft);
  return true;
}

} // namespace dewpoint::experiment::scenarios
