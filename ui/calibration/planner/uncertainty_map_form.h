// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

#include <array>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSlider;

namespace dewpoint::ui {

class RigPlanner;

/// Fields for the map of expected errors: quantity, volume, and a one-line summary.
class UncertaintyMapForm : public QWidget {
  Q_OBJECT
public:
  explicit UncertaintyMapForm(RigPlanner& plan, QWidget* parent = nullptr);

private:
  void createWidgets();
  void connectFields();
  void connectVolume();
  void retranslateUi();
  void refresh();
  void summarize();

  RigPlanner& plan_;
  QCheckBox* shown_;
  QLabel* summary_;
  QLabel* quantityLabel_;
  QComboBox* quantity_;
  QLabel* goodLabel_;
  QDoubleSpinBox* good_;
  QLabel* pixelLabel_;
  QDoubleSpinBox* pixel_;
  QCheckBox* slice_;
  QSlider* heightSlider_;
  QDoubleSpinBox* height_;
  QCheckBox* volume_;
  QLabel* lowLabel_;
  QLabel* highLabel_;
  std::array<QDoubleSpinBox*, 3> low_;
  std::array<QDoubleSpinBox*, 3> high_;
  QPushButton* room_;
};

} // namespace dewpoint::ui
