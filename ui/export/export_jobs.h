// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/export/trajectory_export.h"
#include "ui/jobs/background_job.h"
#include "ui/jobs/latest_job.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>

namespace dewpoint::ui {

/// Computes previews and exports in other threads. Only the newest requested preview is computed.
/// An export cancels the current preview.
class ExportJobs : public QObject {
  Q_OBJECT
public:
  explicit ExportJobs(QObject* parent = nullptr);

  using TrajectoryPtr = std::shared_ptr<const Trajectory>;
  void startPreview(TrajectoryPtr trajectory, const ExportOptions& options,
                    const std::filesystem::path& file);
  void run(TrajectoryPtr trajectory, const ExportOptions& options,
           const std::filesystem::path& file);
  /// Runs another long task, such as drawing a figure; emits `finished()` or `failed()` afterwards.
  void run(std::function<Status()> task, const std::filesystem::path& file);
  /// Calls `report` with whether a file exists. Only the newest request is answered.
  void checkFileExists(const std::filesystem::path& file, std::function<void(bool exists)> report);
  void cancel() { *canceled_ = true; }
  /// Cancels a preview that is waiting or in progress.
  void stopPreview() { preview_.cancel(); }

Q_SIGNALS:
  /// Emitted with the progress (percent) of a preview that takes long.
  void previewProgressChanged(int percent);
  void previewReady(const dewpoint::trajectory::ExportPreview& startPreview);
  void previewFailed(const QString& sentence);
  void progressChanged(int percent);
  void finished(const dewpoint::trajectory::ExportSummary& summary);
  void failed(const QString& sentence);

private:
  LatestJob preview_{LatestJob::SupersededJob::Dropped};
  LatestJob finding_{LatestJob::SupersededJob::Dropped};
  BackgroundJob export_;
  /// Separate from the job's cancel flag, so that the result of a canceled export is also reported.
  std::shared_ptr<std::atomic<bool>> canceled_;
};

} // namespace dewpoint::ui
