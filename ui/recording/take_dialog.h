// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QDialog>
#include <QString>

class QLabel;
class QPlainTextEdit;
class QSpinBox;

namespace dewpoint::ui {

/// Details of a take (a recording of all cameras) that the user can edit.
struct TakeDetails {
  int takeNumber = 0; ///< number of the take; 0: the next number after all takes in the folder
  QString notes;
  int preRollSeconds = 0; ///< seconds before the start that the next takes also record
};

/// Dialog for the number, the notes and the pre-roll of the next take (a recording of all cameras),
/// or for the notes of an existing take. The pre-roll is the time before the start that is also
/// recorded.
class TakeDialog : public QDialog {
  Q_OBJECT
public:
  /// Creates the dialog for a take (a recording of all cameras). `exists` is true if the take has
  /// already started; its number can then not be changed.
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
