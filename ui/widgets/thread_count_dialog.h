// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QLabel;
class QPushButton;
class QSpinBox;

namespace dewpoint::ui {

/// Asks for the number of filter threads and stores it in the preferences.
class ThreadCountDialog : public QDialog {
  Q_OBJECT
public:
  /// `most` is the number of threads that this machine runs simultaneously.
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
