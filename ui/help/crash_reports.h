// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

#include <QObject>
#include <QString>

#include <filesystem>

namespace dewpoint::ui {

class BackgroundJob;

/// Returns the folder to which a crash report of the window is written.
std::filesystem::path crashFolder();

/// Installs handlers that write a report to `crashFolder()` when this process crashes: version,
/// signal, last actions and messages, and stack. If the folder does not exist, no report is
/// written.
void enableCrashReports();

/// Records the user's actions and the window's messages for a crash report. If earlier windows left
/// crash reports, offers to show the newest one. A report is offered once; only the newest reports
/// are kept in the folder.
class CrashReports : public QObject {
  Q_OBJECT
public:
  CrashReports(const Workbench& bench, std::filesystem::path folder);

Q_SIGNALS:
  /// Emitted when the folder was searched for reports. If `found` is true, a report has been
  /// offered.
  void searchEnded(bool found);

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
