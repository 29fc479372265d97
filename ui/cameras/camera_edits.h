// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/connected_cameras.h"
#include "core/setup/new_project/project_cameras.h"
#include "ui/jobs/job_queue.h"

#include <QObject>
#include <QSize>
#include <QString>
#include <QStringList>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace dewpoint::ui {

class Document;

/// Changes the cameras of the open project in undoable steps. A source is examined in another
/// thread before it is added. If this fails, the project stays unchanged, and `failed()` is
/// emitted.
class CameraEdits : public QObject {
  Q_OBJECT
public:
  explicit CameraEdits(Document& document, QObject* parent = nullptr);

  /// Adds one camera for each location: a video, an image folder, or an address. `size` is the size
  /// of the images in pixels; empty if unknown.
  void addLocations(const QStringList& locations, const QSize& size = {});
  /// Adds one camera for each source, without examining the sources.
  void add(const std::vector<CameraSource>& sources);
  void remove(int camera);
  /// Replaces the source of a camera.
  void replace(int camera, const CameraSource& source);
  /// Examines a location (a video, an image folder or an address), and makes it the source of a
  /// camera.
  void replaceByLocation(int camera, const QString& location);
  /// Swaps the sources of two cameras.
  void swapSources(int camera, int other);
  void rename(int camera, const QString& name);
  /// Sets how the images of a camera are rotated (clockwise, degrees) and mirrored. The calibration
  /// is converted.
  void setOrientation(int camera, int rotateDegrees, bool mirrored);
  /// Sets the margins that are cut off from the images of a camera. The calibration is converted.
  void crop(int camera, const ImageMargins& margins);
  /// Sets the formats that are requested from the devices of cameras, by camera index.
  void setFormats(const std::map<int, capture::DeviceFormat>& formats);
  /// Sets a control of a camera's device, such as its exposure. Successive changes of the same
  /// control, for example while a slider is dragged, are one step.
  void setControl(int camera, const std::string& name, std::int64_t value);
  /// Stores the control values that lock the colors of cameras, by camera index.
  void lockColors(const std::map<int, capture::ControlValues>& values);
  bool isBusy() const { return pending_ > 0; }

Q_SIGNALS:
  void failed(const QString& sentence);
  /// Emitted when the examination of sources begins or ends.
  void busyChanged(bool busy);

private:
  using Sources = std::vector<CameraSource>;
  /// Examines locations in another thread, then calls `use` in this one, unless another project has
  /// been opened or one of them cannot be used.
  void examine(const QStringList& locations, std::function<void(Sources)> use);
  void edit(const QString& step, const std::function<Status(Project&)>& change);
  void setPending(int pending);

  Document& document_;
  JobQueue jobs_;
  int pending_ = 0;
  int projects_ = 0; ///< counts the projects that have been opened
};

} // namespace dewpoint::ui
