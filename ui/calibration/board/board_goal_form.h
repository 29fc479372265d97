// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

#include <functional>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace dewpoint::setup {
struct BoardGuideRequest;
} // namespace dewpoint::setup

namespace dewpoint::ui {

class BoardCalibrator;

/// Fields for the goal of a board calibration: intrinsics, poses or both; the lens model; the
/// requested accuracy; and whether the board lies on the floor in one frame of the recording.
class BoardGoalForm : public QWidget {
  Q_OBJECT
public:
  explicit BoardGoalForm(BoardCalibrator& calibrator, QWidget* parent = nullptr);

private:
  void createWidgets();
  void connectFields();
  void retranslateUi();
  void refresh();
  void edit(const std::function<void(BoardGuideRequest&)>& change);

  BoardCalibrator& calibrator_;
  QLabel* goalLabel_;
  QComboBox* goal_;
  QLabel* modelLabel_;
  QComboBox* model_;
  QCheckBox* floor_;
  QSpinBox* floorFrame_;
  QPushButton* floorHere_;
  QLabel* accuracyLabel_;
  QDoubleSpinBox* lensAccuracy_;
  QDoubleSpinBox* positionAccuracy_;
};

} // namespace dewpoint::ui
