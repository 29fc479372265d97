// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

#include <QObject>
#include <QString>

#include <filesystem>

namespace dewpoint::ui {

class BackgroundJob;

/// Folder in which a crash of the window leaves its report.
std::filesystem::path crashFolder();

/// Makes a crash of this process leave a report in `crashFolder()`: version, signal, last actions
/// and messages, stack. If the folder does not exist, no report is written.
void enableCrashReports();

/// Notes the user's actions and the window's messages for the report of a crash. When there are
/// reports of earlier windows, says so and offers to show the newest one. A report is offered once;
/// the newest ones are kept in the folder.
class CrashReports : public QObject {
  Q_OBJECT
public:
  CrashReports(const Workbench& bench, std::filesystem::path folder);

Q_SIGNALS:
  /// Emitted when the folder was searched. If there is a report, it has been offered.
  void searched(bool found);

private:
  void noteActions();
  void search();
  void offer();

  Workbench bench_;
  std::filesystem::path folder_;
  BackgroundJob* job_;
  QString report_;
};

} // namespace dewpoint::ui
