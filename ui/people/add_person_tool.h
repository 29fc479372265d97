// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>
#include <QObject>

#include <vector>

namespace dewpoint::ui {

class BirdsEyeView;
class CameraListModel;
class CameraView;
class ImagePickOverlay;

/// Tool "A person stands here", with which the user adds a person that was not found. While the
/// tool is active, the user clicks the person in a camera view or the floor in the bird's-eye view,
/// or uses the keyboard cross of the camera views.
class AddPersonTool : public QObject {
  Q_OBJECT
public:
  /// Creates the tool. `cameras` provides the names of the cameras.
  AddPersonTool(BirdsEyeView* birdsEye, const CameraListModel& cameras, QObject* parent);

  /// Adds a camera view, which may be deleted at any time.
  void attachView(int camera, CameraView* view);
  /// Starts or stops the tool. `floor` is the floor height, world z in meters.
  void setPersonPlacingMode(bool placing, double floor = 0.0);

Q_SIGNALS:
  void personClicked(int camera, const Eigen::Vector2d& pixel);
  void floorClicked(const Eigen::Vector2d& place);
  void canceled();

private:
  BirdsEyeView* birdsEye_;
  const CameraListModel& cameras_;
  std::vector<ImagePickOverlay*> layers_;
};

} // namespace dewpoint::ui
