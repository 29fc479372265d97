// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

#include <functional>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace dewpoint::setup {
struct WandSettings;
} // namespace dewpoint::setup

namespace dewpoint::ui {

class WandCalibrator;

/// Fields for the wand type, the source of the scale, and the parameters to refine.
class WandForm : public QWidget {
  Q_OBJECT
public:
  explicit WandForm(WandCalibrator& calibrator, QWidget* parent = nullptr);

private:
  void createWidgets();
  void connectFields();
  void retranslateUi();
  void refresh();
  void edit(const std::function<void(WandSettings&)>& change);
  void chooseBalls();
  void fillSizes();

  WandCalibrator& calibrator_;
  QLabel* kindLabel_;
  QComboBox* kind_;
  QLabel* ballLabel_;
  QComboBox* ball_;
  QLabel* otherLabel_;
  QComboBox* other_;
  QLabel* lengthLabel_;
  QDoubleSpinBox* length_;
  QLabel* sizeLabel_;
  QComboBox* size_;
  QLabel* distanceLabel_;
  QDoubleSpinBox* distance_;
  QLabel* initialErrorLabel_;
  QDoubleSpinBox* initialPositionError_;
  QDoubleSpinBox* initialRotationError_;
  QCheckBox* offsets_;
  QCheckBox* focal_;
  QCheckBox* distortion_;
  QCheckBox* onlyRange_;
};

} // namespace dewpoint::ui
