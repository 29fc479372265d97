// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/project_loader.h"

#include <QDialog>
#include <QString>
#include <QStringList>

class QLabel;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;

namespace dewpoint::ui {

class BackgroundJob;

/// Facts about the window that a problem report contains.
struct ProblemFacts {
  QStringList messages;       ///< the last messages shown
  QString projectDescription; ///< short description of the open project
  QString crashReport;        ///< crash report; empty if there was no crash
};

/// Dialog with information that helps to find a fault, as text to copy: versions, system, OpenGL,
/// the window's last messages, a crash report, and the result of a self-test that the user can run
/// in the dialog. Also tells the user what to add. Not modal. Nothing is sent.
class ProblemReport : public QDialog {
  Q_OBJECT
public:
  /// Creates the dialog. `opener` opens the scene that the self-test tracks.
  ProblemReport(const ProblemFacts& facts, ProjectOpener opener, QWidget* parent);

  QString text() const;

Q_SIGNALS:
  /// Emitted when a self-test has ended or was canceled.
  void selfTestEnded();

private:
  void arrange();
  void startTest();
  void showTest(const QString& result);
  void showRunning(bool running);
  void retranslateUi();

  ProjectOpener opener_;
  BackgroundJob* job_;
  QString facts_; ///< first part of the text; the self-test comes after it
  QLabel* intro_;
  QPlainTextEdit* text_;
  QProgressBar* progress_;
  QPushButton* test_;
  QPushButton* copy_;
  QPushButton* close_;
};

} // namespace dewpoint::ui
