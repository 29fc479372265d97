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

/// "A person stands here": while it is placing, a click on somebody in a camera view, or on the
/// floor of the bird's-eye view, says where; by keys, the cross of the camera views does.
class AddPersonTool : public QObject {
  Q_OBJECT
public:
  /// `cameras`: what their images are called.
  AddPersonTool(BirdsEyeView* birdsEye, const CameraListModel& cameras, QObject* parent);

  /// Another camera view, which may go at any time.
  void attach(int camera, CameraView* view);
  /// `floor`: its height, world z in meters.
  void setPlacing(bool placing, double floor = 0.0);

Q_SIGNALS:
  void seen(int camera, const Eigen::Vector2d& pixel);
  void placed(const Eigen::Vector2d& place);
  void cancelled();

private:
  BirdsEyeView* birdsEye_;
  const CameraListModel& cameras_;
  std::vector<ImagePickOverlay*> layers_;
};

} // namespace dewpoint::ui
