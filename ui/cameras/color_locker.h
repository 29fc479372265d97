// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/connected_cameras.h"
#include "ui/jobs/background_job.h"
#include "ui/workbench/workbench.h"

#include <QObject>
#include <QString>

#include <cstddef>
#include <string>
#include <vector>

namespace dewpoint::ui {

class CameraEdits;
class DeviceWatch;

/// Locks the colors of cameras: switches off their automatic exposure, gain and white balance, and
/// keeps the current values in the devices and in the project. If a color was learned while a
/// camera adjusts its colors automatically, a message offers to lock them, once for each project.
class ColorLocker : public QObject {
  Q_OBJECT
public:
  ColorLocker(const Workbench& bench, DeviceWatch& watch, CameraEdits& edits);

  /// Locks the colors of one camera, or of all cameras if `camera` is -1. Does nothing while
  /// isBusy() is true.
  void lockColors(int camera);
  bool isBusy() const { return job_->isRunning(); }

Q_SIGNALS:
  void busyChanged();
  /// Emitted before locked values are stored in the project, with the device's path and the former
  /// values of its controls, which an undo restores.
  void lockingStarted(const std::string& path, const std::vector<capture::DeviceControl>& before);
  /// Emitted with a sentence that tells which colors were locked and which were not.
  void completed(const QString& sentence);
  void failed(const QString& sentence);

private:
  /// Device of a camera of the project.
  struct ProjectDevice {
    int camera = 0;
    QString cameraName;
    std::string devicePath;
  };
  /// Returns the connected devices of one camera, or of all cameras if `camera` is -1.
  std::vector<ProjectDevice> devices(int camera) const;
  void considerOffer();
  void offer(const QString& cameras);

  Workbench bench_;
  DeviceWatch& watch_;
  CameraEdits& edits_;
  BackgroundJob* job_;
  BackgroundJob* question_; ///< asks the devices whether they adjust colors automatically
  std::size_t samples_ = 0; ///< number of color samples in the project
  bool offered_ = false;
};

} // namespace dewpoint::ui
