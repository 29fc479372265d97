// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QLabel;
class QPushButton;
class QSpinBox;

namespace dewpoint::ui {

/// Asks how many threads the filter uses, and keeps the answer as a preference.
class ThreadCountDialog : public QDialog {
  Q_OBJECT
public:
  /// `most`: as many threads as this machine runs at once.
  explicit ThreadCountDialog(int most, QWidget* parent = nullptr);

private:
  void retranslateUi();

  QLabel* label_;
  QSpinBox* threads_;
  QLabel* note_;
  QPushButton* accept_;
  QPushButton* cancel_;
};

} // namespace dewpoint::ui
