// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/world_step.h"

#include <QWidget>

#include <array>
#include <utility>
#include <vector>

class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace dewpoint::ui {

class BoardFloor;
class CameraListModel;
class WorldMarks;

/// Page "Floor" of the calibration panel: sets the floor, the origin, the axes and the scale of
/// calibrated cameras from points marked in the images or from a board on the floor, and moves all
/// cameras together.
class WorldPage : public QWidget {
  Q_OBJECT
public:
  WorldPage(WorldMarks& marks, BoardFloor& boardFloor, const CameraListModel& cameras,
            QWidget* parent = nullptr);

private:
  enum Column { Point, Seen, X, Y, Z, Accuracy, ColumnCount };

  void build();
  QWidget* makeMove();
  void connectFields();
  void retranslateUi();
  void refresh();
  void fillRow(int mark);

  WorldMarks& marks_;
  BoardFloor& boardFloor_;
  const CameraListModel& cameras_;
  QLabel* guide_;
  QLabel* uprightText_;
  QLabel* marksTitle_;
  QTableWidget* table_;
  QPushButton* mark_;
  QPushButton* clear_;
  QLabel* worldTitle_;
  QLabel* resultText_;
  QLabel* distanceLabel_;
  QDoubleSpinBox* distance_;
  QPushButton* check_;
  QPushButton* board_;
  QLabel* boardText_;
  QLabel* moveTitle_;
  std::array<QDoubleSpinBox*, 3> shift_;
  QDoubleSpinBox* turn_;
  QPushButton* move_;
  QLabel* quarterLabel_;
  std::array<QPushButton*, 3> quarters_;
  /// Buttons of the steps.
  std::vector<std::pair<WorldStep, QPushButton*>> steps_;
  bool filling_ = false;
  /// the user entered the distance; otherwise it is computed from the marks
  bool distanceEntered_ = false;
};

} // namespace dewpoint::ui
