// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/connected_cameras.h"
#include "ui/cameras/camera_parts.h"
#include "ui/jobs/latest_job.h"
#include "ui/workbench/workbench.h"

#include <QWidget>

#include <optional>
#include <string>
#include <vector>

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QListView;
class QPushButton;
class QScrollArea;

namespace dewpoint::ui {

class CameraIconModel;
class ControlForm;
class CropForm;
class ExposureView;
class FormatChoice;

/// Part of the dialog *Cameras* with the cameras of the project: a list with their newest images,
/// and the settings of the selected camera. The selection is shared with the whole window.
class ProjectPane : public QWidget {
  Q_OBJECT
public:
  ProjectPane(const Workbench& bench, const CameraParts& parts, QWidget* parent = nullptr);

  /// Returns the index of the selected camera, or -1 without cameras.
  int camera() const;
  /// Sets the snapshot that showImages() shows from now on; null: nothing.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// Shows the image of each camera in the snapshot, and the exposure of its targets. Call it
  /// regularly, but not for each snapshot: both take long.
  void showImages();

private:
  void arrange();
  void connectParts();
  void retranslateUi();
  void refresh();
  void refreshNotes();
  /// Reads the controls of the selected camera's device again, in another thread.
  void readControls();
  void showControls();
  void fillExchange();
  /// Returns the index of the selected camera's device among the connected ones.
  std::optional<std::size_t> device() const;

  Workbench bench_;
  CameraParts parts_;
  CameraIconModel* icons_;
  QLabel* title_;
  QListView* list_;
  QPushButton* remove_;
  QPushButton* exchange_;
  QLabel* nameLabel_;
  QLineEdit* name_;
  QLabel* source_;
  QLabel* rotationLabel_;
  QComboBox* rotation_;
  QCheckBox* mirror_;
  QLabel* cropLabel_;
  CropForm* crop_;
  QLabel* notes_;
  ExposureView* exposure_;
  QWidget* deviceBox_;
  FormatChoice* format_;
  ControlForm* controls_;
  QScrollArea* controlArea_;
  QLabel* controlNote_;
  QPushButton* lock_;
  QPushButton* lockAll_;
  TrackSnapshotPtr snapshot_;                   ///< without the last images of delayed cameras
  std::string path_;                            ///< of the device whose controls are shown
  std::vector<capture::DeviceControl> present_; ///< its controls as they were read last
  LatestJob job_{LatestJob::SupersededJob::Kept};
};

} // namespace dewpoint::ui
