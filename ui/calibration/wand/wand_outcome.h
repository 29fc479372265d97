// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace dewpoint::ui {

class WandCalibrator;

/// Shows the button that starts the refinement, its progress, and its result: quality, faults, and
/// details for each camera.
class WandOutcome : public QWidget {
  Q_OBJECT
public:
  explicit WandOutcome(WandCalibrator& calibrator, QWidget* parent = nullptr);

private:
  void createWidgets();
  void connectParts();
  void retranslateUi();
  void refresh();
  void showOutcome();
  void fillTable();
  void showProgress(double part);
  void chooseReport();

  WandCalibrator& calibrator_;
  QLabel* missing_;
  QPushButton* refine_;
  QProgressBar* progress_;
  QPushButton* cancel_;
  QLabel* accuracy_;
  QLabel* notes_;
  QTableWidget* table_;
  QPushButton* flip_;
  QPushButton* apply_;
  QPushButton* report_;
};

} // namespace dewpoint::ui
