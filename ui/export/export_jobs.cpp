// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_jobs.h"

#include "ui/text/error_sentence.h"

#include <system_error>
#include <utility>

namespace dewpoint::ui {

namespace {

int percentOf(double part) {
  return static_cast<int>(100.0 * part);
}

} // namespace

ExportJobs::ExportJobs(QObject* parent)
    : QObject(parent), canceled_(std::make_shared<std::atomic<bool>>(false)) {
  connect(&preview_, &LatestJob::progressChanged, this,
          [this](double part) { Q_EMIT previewProgressChanged(percentOf(part)); });
  connect(&export_, &BackgroundJob::progressChanged, this,
          [this](double part) { Q_EMIT progressChanged(percentOf(part)); });
}

void ExportJobs::startPreview(TrajectoryPtr trajectory, const ExportOptions& options,
                              const std::filesystem::path& file) {
  preview_.start([this, trajectory = std::move(trajectory), options,
                  file](const BackgroundJob::Progress& progress) -> std::function<void()> {
    constexpr std::size_t kLines = 100; // notes, and more rows than can be seen below them
    const auto preview = previewExport(*trajectory, options, file, kLines, progress);
    if (preview) {
      return [this, found = *preview] { Q_EMIT previewReady(found); };
    }
    return [this, error = preview.error()] { Q_EMIT previewFailed(errorText(error)); };
  });
}

void ExportJobs::checkFileExists(const std::filesystem::path& file,
                                 std::function<void(bool exists)> report) {
  finding_.start([file, report = std::move(report)](const BackgroundJob::Progress&) {
    std::error_code ignored;
    const bool exists = std::filesystem::exists(file, ignored);
    return [report, exists] { report(exists); };
  });
}

void ExportJobs::run(TrajectoryPtr trajectory, const ExportOptions& options,
                     const std::filesystem::path& file) {
  canceled_ = std::make_shared<std::atomic<bool>>(false);
  stopPreview(); // it makes room
  export_.start([this, trajectory = std::move(trajectory), options, file,
                 canceled = canceled_](const BackgroundJob::Progress& progress) {
    const auto goesOn = [&](double part) { return progress(part) && !*canceled; };
    std::error_code ignored;
    ExportSummary occupied; // known before the work is done
    occupied.existingFile = file;
    const auto summary = !options.replacesExisting && std::filesystem::exists(file, ignored)
                             ? Result<ExportSummary>(occupied)
                             : exportTrajectory(*trajectory, options, file, goesOn);
    return std::function<void()>([this, summary, canceled] {
      if (!summary) {
        Q_EMIT failed(errorText(summary.error()));
      } else if (!summary->existingFile.empty() && *canceled) { // who canceled is not asked
        ExportSummary stopped;
        stopped.isCanceled = true;
        Q_EMIT finished(stopped);
      } else {
        Q_EMIT finished(*summary);
      }
    });
  });
}

void ExportJobs::run(std::function<Status()> task, const std::filesystem::path& file) {
  canceled_ = std::make_shared<std::atomic<bool>>(false);
  export_.start([this, task = std::move(task), file](const BackgroundJob::Progress&) {
    const Status status = task();
    return std::function<void()>([this, status, file] {
      if (status) {
        ExportSummary summary;
        summary.files.push_back(file);
        Q_EMIT finished(summary);
      } else {
        Q_EMIT failed(errorText(status.error()));
      }
    });
  });
}

} // namespace dewpoint::ui
