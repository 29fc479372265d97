// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <functional>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace dewpoint {

class Document;
struct Project;
struct ProjectCamera;

/// The cameras: name, where the images come from, how they are turned, and what is known of their
/// calibration.
class CameraPanel : public QWidget {
  Q_OBJECT
public:
  explicit CameraPanel(Document& document, QWidget* parent = nullptr);

  void choose(int camera);

Q_SIGNALS:
  void cameraChosen(int camera);
  /// A calibration file is to be read for all cameras.
  void calibrationWanted(const QString& file);

private:
  void say();
  void refresh();
  void showChosen();
  void showCalibration(const ProjectCamera& camera);
  void edit(const QString& step, const std::function<void(ProjectCamera&)>& change);
  void relocate();

  Document& document_;
  QListWidget* list_;
  QLabel* nameLabel_;
  QLineEdit* name_;
  QLabel* sourceLabel_;
  QLineEdit* source_;
  QPushButton* browse_;
  QLabel* turnLabel_;
  QComboBox* turn_;
  QCheckBox* mirror_;
  QLabel* calibration_;
  QPushButton* load_;
};

} // namespace dewpoint
