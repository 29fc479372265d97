// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/setup/doctor/finding.h"
#include "ui/session/project_loader.h"

#include <QDialog>

#include <functional>
#include <vector>

class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTextBrowser;

namespace dewpoint::ui {

class BackgroundJob;

/// Dialog that checks the open project for problems, as `dewpoint-cli doctor` does, and shows the
/// findings, problems first. The check starts immediately. Not modal; nothing is written.
class ProjectCheckDialog : public QDialog {
  Q_OBJECT
public:
  /// Creates the dialog. `project` returns the current project when a check starts. `opener` opens
  /// the images of the project.
  ProjectCheckDialog(std::function<Project()> project, ProjectOpener opener, QWidget* parent);

  const std::vector<Finding>& findings() const { return findings_; }
  bool isRunning() const;

Q_SIGNALS:
  /// Emitted when a check has ended and its findings are shown.
  void checkEnded();

protected:
  void changeEvent(QEvent* event) override; ///< colors follow the theme

private:
  void arrange();
  void start();
  void showRunning(bool running);
  void fillList();
  QString summary() const;
  QString plainText() const;
  void retranslateUi();

  std::function<Project()> project_;
  ProjectOpener opener_;
  BackgroundJob* job_;
  std::vector<Finding> findings_; ///< the most severe first
  bool isCanceled_ = false;
  QLabel* summary_;
  QTextBrowser* list_;
  QCheckBox* everyFrame_;
  QProgressBar* progress_;
  QPushButton* check_;
  QPushButton* cancel_;
  QPushButton* copy_;
  QPushButton* close_;
};

} // namespace dewpoint::ui
