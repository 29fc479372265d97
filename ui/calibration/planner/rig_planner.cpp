// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/planner/rig_planner.h"

#include "core/calibration/manual/interactive_pose.h"
#include "core/geometry/camera_name.h"
#include "core/session/run/tracking_run.h"
#include "ui/calibration/manual_calibration.h"
#include "ui/document/document.h"
#include "ui/selection/selection.h"
#include "ui/text/camera_names.h"
#include "ui/text/error_sentence.h"
#include "ui/text/quantity_text.h"

#include <algorithm>
#include <utility>

namespace dewpoint::ui {
namespace {

Camera withLens(const Camera& camera, const PlannedLens& lens) {
  Camera changed =
      idealCamera(camera.name, lens.imageWidth, lens.imageHeight, lens.horizontalFieldOfView);
  changed.cameraFromWorld = camera.cameraFromWorld;
  return changed;
}

} // namespace

RigPlanner::RigPlanner(Document& document, ManualCalibration& manual, Selection& selection,
                       QObject* parent)
    : QObject(parent), document_(document), manual_(manual), selection_(selection),
      mapper_(std::make_shared<RigMapper>()) {
  connect(&document_, &Document::projectReplaced, this, [this] {
    search_.cancel();
    planned_.clear();
    selection_.selectPlannedCamera(-1);
    followsProjectVolume_ = true;
    adoptProjectVolume();
    adoptProjectLens();
    Q_EMIT changed();
  });
  connect(&document_, &Document::changed, this, [this](const ProjectChanges& changes) {
    // Not with every pose: a volume that grows with a camera in the hand is hard to read.
    if (changes.gridChanged || changes.sourcesChanged) {
      adoptProjectVolume();
    }
  });
  connect(&manual_, &ManualCalibration::activeChanged, this, [this] {
    adoptProjectVolume();
    Q_EMIT mapChanged();
    Q_EMIT changed();
  });
  connect(&manual_, &ManualCalibration::changed, this, &RigPlanner::requestMap);
  connect(&selection_, &Selection::plannedCameraSelected, this, &RigPlanner::changed);
}

RigPlanner::~RigPlanner() = default;

CameraRig RigPlanner::rig() const {
  CameraRig rig = rigOf(document_.project());
  rig.insert(rig.end(), planned_.begin(), planned_.end());
  return rig;
}

void RigPlanner::requestMap() {
  if (!mapShown_ || !manual_.isActive()) {
    return;
  }
  const MapRequest order{gridOver(volume_, kMapCells), pixelSigma_, rig()};
  if (lastRequest_ == order) {
    return;
  }
  lastRequest_ = order;
  mapping_.start([this, order, mapper = mapper_](const BackgroundJob::Progress&) {
    auto map = std::make_shared<const RigMap>(mapper->map(order.grid, order.pixelSigma, order.rig));
    return [this, map] {
      map_ = map;
      Q_EMIT mapChanged();
    };
  });
}

void RigPlanner::setMapShown(bool shown) {
  if (shown != mapShown_) {
    mapShown_ = shown;
    requestMap();
    Q_EMIT mapChanged();
    Q_EMIT changed();
  }
}

void RigPlanner::limitHeight() {
  look_.layerHeight = std::clamp(look_.layerHeight, volume_.min().z(), volume_.max().z());
}

void RigPlanner::setMapOptions(const MapOptions& look) {
  if (look != look_) {
    look_ = look;
    limitHeight();
    Q_EMIT mapChanged();
    Q_EMIT changed();
  }
}

void RigPlanner::setPixelSigma(double pixels) {
  pixelSigma_ = pixels;
  requestMap();
  Q_EMIT changed();
}

void RigPlanner::setVolume(const Eigen::AlignedBox3d& volume) {
  if (!volume.isEmpty() && volume.sizes().minCoeff() > 0.0) {
    volume_ = volume;
    followsProjectVolume_ = false;
    limitHeight();
    requestMap();
  }
  Q_EMIT changed(); // also when it was refused
}

void RigPlanner::followProjectVolume() {
  followsProjectVolume_ = true;
  adoptProjectVolume();
  Q_EMIT changed();
}

void RigPlanner::adoptProjectVolume() {
  const Eigen::AlignedBox3d room = roomVolume(rigOf(document_.project()), manual_.grid());
  if (followsProjectVolume_ && !room.isEmpty() && room.sizes().minCoeff() > 0.0) {
    volume_ = room;
    limitHeight();
    requestMap();
  }
}

void RigPlanner::adoptProjectLens() {
  const auto& cameras = document_.project().cameras;
  if (!cameras.empty() && cameras.front().camera.intrinsics.width > 0) {
    const Camera& like = cameras.front().camera;
    lens_ = {like.intrinsics.width, like.intrinsics.height,
             std::clamp(fieldOfView(like), 0.1, 2.9)};
  }
}

int RigPlanner::selectedCamera() const {
  return std::min(selection_.plannedCamera(), int(planned_.size()) - 1);
}

void RigPlanner::selectCamera(int planned) {
  if (planned < int(planned_.size())) {
    selection_.selectPlannedCamera(std::max(planned, -1));
  }
}

QString RigPlanner::nextCameraName() const {
  return QString::fromStdString(
      unusedCameraName(rig(), document_.project().cameras.size(), [](std::size_t number) {
        return cameraName(std::string(), number).toStdString();
      }));
}

void RigPlanner::addCamera() {
  Camera camera = withLens({}, lens_);
  camera.name = nextCameraName().toStdString();
  planned_.push_back(placedInFarthestCorner(camera, rig(), volume_));
  selectCamera(int(planned_.size()) - 1);
  requestMap();
  Q_EMIT messageRequested({});
  Q_EMIT changed();
}

void RigPlanner::removeCamera(int planned) {
  if (planned >= 0 && planned < int(planned_.size())) {
    planned_.erase(planned_.begin() + planned);
    selectCamera(selectedCamera());
    requestMap();
    Q_EMIT messageRequested({});
    Q_EMIT changed();
  }
}

void RigPlanner::changeCamera(int planned, const Camera& camera) {
  if (planned >= 0 && planned < int(planned_.size())) {
    const bool moved = planned_[std::size_t(planned)] != camera;
    planned_[std::size_t(planned)] = camera;
    requestMap();
    if (moved) {
      Q_EMIT messageRequested({}); // it was about another place
    }
    Q_EMIT changed();
  }
}

void RigPlanner::setLens(const PlannedLens& lens) {
  lens_ = lens;
  if (const int planned = selectedCamera(); planned >= 0) {
    changeCamera(planned, withLens(planned_[std::size_t(planned)], lens_));
  } else {
    Q_EMIT changed();
  }
}

void RigPlanner::setWallDistance(double meters) {
  wallDistance_ = meters;
  Q_EMIT changed();
}

void RigPlanner::findBestCameraPosition() {
  Camera lens = withLens({}, lens_);
  lens.name = nextCameraName().toStdString();
  PlacementSettings settings;
  settings.volume = volume_;
  settings.wallDistance = wallDistance_;
  settings.pixelSigma = pixelSigma_;
  settings.maxGoodSigma = look_.maxGoodSigma;
  settings.reportedCellCount = kMapCells;
  search_.start([this, lens, settings, rig = rig()](const BackgroundJob::Progress& progress) {
    const auto found = placeCamera(rig, lens, settings,
                                   [&](CalibrationStage, double part) { return progress(part); });
    return [this, found] { applyPlacement(found); };
  });
  Q_EMIT messageRequested({});
}

void RigPlanner::applyPlacement(const Result<PlacedCamera>& found) {
  if (!found) {
    Q_EMIT messageRequested(errorText(found.error()));
    return;
  }
  planned_.push_back(found->camera);
  selectCamera(int(planned_.size()) - 1);
  requestMap();
  Q_EMIT changed();
  const Eigen::Vector3d place = found->camera.center();
  Q_EMIT messageRequested(
      tr("With %1 at x %2, y %3, z %4, the error is at most %6 in %5 of the volume (in %7 without "
         "this camera).")
          .arg(QString::fromStdString(found->camera.name),
               lengthNumber(place.x(), LengthScale::Meters, 2),
               lengthNumber(place.y(), LengthScale::Meters, 2),
               lengthText(place.z(), LengthScale::Meters, 2),
               percentText(found->goodVolumeFractionAfter),
               lengthText(look_.maxGoodSigma, LengthForm::Short),
               percentText(found->goodVolumeFractionBefore)));
}

} // namespace dewpoint::ui
