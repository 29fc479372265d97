// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene3d/scene3d.h"

#include "core/geometry/projected_lines.h"
#include "core/session/view/target_colors.h"
#include "ui/scene3d/scene_parts.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::ui {

namespace {

/// What is drawn of a target that is hidden.
TargetSnapshot nothingOf(const TargetSnapshot& target) {
  TargetSnapshot nothing;
  nothing.target = target.target;
  nothing.estimate = AbsentEstimate{};
  nothing.status = TargetStatus::Gone;
  return nothing;
}

} // namespace

Scene3d::Scene3d() : parts_(std::make_unique<SceneParts>()) {
  parts_->coverGround();
  parts_->applyPalette();
}

Scene3d::~Scene3d() = default;

vtkRenderer* Scene3d::renderer() {
  return parts_->renderer;
}

void Scene3d::setTheme(bool dark) {
  parts_->isDark = dark;
  parts_->applyPalette();
}

void Scene3d::setDecimalPoint(const std::string& sign) {
  parts_->ground.setDecimalPoint(sign);
  parts_->applyPalette(); // new texts take its colors
}

void Scene3d::setPixelRatio(double ratio) {
  parts_->scale.pixelRatio = std::isfinite(ratio) && ratio > 0.0 ? ratio : 1.0;
}

void Scene3d::setSnapshot(const TrackSnapshot& snapshot) {
  SceneParts& parts = *parts_;
  if (snapshot.rig != parts.rig) {
    parts.showRig(snapshot.rig);
  }
  parts.includeInContent(snapshot);
  if (parts.showsImages) {
    parts.frustumImages.show(parts.frusta.glyphs(), snapshot.frames);
  }
  const std::size_t count = std::min(snapshot.targets.size(), SceneParts::kMaxDetailedTargets);
  parts.showUndetailedTargetMeans(snapshot);
  if (parts.targets.size() > count) {
    parts.targets.resize(count);
  }
  const bool added = parts.targets.size() < count;
  while (parts.targets.size() < count) {
    parts.targets.push_back(std::make_unique<TargetActors>(parts.renderer));
  }
  std::vector<DisplayColorSource> sources = displayColorSources(snapshot);
  for (std::size_t i = 0; i < count; ++i) {
    const TargetSnapshot& target = snapshot.targets[i];
    TargetActors& actors = *parts.targets[i];
    const bool isShown = target.target.isShown;
    isShown ? actors.show(target) : actors.show(nothingOf(target));
    // Of people there would be too many to be read.
    const bool rays = parts.showsRays && isShown && !snapshot.family.findsTargets();
    actors.showLinesOfSight(rays ? sightLines(snapshot, target) : std::vector<SightLine>());
    actors.showPath(isShown ? parts.meanPath.positionsOf(i) : std::vector<Eigen::Vector3d>());
    actors.setChosen(static_cast<int>(i) == parts.chosenTarget);
    actors.setBestParticleShown(parts.showsBestParticle);
  }
  if (added || sources != parts.colorSources) {
    parts.colorSources = std::move(sources);
    parts.applyTargetColors();
  }
}

void Scene3d::recordSnapshot(const TrackSnapshot& snapshot) {
  parts_->meanPath.add(snapshot);
}

void Scene3d::setRaysShown(bool shown) {
  parts_->showsRays = shown;
}

void Scene3d::setImagesShown(bool shown) {
  SceneParts& parts = *parts_;
  parts.showsImages = shown;
  parts.frustumImages.hide(); // until the next snapshot
  parts.frusta.show(parts.rig ? *parts.rig : CameraRig(), parts.frustumLength());
}

void Scene3d::setBestParticleShown(bool shown) {
  parts_->showsBestParticle = shown;
  for (const auto& target : parts_->targets) {
    target->setBestParticleShown(shown);
  }
}

void Scene3d::setChosenTarget(int target) {
  parts_->chosenTarget = target;
  for (std::size_t i = 0; i < parts_->targets.size(); ++i) {
    parts_->targets[i]->setChosen(static_cast<int>(i) == target);
  }
}

