// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene3d/scene_parts.h"

#include "core/geometry/rig_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace dewpoint::ui {
namespace {

constexpr double kViewAngle = 35.0 * std::numbers::pi / 180.0; ///< vertical, free view
constexpr double kMargin = 1.14;   ///< of the picture around what is framed
constexpr double kBottomPx = 34.0; ///< kept free below, for buttons
constexpr double kSidePx = 20.0;   ///< kept free on either side, for the numbers of the axes
/// From the scene towards the eye of the free view.
const Eigen::Vector3d kFreeSide = Eigen::Vector3d(-0.55, -1.0, 0.75).normalized();

Eigen::Vector3d toEigen(const double* values) {
  return {values[0], values[1], values[2]};
}

std::vector<Eigen::Vector3d> corners(const Eigen::AlignedBox3d& box) {
  std::vector<Eigen::Vector3d> result;
  result.reserve(8);
  for (int i = 0; i < 8; ++i) {
    result.push_back(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
  }
  return result;
}

} // namespace

void SceneParts::applyPalette() {
  const SceneColor& background = palette().background;
  renderer->SetBackground(background.x(), background.y(), background.z());
  ground.setPalette(palette());
  frusta.setPalette(palette());
  plannedFrusta.setPalette(plannedPalette());
  map.setPalette(palette());
  selectedRange.setPalette(palette());
  volume.setColor(palette().text, 0.55);
  lineOfSight.setColor(palette().truth, 0.8);
  undetailedTargetMeans.setColors(palette().text, palette().text);
  applyTargetColors();
}

void SceneParts::applyTargetColors() {
  const std::vector<DisplayColor> colors =
      displayColors(colorSources, isDark ? DisplayBackground::Dark : DisplayBackground::Light);
  for (std::size_t k = 0; k < std::min(targets.size(), colors.size()); ++k) {
    targets[k]->setColors(colors[k], palette(), isDark);
  }
}

ScenePalette SceneParts::plannedPalette() const {
  ScenePalette colors = palette();
  colors.camera = displayPalette(DisplayBackground::Light)[2]; // no target is drawn as a pyramid
  return colors;
}

void SceneParts::showRig(const std::shared_ptr<const CameraRig>& shown) {
  const CameraRig none;
  const std::shared_ptr<const CameraRig> last = rigFittedToView; // lives on while it is compared
  const CameraRig& before = last ? *last : none;
  const CameraRig& cameras = shown ? *shown : none;
  rigBox = rigBounds(cameras);
  // While one camera is adjusted, the picture holds still unless that camera leaves it.
  const RigChange change = rigChange(before, cameras);
  const bool adjusted = change == RigChange::OneCamera;
  contentBox = adjusted ? contentBox.merged(rigBox) : rigBox;
  rig = shown;
  if (!cameras.empty()) {
    rigFittedToView = shown;
    if (!adjusted) {
      isViewMovedByUser = isViewMovedByUser && change != RigChange::Elsewhere;
      isFramingPending = isFramingPending || !isViewMovedByUser;
    }
  }
  frusta.show(cameras, frustumLength());
  frusta.setPalette(palette());
  coverGround();
}

/// Lets the framed room grow with the estimates, but not after one that has run away.
void SceneParts::includeInContent(const TrackSnapshot& snapshot) {
  const Eigen::AlignedBox3d before = contentBox;
  const double reach = rigBox.isEmpty() ? 100.0 : 3.0 * std::max(1.0, rigBox.diagonal().norm());
  const Eigen::Vector3d middle =
      rigBox.isEmpty() ? Eigen::Vector3d::Zero() : Eigen::Vector3d(rigBox.center());
  const auto extend = [&](const Eigen::Vector3d& point) {
    if (point.allFinite() && (point - middle).norm() < reach) {
      contentBox.extend(point);
    }
  };
  for (const TargetSnapshot& target : snapshot.targets) {
    const auto position = positionOf(target.estimate);
    if (position && particleCountOf(target.estimate) > 0) {
      extend(position->mean);
    }
    if (target.truth) {
      extend(*target.truth);
    }
    std::for_each(target.tailPositions.begin(), target.tailPositions.end(), extend);
  }
  if (before.isEmpty() != contentBox.isEmpty() || !before.contains(contentBox)) {
    coverGround();
  }
}

void SceneParts::showUndetailedTargetMeans(const TrackSnapshot& snapshot) {
  const std::size_t count = snapshot.targets.size();
  if (count <= kMaxDetailedTargets) {
    undetailedTargetMeans.hide();
    return;
  }
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN(); // is not drawn
  Eigen::ArrayXXd means = Eigen::ArrayXXd::Constant(
      static_cast<Eigen::Index>(count - kMaxDetailedTargets), 3, kUnknown);
  for (std::size_t k = kMaxDetailedTargets; k < count; ++k) {
    const auto position = positionOf(snapshot.targets[k].estimate);
    if (position && snapshot.targets[k].target.isShown) {
      means.row(static_cast<Eigen::Index>(k - kMaxDetailedTargets)) =
          position->mean.transpose().array();
    }
  }
  undetailedTargetMeans.show(means, {});
}

void SceneParts::coverGround() {
  Eigen::AlignedBox3d shown = contentBox;
  shown.extend(map.volume());
  Eigen::AlignedBox2d area;
  if (shown.isEmpty()) {
    area = Eigen::AlignedBox2d(Eigen::Vector2d(-1.0, -1.0), Eigen::Vector2d(1.0, 1.0));
  } else {
    const Eigen::Vector2d low = shown.min().head<2>();
    const Eigen::Vector2d high = shown.max().head<2>();
    const double margin = std::max(0.05, 0.06 * (high - low).maxCoeff());
    area = Eigen::AlignedBox2d(low.array() - margin, high.array() + margin);
  }
  const Eigen::AlignedBox2d before = ground.extent();
  ground.cover(area, shown.isEmpty() ? 1.0 : shown.max().z(),
               shown.isEmpty() ? 0.0 : shown.min().z());
  ground.setPalette(palette());
  if (before.isEmpty() || !before.isApprox(ground.extent())) {
    isFramingPending = isFramingPending || !isViewMovedByUser;
  }
}

/// Puts floor and content into the picture, as large as they fit.
void SceneParts::fitView() {
  const Eigen::AlignedBox3d box = sceneBox();
  const Eigen::Vector3d side = view == View::Above   ? Eigen::Vector3d(Eigen::Vector3d::UnitZ())
                               : view == View::Front ? Eigen::Vector3d(-Eigen::Vector3d::UnitY())
                               : view == View::Side  ? Eigen::Vector3d(Eigen::Vector3d::UnitX())
                                                     : kFreeSide;
  // Seen from above, "right" does not follow from the vertical: it is x, as in the papers.
  const Eigen::Vector3d right = view == View::Above
                                    ? Eigen::Vector3d(Eigen::Vector3d::UnitX())
                                    : Eigen::Vector3d::UnitZ().cross(side).normalized();
  const Eigen::Vector3d up = side.cross(right);
  const double pixels = std::max(1, viewportHeight);
  const double free = std::max(0.5 * pixels, pixels - kBottomPx * scale.pixelRatio);
  const double across =
      std::max(0.5 * std::max(1, viewportWidth), viewportWidth - 2.0 * kSidePx * scale.pixelRatio);
  const double aspect = across / free;
  const double slope = std::tan(kViewAngle / 2.0) * free / pixels;
  Eigen::Vector3d center = box.center();
  double halfHeight = 1e-3; // of the free part
  double distance = 1e-3;
  // In perspective, the middle of the picture depends on the distance and that on the middle.
  for (int round = 0; round < 6; ++round) {
    halfHeight = distance = 1e-3;
    for (const Eigen::Vector3d& corner : corners(box)) {
      const Eigen::Vector3d offset = corner - center;
      const double needed =
          kMargin * std::max(std::abs(offset.dot(up)), std::abs(offset.dot(right)) / aspect);
      halfHeight = std::max(halfHeight, needed);
      distance = std::max(distance, needed / slope + offset.dot(side));
    }
    Eigen::AlignedBox2d picture;
    for (const Eigen::Vector3d& corner : corners(box)) {
      const Eigen::Vector3d offset = corner - center;
      const double shrink = view == View::Free ? distance / (distance - offset.dot(side)) : 1.0;
      picture.extend(Eigen::Vector2d(offset.dot(right), offset.dot(up)) * shrink);
    }
    center += right * picture.center().x() + up * picture.center().y();
  }
  const double whole = halfHeight * pixels / free;
  center -=
      up * (view == View::Free ? distance * slope * (pixels / free - 1.0) : whole - halfHeight);
  const double away = view == View::Free ? distance : 10.0 + box.diagonal().norm();
  const Eigen::Vector3d position = center + side * away;
  camera->SetViewAngle(kViewAngle * 180.0 / std::numbers::pi);
  camera->SetParallelProjection(view != View::Free);
  camera->SetParallelScale(whole);
  camera->SetFocalPoint(center.data());
  camera->SetPosition(position.data());
  const Eigen::Vector3d upright =
      view == View::Free ? Eigen::Vector3d(Eigen::Vector3d::UnitZ()) : up;
  camera->SetViewUp(upright.data());
  uprightPosition = position;
}

Eigen::AlignedBox3d SceneParts::sceneBox() const {
  Eigen::AlignedBox3d box = contentBox;
  box.extend(map.volume());
  box.extend(volume.extent());
  box.extend(Eigen::Vector3d(ground.extent().min().x(), ground.extent().min().y(), 0.0));
  box.extend(Eigen::Vector3d(ground.extent().max().x(), ground.extent().max().y(), 0.0));
  return box;
}

/// Orbiting keeps the horizon level and stops short of the pole, where "up" would flip.
void SceneParts::keepUpright() {
  if (view != View::Free) {
    return;
  }
  const Eigen::Vector3d focal = toEigen(camera->GetFocalPoint());
  const Eigen::Vector3d offset = toEigen(camera->GetPosition()) - focal;
  const double rise = offset.z() / std::max(offset.norm(), 1e-9);
  const bool overTheTop = camera->GetViewUp()[2] < 0.0;
  if (!offset.allFinite() || std::abs(rise) > 0.995 || overTheTop) {
    camera->SetPosition(uprightPosition.data());
  }
  camera->SetViewUp(0.0, 0.0, 1.0);
  uprightPosition = toEigen(camera->GetPosition());
}

void SceneParts::updateClippingRange() {
  const Eigen::Vector3d eye = toEigen(camera->GetPosition());
  const Eigen::Vector3d direction = toEigen(camera->GetDirectionOfProjection());
  double farthest = 1.0;
  const Eigen::AlignedBox3d box = sceneBox();
  for (const Eigen::Vector3d& corner : corners(box)) {
    farthest = std::max(farthest, (corner - eye).dot(direction));
  }
  // Room to spare for particles scattered beyond.
  const double far = farthest + 2.0 * box.diagonal().norm();
  camera->SetClippingRange(view == View::Free ? std::max(0.01, 0.002 * far) : 0.01, far);
}

void SceneParts::updateScale() {
  const Eigen::Vector3d focal = toEigen(camera->GetFocalPoint());
  scale.eye = toEigen(camera->GetPosition());
  scale.direction = toEigen(camera->GetDirectionOfProjection());
  scale.right = scale.direction.cross(toEigen(camera->GetViewUp())).normalized();
  scale.up = scale.right.cross(scale.direction);
  scale.isParallel = camera->GetParallelProjection() != 0;
  scale.metersPerPixelAndDepth = 2.0 * std::tan(kViewAngle / 2.0) / std::max(1, viewportHeight);
  scale.metersPerPixel = scale.isParallel
                             ? 2.0 * camera->GetParallelScale() / std::max(1, viewportHeight)
                             : scale.metersPerPixelAndDepth * (focal - scale.eye).norm();
}

} // namespace dewpoint::ui
