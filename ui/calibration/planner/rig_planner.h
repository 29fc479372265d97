// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/planning/camera_placement.h"
#include "core/calibration/planning/rig_map.h"
#include "ui/jobs/background_job.h"
#include "ui/jobs/latest_job.h"
#include "ui/scene3d/map_look.h"

#include <QObject>
#include <QString>

#include <memory>
#include <optional>

namespace dewpoint::ui {

class Document;
class ManualCalibration;
class Selection;

/// Image size (pixels) and field of view of a planned camera.
struct PlannedLens {
  int imageWidth = 640;
  int imageHeight = 480;
  double horizontalFieldOfView = 1.0; ///< radians

  bool operator==(const PlannedLens&) const = default;
};

/// Plans a rig: computes how accurately the project cameras and the planned cameras measure
/// positions in a volume. Maps are recomputed in another thread after every camera change. Planned
/// cameras are part of neither the project nor the run.
class RigPlanner : public QObject {
  Q_OBJECT
public:
  RigPlanner(Document& document, ManualCalibration& manual, Selection& selection,
             QObject* parent = nullptr);
  ~RigPlanner() override;

  // Map of expected errors.
  bool isMapShown() const { return mapShown_; }
  void setMapShown(bool shown);
  /// Returns the newest map, or null before the first one.
  const std::shared_ptr<const RigMap>& map() const { return map_; }
  const MapOptions& mapOptions() const { return look_; }
  /// Sets the appearance of the map. The height of the map's layer is limited to the volume.
  void setMapOptions(const MapOptions& look);
  double pixelSigma() const { return pixelSigma_; }
  void setPixelSigma(double pixels);
  /// Returns the mapped volume in world coordinates (meters): the project's room, or the box set by
  /// the user.
  const Eigen::AlignedBox3d& volume() const { return volume_; }
  /// Sets the mapped volume. An empty or flat box is ignored.
  void setVolume(const Eigen::AlignedBox3d& volume);
  bool followsProjectVolume() const { return followsProjectVolume_; }
  void followProjectVolume();

  // Planned cameras.
  const CameraRig& plannedCameras() const { return planned_; }
  int selectedCamera() const; ///< index of the selected planned camera; -1 if none
  void selectCamera(int planned);
  /// Adds a camera in an upper corner of the volume, as far as possible from the other cameras, and
  /// selects it.
  void addCamera();
  void removeCamera(int planned);
  void changeCamera(int planned, const Camera& camera);
  const PlannedLens& lens() const { return lens_; }
  /// Sets the lens for the selected planned camera and for cameras added later.
  void setLens(const PlannedLens& lens);
  /// Returns the name for the next camera. Its number continues the numbering of the project
  /// cameras.
  QString nextCameraName() const;

  // Search for a position.
  double wallDistance() const { return wallDistance_; }
  void setWallDistance(double meters);
  /// Searches for the best position of an additional camera and adds the camera there.
  void findBestCameraPosition();
  BackgroundJob& positionSearchJob() { return search_; }

Q_SIGNALS:
  /// Emitted when a setting or a planned camera has changed.
  void changed();
  /// Emitted when the map or its appearance has changed.
  void mapChanged();
  /// Emitted with the result of a search, or the reason why it found nothing. The sentence is valid
  /// until the next change.
  void messageRequested(const QString& sentence);

private:
  CameraRig rig() const;
  void requestMap();
  void adoptProjectVolume();
  void adoptProjectLens();
  void limitHeight();
  void applyPlacement(const Result<PlacedCamera>& found);

  Document& document_;
  ManualCalibration& manual_;
  Selection& selection_;
  /// Input for computing a map. A request identical to the previous one is skipped.
  struct MapRequest {
    VolumeGrid grid;
    double pixelSigma = 0.5;
    CameraRig rig;

    bool operator==(const MapRequest&) const = default;
  };
  std::optional<MapRequest> lastRequest_;
  std::shared_ptr<RigMapper> mapper_; ///< computes the maps; used by one job at a time
  LatestJob mapping_{LatestJob::SupersededJob::Kept};
  BackgroundJob search_;
  std::shared_ptr<const RigMap> map_;
  MapOptions look_;
  bool mapShown_ = false;
  double pixelSigma_ = 0.5;
  double wallDistance_ = 0.0;
  Eigen::AlignedBox3d volume_{Eigen::Vector3d(-2, -2, 0), Eigen::Vector3d(2, 2, 2)};
  bool followsProjectVolume_ = true;
  CameraRig planned_;
  PlannedLens lens_;
};

} // namespace dewpoint::ui