void Scene3d::highlight(const std::vector<std::vector<Eigen::Vector3d>>& strokes) {
  parts_->selectedRange.show(strokes);
}

void Scene3d::showMap(std::shared_ptr<const RigMap> map, const MapOptions& look) {
  SceneParts& parts = *parts_;
  const Eigen::AlignedBox3d before = parts.map.volume();
  parts.map.show(std::move(map), look);
  const Eigen::AlignedBox3d now = parts.map.volume();
  if (before.isEmpty() != now.isEmpty() || (!now.isEmpty() && !before.isApprox(now))) {
    parts.coverGround();
    parts.isFramingPending = parts.isFramingPending || !parts.isViewMovedByUser;
  }
}

std::optional<Eigen::Vector3d> Scene3d::positionInMapLayer(const Eigen::Vector2d& place) const {
  const Eigen::AlignedBox3d volume = parts_->map.volume();
  const MapOptions& look = parts_->map.options();
  if (volume.isEmpty() || !look.showsLayer) {
    return std::nullopt;
  }
  auto there = positionAtHeight(place, look.layerHeight);
  if (!there || !volume.contains(*there)) {
    return std::nullopt;
  }
  return there;
}

std::optional<Eigen::Vector3d> Scene3d::positionAtHeight(const Eigen::Vector2d& place,
                                                         double height) const {
  const ScreenScale& scale = parts_->scale;
  const Eigen::Vector3d near = scale.unproject(place, scale.eye + scale.direction);
  const Eigen::Vector3d far = scale.unproject(place, scale.eye + 2.0 * scale.direction);
  const double fall = far.z() - near.z();
  if (std::abs(fall) < 1e-6) {
    return std::nullopt;
  }
  Eigen::Vector3d there = near + (height - near.z()) / fall * (far - near);
  there.z() = height; // without rounding: it may be the border of a volume
  return there;
}

void Scene3d::showVolume(const std::optional<WorldBox>& volume) {
  SceneParts& parts = *parts_;
  std::vector<std::vector<Eigen::Vector3d>> lines;
  if (volume) {
    for (const auto& [from, to] : edgesOf(*volume)) {
      lines.push_back({from, to});
    }
  }
  const Eigen::AlignedBox3d before = parts.sceneBox();
  parts.volume.show(lines);
  if (!parts.sceneBox().isApprox(before)) {
    parts.isFramingPending = parts.isFramingPending || !parts.isViewMovedByUser;
  }
}

void Scene3d::showLineOfSight(const std::vector<Eigen::Vector3d>& line) {
  line.empty() ? parts_->lineOfSight.show({}) : parts_->lineOfSight.show({line});
}

void Scene3d::showPlannedCameras(const CameraRig& cameras) {
  parts_->plannedFrusta.show(cameras, parts_->frustumLength());
  parts_->plannedFrusta.setPalette(parts_->plannedPalette());
}

void Scene3d::clear() {
  setSnapshot(TrackSnapshot{});
}

void Scene3d::setView(View view) {
  parts_->view = view;
  resetView();
}

Scene3d::View Scene3d::view() const {
  return parts_->view;
}

void Scene3d::resetView() {
  parts_->isViewMovedByUser = false;
  parts_->isFramingPending = true;
}

void Scene3d::keepCurrentView() {
  parts_->isViewMovedByUser = true;
}

void Scene3d::copyView(const Scene3d& other, double aspect) {
  SceneParts& parts = *parts_;
  const SceneParts& from = *other.parts_;
  parts.isDark = from.isDark;
  parts.showsBestParticle = from.showsBestParticle;
  parts.showsRays = from.showsRays;
  parts.chosenTarget = from.chosenTarget;
  setImagesShown(from.showsImages);
  parts.applyPalette();
  setView(from.view);
  if (!from.isViewMovedByUser || from.viewportWidth <= 0 || from.viewportHeight <= 0) {
    return;
  }
  parts.rigFittedToView =
      from.rigFittedToView; // or the first snapshot would fit the view to its rig
  parts.camera->DeepCopy(from.camera);
  parts.uprightPosition = from.uprightPosition;
  parts.isViewMovedByUser = true;
  parts.isFramingPending = false;
  const double seen = static_cast<double>(from.viewportWidth) / from.viewportHeight;
  if (aspect < seen) {
    zoom(aspect / seen);
  }
}

