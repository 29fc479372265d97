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

/// What a camera that does not exist yet is like.
struct PlannedLens {
  int width = 640;
  int height = 480;
  double fieldOfView = 1.0; ///< horizontal, radians

  bool operator==(const PlannedLens&) const = default;
};

/// Planning a rig: how well the cameras of the project, and those that are thought of, see a
/// volume. Maps are made beside the window, and follow every change of a camera. Planned cameras
/// are no part of the project nor of the run.
class RigPlanner : public QObject {
  Q_OBJECT
public:
  RigPlanner(Document& document, ManualCalibration& hand, Selection& selection,
             QObject* parent = nullptr);
  ~RigPlanner() override;

  // The map.
  bool isMapShown() const { return mapShown_; }
  void setMapShown(bool shown);
  /// The newest map; null before there was one.
  const std::shared_ptr<const RigMap>& map() const { return map_; }
  const MapLook& look() const { return look_; }
  /// The height is kept within the volume.
  void setLook(const MapLook& look);
  double pixelSigma() const { return pixelSigma_; }
  void setPixelSigma(double pixels);
  /// What is mapped: the project's room, or as set.
  const Eigen::AlignedBox3d& volume() const { return volume_; }
  /// An empty or flat box changes nothing.
  void setVolume(const Eigen::AlignedBox3d& volume);
  bool followsRoom() const { return followsRoom_; }
  void followRoom();

  // Cameras that are thought of.
  const CameraRig& planned() const { return planned_; }
  int chosen() const; ///< the selected one of them; -1: none
  void choose(int planned);
  /// Adds one in an upper corner of the volume, as far as possible from the others, and chooses it.
  void add();
  void remove(int planned);
  void change(int planned, const Camera& camera);
  const PlannedLens& lens() const { return lens_; }
  /// Of the chosen one, and of those that are added.
  void setLens(const PlannedLens& lens);
  /// The number the next camera has, counted with those of the project.
  QString nextName() const;

  // The search for a position.
  double wallDistance() const { return wallDistance_; }
  void setWallDistance(double meters);
  /// Looks for the best position for one more camera, and adds it there.
  void findPlace();
  BackgroundJob& search() { return search_; }

Q_SIGNALS:
  /// Something that is set or planned changed.
  void changed();
  /// Another map, or it is drawn otherwise.
  void mapChanged();
  /// What was found, or why nothing was; stays true until something changes.
  void messageRequested(const QString& sentence);

private:
  CameraRig rig() const;
  void ask();
  void takeRoom();
  void takeLens();
  void keepHeight();
  void takePlacement(const Result<Placement>& found);

  Document& document_;
  ManualCalibration& hand_;
  Selection& selection_;
  /// What a map is made of: an order like the one before it is left out.
  struct MapOrder {
    VolumeGrid grid;
    double pixelSigma = 0.5;
    CameraRig rig;

    bool operator==(const MapOrder&) const = default;
  };
  std::optional<MapOrder> lastOrder_;
  std::shared_ptr<RigMapper> mapper_; ///< used by one job after the other
  LatestJob mapping_{LatestJob::Overtaken::Kept};
  BackgroundJob search_;
  std::shared_ptr<const RigMap> map_;
  MapLook look_;
  bool mapShown_ = false;
  double pixelSigma_ = 0.5;
  double wallDistance_ = 0.0;
  Eigen::AlignedBox3d volume_{Eigen::Vector3d(-2, -2, 0), Eigen::Vector3d(2, 2, 2)};
  bool followsRoom_ = true;
  CameraRig planned_;
  PlannedLens lens_;
};

} // namespace dewpoint::ui
