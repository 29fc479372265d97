// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/manual_calibration.h"

#include "core/base/angle.h"
#include "core/setup/calibration/calibrated_project.h"
#include "ui/document/camera_list_model.h"
#include "ui/document/document.h"
#include "ui/selection/selection.h"
#include "ui/text/quantity_text.h"

#include <QUndoStack>
#include <fmt/format.h>

#include <algorithm>

namespace dewpoint::ui {
namespace {

constexpr double kMoveStep = 0.01;                ///< meters
constexpr double kTurnStep = 0.2 * base::kDegree; ///< radians

/// Where an axis of the person's (right, forward, up) lies in the camera's (right, down, forward).
Eigen::Vector3d cameraAxis(int axis) {
  return axis == 0   ? Eigen::Vector3d::UnitX()
         : axis == 1 ? Eigen::Vector3d::UnitZ()
                     : Eigen::Vector3d(-Eigen::Vector3d::UnitY());
}

} // namespace

ManualCalibration::ManualCalibration(Document& document, Selection& selection,
                                     CameraListModel& cameras, QObject* parent)
    : QObject(parent), document_(document), selection_(selection), cameras_(cameras) {
  connect(&document_, &Document::changed, this, [this](const ProjectChanges& changes) {
    if (changes.calibrationChanged || changes.sourcesChanged || changes.gridChanged ||
        changes.pointsChanged) {
      Q_EMIT this->changed();
    }
  });
  connect(&document_, &Document::projectReplaced, this, [this] {
    drag_.reset();
    pins_.clear();
    resetEarlier();
    selection_.selectCamera(0);
    Q_EMIT cameraSelected(camera());
    Q_EMIT changed();
  });
  // Not at each change of the project: during it, the index of the step is not known yet.
  connect(document_.undoStack(), &QUndoStack::indexChanged, this,
          &ManualCalibration::followHistory);
  connect(&selection_, &Selection::cameraSelected, this, [this] {
    Q_EMIT cameraSelected(camera());
    Q_EMIT changed();
  });
}

void ManualCalibration::setActive(bool active) {
  if (active == active_) {
    return;
  }
  active_ = active;
  if (active_) {
    defaultGrid_ = referenceGridFor(currentCameras());
  } else {
    cancelDrag();
  }
  Q_EMIT activeChanged(active_);
  Q_EMIT changed();
}

void ManualCalibration::setSuspended(bool suspended) {
  if (suspended != suspended_) {
    suspended_ = suspended;
    Q_EMIT changed();
  }
}

void ManualCalibration::selectCamera(int camera) {
  if (camera >= 0 && camera < cameraCount()) {
    selection_.selectCamera(camera);
  }
}

int ManualCalibration::camera() const {
  return std::clamp(selection_.camera(), 0, std::max(0, cameraCount() - 1));
}

int ManualCalibration::cameraCount() const {
  return static_cast<int>(document_.project().cameras.size());
}

Camera ManualCalibration::cameraInProject(int camera) const {
  const auto& all = document_.project().cameras;
  const auto index = static_cast<std::size_t>(camera);
  return index < all.size() ? all[index].camera : Camera();
}

Camera ManualCalibration::shownCamera(int camera) const {
  const auto index = static_cast<std::size_t>(camera);
  if (earlier_ && index < camerasOf(*earlier_).size()) {
    return camerasOf(*earlier_)[index];
  }
  return cameraInProject(camera);
}

QString ManualCalibration::nameOf(int camera) const {
  return cameras_.nameOf(camera);
}

ReferenceGrid ManualCalibration::grid() const {
  return document_.project().grid.value_or(defaultGrid_);
}

bool ManualCalibration::setGrid(const QString& step, const ReferenceGrid& grid,
                                const std::string& mergeKey) {
  return document_
      .edit(
          step, [&](Project& project) { project.grid = grid; }, mergeKey)
      .has_value();
}

void ManualCalibration::setGridOpacity(double opacity) {
  gridOpacity_ = std::clamp(opacity, 0.0, 1.0);
  Q_EMIT changed();
}

void ManualCalibration::setEdgesShown(bool shown) {
  edges_ = shown;
  Q_EMIT changed();
}

void ManualCalibration::showEarlierCameras(std::optional<EarlierCameras> earlier) {
  earlier_ = earlier;
  Q_EMIT changed();
}

void ManualCalibration::setComparedCameras(EarlierCameras compared) {
  comparison_ = compared;
  Q_EMIT settingsChanged();
}

CameraRig ManualCalibration::currentCameras() const {
  CameraRig rig;
  for (const ProjectCamera& camera : document_.project().cameras) {
    rig.push_back(camera.camera);
  }
  return rig;
}

const CameraRig& ManualCalibration::camerasOf(EarlierCameras earlier) const {
  switch (earlier) {
  case EarlierCameras::LastChange:
    return beforeLastChange_;
  case EarlierCameras::WandRefinement:
    return beforeRefinement_;
  case EarlierCameras::PanelOpened:
    break;
  }
  return whenOpened_;
}

void ManualCalibration::storeEarlierCameras(EarlierCameras earlier) {
  CameraRig& stored = earlier == EarlierCameras::WandRefinement ? beforeRefinement_ : whenOpened_;
  stored = currentCameras();
  defaultGrid_ = referenceGridFor(stored);
}

void ManualCalibration::resetEarlier() {
  whenOpened_ = currentCameras();
  beforeRefinement_ = whenOpened_;
  beforeLastChange_ = whenOpened_;
  lastSeen_ = whenOpened_;
  historyIndex_ = document_.undoStack()->index();
  earlier_.reset();
  defaultGrid_ = referenceGridFor(whenOpened_);
}

void ManualCalibration::followHistory(int index) {
  CameraRig now = currentCameras();
  if (now == lastSeen_) {
    return; // another part of the project has changed
  }
  if (index != historyIndex_) { // else the last step goes on: a drag, a number that is typed
    beforeLastChange_ = std::move(lastSeen_);
    historyIndex_ = index;
  }
  lastSeen_ = std::move(now);
}

const std::vector<Eigen::Vector3d>& ManualCalibration::pins(int camera) const {
  static const std::vector<Eigen::Vector3d> kNone;
  const auto index = static_cast<std::size_t>(camera);
  return index < pins_.size() ? pins_[index] : kNone;
}

void ManualCalibration::togglePin(int camera, const Eigen::Vector2d& pixel, double reach) {
  const Camera seen = cameraInProject(camera);
  const Projector projector(seen);
  pins_.resize(std::max(pins_.size(), static_cast<std::size_t>(camera) + 1));
  auto& pins = pins_[static_cast<std::size_t>(camera)];
  const auto there = std::ranges::find_if(pins, [&](const Eigen::Vector3d& pin) {
    const auto at = projector.project(pin);
    return at && (*at - pixel).norm() < reach;
  });
  if (there != pins.end()) {
    pins.erase(there);
  } else if (pins.size() >= static_cast<std::size_t>(kMaxHeldPoints)) {
    Q_EMIT messageRequested(
        tr("At most three grid points can be held in place. To release one, click it"));
  } else if (const auto point = gridPointAt(seen, grid(), pixel, reach)) {
    pins.push_back(*point);
  }
  Q_EMIT changed();
}

bool ManualCalibration::hasGridCrossingNear(int camera, const Eigen::Vector2d& pixel,
                                            double reach) const {
  return geometry::gridCrossingAt(cameraInProject(camera), grid(), pixel, reach).has_value();
}

bool ManualCalibration::hasPins() const {
  return std::ranges::any_of(pins_, [](const auto& pins) { return !pins.empty(); });
}

void ManualCalibration::clearPins() {
  if (hasPins()) {
    pins_.clear();
    Q_EMIT changed();
  }
}

void ManualCalibration::beginDrag(int camera, const Eigen::Vector2d& pixel, double reach) {
  selectCamera(camera);
  const Camera start = cameraInProject(camera);
  const Projector projector(start);
  const auto point = gridPointAt(start, grid(), pixel, reach);
  const auto seen = point ? projector.project(*point) : std::nullopt;
  if (!seen) {
    return;
  }
  PointDrag drag{camera, start, *point, *seen - pixel, {}, {}};
  for (const Eigen::Vector3d& pin : pins(camera)) {
    if (const auto at = projector.project(pin); at && (pin - *point).norm() > 1e-9) {
      drag.fixedAnchors.push_back({pin, *at});
    }
  }
  drag_ = drag;
  document_.endStepMerging();
}

void ManualCalibration::dragTo(const Eigen::Vector2d& pixel) {
  if (!drag_) {
    return;
  }
  const DragResult result = dragPoint(drag_->cameraAtStart, drag_->fixedAnchors,
                                      {drag_->point, pixel + drag_->mouseOffset}, settings_);
  reportLimit(result);
  changeCamera(drag_->camera, tr("Drag the grid in %1").arg(nameOf(drag_->camera)), result.camera,
               "drag grid");
}

void ManualCalibration::reportLimit(const DragResult& result) {
  QString sentence;
  switch (result.limit) {
  case DragLimit::None:
    break;
  case DragLimit::OutOfSight:
    sentence = tr("Cannot move further: a grid point would leave the camera's field of view");
    break;
  case DragLimit::OneRay:
    sentence = tr("Cannot move further: this grid point and the held grid points lie on one line");
    break;
  case DragLimit::OutOfReach:
    sentence = tr("Cannot move further: no nearby camera pose keeps the held grid points in place");
    break;
  case DragLimit::Fixed:
    sentence = tr("Three held points fix the pose. Release one of them, or turn on “Also fit the "
                  "focal length when three points are held”");
    break;
  }
  if (sentence != drag_->lastRemark) {
    drag_->lastRemark = sentence;
    Q_EMIT messageRequested(sentence);
  }
}

void ManualCalibration::endDrag() {
  if (drag_) {
    drag_.reset();
    document_.endStepMerging();
    Q_EMIT changed();
  }
}

void ManualCalibration::cancelDrag() {
  if (drag_) {
    changeCamera(drag_->camera, tr("Drag the grid in %1").arg(nameOf(drag_->camera)),
                 drag_->cameraAtStart,
                 "drag grid"); // there and back is no step
    endDrag();
  }
}

std::optional<Eigen::Vector3d> ManualCalibration::draggedPoint() const {
  return drag_ ? std::optional(drag_->point) : std::nullopt;
}

void ManualCalibration::setDragSettings(const DragSettings& settings) {
  settings_ = settings;
  Q_EMIT settingsChanged();
}

void ManualCalibration::setKeyMode(KeyMode mode) {
  keyMode_ = mode;
  Q_EMIT settingsChanged();
}

void ManualCalibration::setNudgeFrame(NudgeFrame frame) {
  frame_ = frame;
  Q_EMIT settingsChanged();
}

double ManualCalibration::runningSum(const std::string& key, double amount, bool repeated) {
  if (!repeated || running_.mergeKey != key) {
    document_.endStepMerging();
    running_ = {key, 0.0};
  }
  running_.sum += amount;
  return running_.sum;
}

void ManualCalibration::nudge(int axis, double factor, bool repeated) {
  const bool moves = keyMode_ == KeyMode::Move;
  const bool own = frame_ == NudgeFrame::Camera;
  const Eigen::Vector3d way = own ? cameraAxis(axis) : Eigen::Vector3d::Unit(axis).eval();
  const double amount = factor * (moves ? kMoveStep : kTurnStep);
  const std::string key =
      fmt::format("nudge {} {} {} {} {}", camera(), moves, own, axis, factor > 0.0);
  const double sum = runningSum(key, amount, repeated);
  const QString movedNames[] = {tr("right"), tr("forward"), tr("up")};
  const QString turnedNames[] = {tr("pitch"), tr("roll"), tr("yaw")};
  const QString worldNames[] = {QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
  const QString name = own ? (moves ? movedNames[axis] : turnedNames[axis]) : worldNames[axis];
  const QString sumText = moves ? lengthText(sum, LengthScale::Centimeters, 1, NumberForm::Signed)
                                : angleText(sum, 2, NumberForm::Signed);
  const QString step = tr("%1 %2 %3").arg(nameOf(camera()), sumText, name);
  const Camera now = cameraInProject(camera());
  changeCamera(camera(), step,
               moves ? moved(now, amount * way, frame_) : rotated(now, amount * way, frame_), key);
}

void ManualCalibration::nudgeFocalLength(double percent, bool repeated) {
  const std::string key = fmt::format("nudge {} focal {}", camera(), percent > 0.0);
  const double sum = runningSum(key, percent, repeated);
  changeCamera(camera(),
               tr("%1: change focal length by %2 %")
                   .arg(nameOf(camera()), numberText(sum, 1, NumberForm::Signed)),
               zoomed(cameraInProject(camera()), 1.0 + percent / 100.0), key);
}

void ManualCalibration::changeCamera(int camera, const QString& step, const Camera& changed,
                                     const std::string& mergeKey) {
  if (camera < 0 || camera >= cameraCount()) {
    return;
  }
  (void)document_.edit(
      step,
      [&](Project& project) {
        setCalibration(project.cameras[static_cast<std::size_t>(camera)], changed);
      },
      mergeKey.empty() ? mergeKey : fmt::format("{} {}", mergeKey, camera));
}

void ManualCalibration::endStepMerging() {
  document_.endStepMerging();
}

} // namespace dewpoint::ui
