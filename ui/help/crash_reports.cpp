// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/crash_reports.h"

#include "core/base/crash_report.h"
#include "core/base/text_file.h"
#include "ui/actions/action_registry.h"
#include "ui/help/help_installer.h"
#include "ui/jobs/background_job.h"
#include "ui/widgets/message_bar.h"

#include <QAction>
#include <QCoreApplication>
#include <QDateTime>
#include <QMainWindow>
#include <QStandardPaths>
#include <QSysInfo>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::ui {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostKept = 5;
const std::string kNew = "crash-";
const std::string kOffered = "offered-";

/// The reports whose names begin so, newest first.
std::vector<fs::path> reportsIn(const fs::path& folder, const std::string& beginning) {
  std::vector<std::pair<fs::file_time_type, fs::path>> found;
  std::error_code failed;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end;
       entry.increment(failed)) {
    if (entry->path().filename().string().starts_with(beginning)) {
      std::error_code ignored;
      found.emplace_back(entry->last_write_time(ignored), entry->path());
    }
  }
  std::ranges::sort(found, std::greater());
  std::vector<fs::path> reports;
  std::ranges::transform(found, std::back_inserter(reports),
                         [](const auto& report) { return report.second; });
  return reports;
}

/// The newest report that was not offered yet. Afterwards all count as offered, and old ones are
/// gone.
QString takeReport(const fs::path& folder) {
  QString newest;
  std::error_code ignored;
  for (const fs::path& file : reportsIn(folder, kNew)) {
    if (newest.isEmpty()) {
      newest = QString::fromStdString(readTextFile(file).value_or(std::string()));
    }
    fs::rename(file, folder / (kOffered + file.filename().string()), ignored);
  }
  const auto offered = reportsIn(folder, kOffered);
  for (std::size_t k = kMostKept; k < offered.size(); ++k) {
    fs::remove(offered[k], ignored);
  }
  return newest;
}

std::string now() {
  return QDateTime::currentDateTime().toString(Qt::ISODate).toStdString();
}

} // namespace

std::filesystem::path crashFolder() {
  const QString data = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
  return fs::path(data.toStdString()) / "crashes";
}

void enableCrashReports() {
  const QString name =
      QStringLiteral("%1%2-%3.txt")
          .arg(QString::fromStdString(kNew),
               QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-hhmmss")))
          .arg(QCoreApplication::applicationPid());
  const QString heading = QStringLiteral("Dewpoint %1, started %2, %3")
                              .arg(QStringLiteral(DEWPOINT_VERSION), QString::fromStdString(now()),
                                   QSysInfo::prettyProductName());
  // Without it, everything else works: nothing is said.
  (void)enableCrashReport(crashFolder() / name.toStdString(), heading.toStdString());
}

CrashReports::CrashReports(const Workbench& bench, fs::path folder)
    : QObject(&bench.window), bench_(bench), folder_(std::move(folder)),
      job_(new BackgroundJob(this)) {
  noteActions();
  search();
}

void CrashReports::noteActions() {
  for (QAction* action : bench_.actions.allActions()) {
    connect(action, &QAction::triggered, this,
            [action] { addCrashReportNote(now() + " " + action->objectName().toStdString()); });
  }
  connect(&bench_.messages, &MessageBar::messageShown, this, [](const QString& message) {
    addCrashReportNote(now() + " message: " + message.toStdString());
  });
}

void CrashReports::search() {
  job_->start([this, folder = folder_](const BackgroundJob::Progress&) -> std::function<void()> {
    return [this, report = takeReport(folder)] {
      report_ = report;
      if (!report_.isEmpty()) {
        offer();
      }
      Q_EMIT searchEnded(!report_.isEmpty());
    };
  });
}

void CrashReports::offer() {
  bench_.messages.showLastingQuestion(
      tr("Dewpoint closed unexpectedly last time and left a report of what happened."),
      {{tr("Show report"), [this] { openCrashReportDialog(bench_, report_); }}});
}

} // namespace dewpoint::ui
