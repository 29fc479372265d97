// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/calibration_guide.h"

#include <QWidget>

#include <array>

class QButtonGroup;
class QLabel;
class QPushButton;
class QRadioButton;
class QTableWidget;

namespace dewpoint::ui {

class CalibrationGuide;
class CameraListModel;

/// First page of the calibration panel. It shows what is known about each camera's calibration, the
/// ways (procedures) to calibrate, and the current step of the chosen way.
class GuidePage : public QWidget {
  Q_OBJECT
public:
  GuidePage(CalibrationGuide& guide, const CameraListModel& cameras, QWidget* parent = nullptr);

private:
  static constexpr int kWays = 5;
  enum Column { Name, Lens, Position, Delay, ColumnCount };

  void build();
  QWidget* makeSteps();
  void connectFields();
  void retranslateUi();
  void refresh();
  void refreshTable();
  void refreshStep();

  CalibrationGuide& guide_;
  const CameraListModel& cameras_;
  QLabel* knownTitle_;
  QTableWidget* table_;
  QLabel* world_;
  QLabel* waysTitle_;
  QButtonGroup* group_;
  std::array<QRadioButton*, kWays> ways_{};
  QWidget* choices_;
  QLabel* needs_;
  QPushButton* other_;
  QWidget* steps_;
  QLabel* stepTitle_;
  QLabel* how_;
  QLabel* reached_;
  QPushButton* open_;
  QPushButton* back_;
  QPushButton* next_;
  bool choosing_ = false; ///< the user wants to choose another way
};

} // namespace dewpoint::ui
