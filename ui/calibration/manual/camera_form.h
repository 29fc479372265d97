// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"

#include <QWidget>

#include <array>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace dewpoint::ui {

class ManualCalibration;

/// Fields for the selected camera: position in meters or centimeters; orientation as a target point
/// plus roll, or as yaw, pitch and roll; focal length or field of view. Also lets the user choose
/// what the mouse and keys change.
class CameraForm : public QWidget {
  Q_OBJECT
public:
  explicit CameraForm(ManualCalibration& manual, QWidget* parent = nullptr);

private:
  void createWidgets();
  void connectFields();
  void retranslateUi();
  void refresh();
  void showUnits();
  void editPosition(int axis, double value);
  void editAim(int field, double value);
  void editLens(double value);
  double metersPerUnit() const;
  bool looksAtPoint() const;
  bool showsFieldOfView() const;
  void change(const QString& what, const QString& value, const Camera& camera, const char* key);

  ManualCalibration& manual_;
  QLabel* cameraLabel_;
  QComboBox* camera_;
  QLabel* positionLabel_;
  QComboBox* unit_;
  std::array<QDoubleSpinBox*, 3> position_;
  QLabel* aimLabel_;
  QComboBox* aimMode_;
  std::array<QDoubleSpinBox*, 4> aim_; ///< x, y, z of the point, roll; or yaw, pitch, unused, roll
  QLabel* lensLabel_;
  QComboBox* lensMode_;
  QDoubleSpinBox* lens_;
  QLabel* dragLabel_;
  QComboBox* dragMode_;
  QCheckBox* fitFocal_;
  QLabel* keysLabel_;
  QComboBox* keyMode_;
  QComboBox* keyFrame_;
};

} // namespace dewpoint::ui
