// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/new_project/project_cameras.h"
#include "ui/cameras/camera_parts.h"
#include "ui/workbench/workbench.h"

#include <QWidget>

#include <functional>
#include <optional>

class QLabel;
class QListWidget;
class QPushButton;

namespace dewpoint::ui {

class AddressForm;
class PreviewStreams;

/// Part of the dialog *Cameras* with the sources that can be added: connected devices, each with a
/// live image, network addresses, and recordings. A device that the project already uses shows the
/// newest image of its camera.
class SourcePane : public QWidget {
  Q_OBJECT
public:
  /// Creates the pane. `selected` returns the index of the selected camera of the project, or -1.
  SourcePane(const Workbench& bench, const CameraParts& parts, std::function<int()> selected,
             QWidget* parent = nullptr);

  /// Sets whether the devices are opened to show live images.
  void setPreviewing(bool previewing);
  /// Sets the snapshot that showImages() shows from now on, in which delayed cameras keep their
  /// last image; null: nothing.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// Shows the images of the snapshot at the devices that the project uses. Call it regularly, but
  /// not for each snapshot, because this takes long.
  void showImages();

private:
  void arrange();
  void connectParts();
  void retranslateUi();
  /// Shows the devices, and what can be done with them.
  void refresh();
  void refreshRow(int row);
  void updateButtons();
  void updatePreviews();
  void addDevice();
  void useDevice();
  void addVideos();
  void addFolder();
  /// Returns the project's camera that uses a device, or nothing.
  std::optional<int> userOf(int device) const;
  /// Returns why sources of this kind cannot be added to the project; empty if they can.
  QString obstacle(SourceKind kind) const;

  Workbench bench_;
  CameraParts parts_;
  std::function<int()> selected_;
  PreviewStreams* previews_;
  bool previewing_ = false;
  TrackSnapshotPtr snapshot_;
  QLabel* title_;
  QListWidget* list_;
  QLabel* empty_;
  QPushButton* add_;
  QPushButton* use_;
  QLabel* addressTitle_;
  AddressForm* address_;
  QLabel* recordingTitle_;
  QPushButton* videos_;
  QPushButton* folder_;
  QLabel* note_;
};

} // namespace dewpoint::ui
