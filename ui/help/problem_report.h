// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QDialog>
#include <QStringList>

class QLabel;
class QPlainTextEdit;
class QPushButton;

namespace dewpoint::ui {

/// Collects information that helps to find a fault, as text to copy: versions, system, OpenGL, and
/// the window's last messages. Also tells the user what to add. Not modal. Nothing is sent.
class ProblemReport : public QDialog {
  Q_OBJECT
public:
  /// `messages` are the last messages shown. `project` is a short description of the open project.
  ProblemReport(const QStringList& messages, const QString& project, QWidget* parent);

  QString text() const;

private:
  void retranslateUi();

  QLabel* intro_;
  QPlainTextEdit* text_;
  QPushButton* copy_;
  QPushButton* close_;
};

} // namespace dewpoint::ui
