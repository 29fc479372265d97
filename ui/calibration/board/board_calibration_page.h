// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace dewpoint::ui {

class BoardCalibrator;
class BoardForm;
class BoardLive;

/// Calibration dock page for calibrating with a printed board.
class BoardCalibrationPage : public QWidget {
  Q_OBJECT
public:
  explicit BoardCalibrationPage(BoardCalibrator& calibrator, QWidget* parent = nullptr);

  /// Asks the user for a file and writes the board to it as PDF.
  void print();

private:
  void createWidgets();
  void retranslateUi();
  void refresh();
  void showProgress(double part);
  void showResult();
  void chooseReportFile();

  BoardCalibrator& calibrator_;
  QLabel* guide_;
  QLabel* boardTitle_;
  BoardForm* fields_;
  QPushButton* find_;
  QLabel* goalTitle_;
  QLabel* runTitle_;
  QPushButton* calibrate_;
  QPushButton* cancel_;
  QProgressBar* progress_;
  BoardLive* live_;
  QLabel* result_;
  QPushButton* apply_;
  QPushButton* report_;
};

} // namespace dewpoint::ui
