// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"

#include <QWidget>

#include <functional>
#include <vector>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QListView;
class QPushButton;

namespace dewpoint::project {
struct Project;
struct ProjectCamera;
} // namespace dewpoint::project

namespace dewpoint::ui {

class BackgroundImageTaker;
class CameraListModel;
class DelayEstimate;
class Document;
class Selection;

/// Panel of the cameras: name, image source, image rotation, and what is known about the
/// calibration.
class CameraPanel : public QWidget {
  Q_OBJECT
public:
  CameraPanel(Document& document, Selection& selection, CameraListModel& cameras,
              QWidget* parent = nullptr);

  /// Sets the snapshot shown, from whose images a background image can be taken.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  BackgroundImageTaker& backgroundImageTaker() { return *taker_; }

Q_SIGNALS:
  /// Emitted when the user wants to import a calibration.
  void calibrationImportRequested();

private:
  void retranslateUi();
  void refresh();
  /// Returns the index of the selected camera, or -1 without cameras.
  int chosen() const;
  void showChosen();
  void showCalibration(const ProjectCamera& camera);
  void edit(const QString& step, const std::function<void(ProjectCamera&)>& change);
  /// Sets how the images of the selected camera are rotated and mirrored.
  void orient(const QString& step, int rotateDegrees, bool mirrored);
  void relocate();
  void chooseBackgroundImage();
  void setBackgroundImage(const QString& file);
  void updateTakeButton();
  void showDelayEstimate();
  void makeFields();
  void connectFields();

  Document& document_;
  Selection& selection_;
  CameraListModel& cameras_;
  QListView* list_;
  QLabel* nameLabel_;
  QLineEdit* name_;
  QLabel* sourceLabel_;
  QLineEdit* source_;
  QPushButton* browse_;
  QLabel* backgroundImageLabel_;
  QLineEdit* backgroundImage_;
  QPushButton* backgroundImageBrowse_;
  QPushButton* backgroundImageTake_;
  QLabel* rotationLabel_;
  QComboBox* rotation_;
  QCheckBox* mirror_;
  QLabel* delayLabel_;
  QDoubleSpinBox* delay_;
  DelayEstimate* delayEstimate_;
  QLabel* calibration_;
  QPushButton* load_;
  BackgroundImageTaker* taker_;
  std::vector<ClockEstimate> clocks_; ///< from the last snapshot
};

} // namespace dewpoint::ui
