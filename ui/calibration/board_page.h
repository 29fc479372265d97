// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace dewpoint {

class BoardDesk;
class BoardFields;
class BoardLive;

/// The page of the calibration place for calibrating with a printed board.
class BoardPage : public QWidget {
  Q_OBJECT
public:
  explicit BoardPage(BoardDesk& desk, QWidget* parent = nullptr);

  /// Asks for a file and writes the board as a PDF.
  void print();

private:
  void build();
  void say();
  void refresh();
  void showProgress(double part);
  void showResult();
  void askReport();

  BoardDesk& desk_;
  QLabel* guide_;
  QLabel* boardTitle_;
  BoardFields* fields_;
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

} // namespace dewpoint
