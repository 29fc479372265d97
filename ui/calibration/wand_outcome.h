// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace dewpoint {

class WandDesk;

/// The button that refines, how far it is, and what came of it: verdict, faults, each camera.
class WandOutcome : public QWidget {
  Q_OBJECT
public:
  explicit WandOutcome(WandDesk& desk, QWidget* parent = nullptr);

private:
  void build();
  void connectParts();
  void say();
  void refresh();
  void showOutcome();
  void fillTable();
  void showProgress(double part);
  void chooseReport();

  WandDesk& desk_;
  QLabel* missing_;
  QPushButton* refine_;
  QProgressBar* progress_;
  QPushButton* cancel_;
  QLabel* verdict_;
  QLabel* notes_;
  QTableWidget* table_;
  QPushButton* flip_;
  QPushButton* apply_;
  QPushButton* report_;
};

} // namespace dewpoint
