// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QLabel;
class QPushButton;
class QSpinBox;

namespace dewpoint::ui {

/// Dialog that asks for the number of filter threads and stores this number in the preferences.
class ThreadCountDialog : public QDialog {
  Q_OBJECT
public:
  /// Creates the dialog. `most` is the number of threads that this computer runs simultaneously.
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
