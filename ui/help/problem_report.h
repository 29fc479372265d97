// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QDialog>
#include <QStringList>

class QLabel;
class QPlainTextEdit;
class QPushButton;

namespace dewpoint::ui {

/// What helps to find a fault, as one text to be copied: versions, system, OpenGL, and the last
/// messages of the window; and what to write beside it. Not modal. Nothing is sent.
class ProblemReport : public QDialog {
  Q_OBJECT
public:
  /// `messages`: the last ones that were shown; `project`: what is open, in a few words.
  ProblemReport(const QStringList& messages, const QString& project, QWidget* parent);

  QString text() const;

private:
  void retranslateUi();

  QLabel* lead_;
  QPlainTextEdit* text_;
  QPushButton* copy_;
  QPushButton* close_;
};

} // namespace dewpoint::ui
