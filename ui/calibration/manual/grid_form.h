// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/reference_grid.h"

#include <QWidget>

#include <array>
#include <functional>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSlider;

namespace dewpoint::ui {

class ManualCalibration;

/// Fields for the reference grid and its appearance over the images.
class GridForm : public QWidget {
  Q_OBJECT
public:
  explicit GridForm(ManualCalibration& manual, QWidget* parent = nullptr);

private:
  void createWidgets();
  void connectFields();
  void retranslateUi();
  void refresh();
  void edit(const std::function<void(ReferenceGrid&)>& change, const char* key);

  ManualCalibration& manual_;
  QLabel* kindLabel_;
  QComboBox* kind_;
  QLabel* sizeLabel_;
  std::array<QDoubleSpinBox*, 3> size_;
  QLabel* originLabel_;
  std::array<QDoubleSpinBox*, 3> origin_;
  QLabel* stepLabel_;
  QDoubleSpinBox* step_;
  QDoubleSpinBox* rotation_;
  QLabel* opacityLabel_;
  QSlider* opacity_;
  QCheckBox* edges_;
  QPushButton* flip_;
  QLabel* compareLabel_;
  QComboBox* compare_;
};

} // namespace dewpoint::ui
