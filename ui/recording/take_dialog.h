// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QDialog>
#include <QString>

class QLabel;
class QPlainTextEdit;
class QSpinBox;

namespace dewpoint::ui {

/// Number and notes of a take.
struct TakeDetails {
  int number = 0; ///< 0: the next one after all takes in the folder
  QString notes;
  int preRoll = 0; ///< seconds before the start that are recorded, of the next takes
};

/// Edits the number, the notes and the pre-roll of the next take, or the notes of a take that
/// exists.
class TakeDialog : public QDialog {
  Q_OBJECT
public:
  /// `exists` is true if the take has been started, so that its number is fixed.
  TakeDialog(const TakeDetails& details, bool exists, QWidget* parent);

  TakeDetails details() const;

private:
  void retranslateUi();

  bool exists_;
  QLabel* numberLabel_;
  QSpinBox* number_;
  QLabel* notesLabel_;
  QPlainTextEdit* notes_;
  QLabel* preRollLabel_;
  QSpinBox* preRoll_;
};

} // namespace dewpoint::ui