void Scene3d::zoom(double factor) {
  if (!std::isfinite(factor) || factor <= 0.0) {
    return;
  }
  parts_->isViewMovedByUser = true;
  if (parts_->view == View::Free) {
    parts_->camera->Dolly(factor);
  } else {
    parts_->camera->SetParallelScale(parts_->camera->GetParallelScale() / factor);
  }
}

void Scene3d::prepareRendering(int width, int height) {
  SceneParts& parts = *parts_;
  const bool resized = width != parts.viewportWidth || height != parts.viewportHeight;
  parts.viewportWidth = width;
  parts.viewportHeight = height;
  if (parts.isFramingPending || (resized && !parts.isViewMovedByUser)) {
    parts.fitView();
    parts.isFramingPending = false;
  }
  parts.keepUpright();
  parts.updateClippingRange();
  parts.updateScale();
  parts.ground.prepareRendering(parts.scale);
  parts.frusta.prepareRendering(parts.scale);
  parts.plannedFrusta.prepareRendering(parts.scale);
  parts.map.prepareRendering(parts.scale);
  parts.volume.prepareRendering(parts.scale);
  parts.lineOfSight.prepareRendering(parts.scale);
  parts.selectedRange.prepareRendering(parts.scale);
  parts.undetailedTargetMeans.prepareRendering(parts.scale, focalPoint());
  for (const auto& target : parts.targets) {
    target->prepareRendering(parts.scale);
  }
}

SceneColor Scene3d::colorOf(std::size_t target) const {
  const std::vector<DisplayColor>& palette = displayPalette(DisplayBackground::Light);
  return target < parts_->targets.size() ? parts_->targets[target]->color()
                                         : palette[target % palette.size()];
}

std::vector<CameraGlyph> Scene3d::cameraGlyphs() const {
  std::vector<CameraGlyph> glyphs = parts_->frusta.glyphs();
  const std::vector<CameraGlyph>& planned = parts_->plannedFrusta.glyphs();
  glyphs.insert(glyphs.end(), planned.begin(), planned.end());
  return glyphs;
}

std::vector<Eigen::AlignedBox2d> Scene3d::textAreas() const {
  std::vector<Eigen::AlignedBox2d> places;
  parts_->ground.appendTextAreas(parts_->scale, places);
  return places;
}

Eigen::Vector3d Scene3d::rightAxisInWorld() const {
  return parts_->scale.right;
}

Eigen::Vector3d Scene3d::upAxisInWorld() const {
  return parts_->scale.up;
}

bool Scene3d::isInFront(const Eigen::Vector3d& point) const {
  return parts_->scale.isParallel || parts_->scale.depth(point) > 0.05;
}

double Scene3d::lengthInLogicalPixels(const Eigen::Vector3d& point, double meters) const {
  return meters / parts_->scale.lengthInMeters(point, 1.0);
}

Eigen::Vector3d Scene3d::focalPoint() const {
  return Eigen::Vector3d(parts_->camera->GetFocalPoint());
}

Eigen::Vector2d Scene3d::projectToImage(const Eigen::Vector3d& point) const {
  return parts_->scale.project(point);
}

Eigen::Vector3d Scene3d::unproject(const Eigen::Vector2d& place,
                                   const Eigen::Vector3d& depth) const {
  return parts_->scale.unproject(place, depth);
}

double Scene3d::metersPerPixel() const {
  return parts_->scale.metersPerPixel;
}

} // namespace dewpoint::ui
