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

/// Previews and exports in threads. Of several previews that were requested only the last one is
/// made; an export ends the preview under way.
class ExportJobs : public QObject {
  Q_OBJECT
public:
  explicit ExportJobs(QObject* parent = nullptr);

  using TrajectoryPtr = std::shared_ptr<const Trajectory>;
  void preview(TrajectoryPtr trajectory, const ExportOptions& options,
               const std::filesystem::path& file);
  void run(TrajectoryPtr trajectory, const ExportOptions& options,
           const std::filesystem::path& file);
  /// Something else that takes long, such as drawing a figure; reported as finished or failed.
  void run(std::function<Status()> task, const std::filesystem::path& file);
  /// Reports whether there is such a file; of several requests only the last one is answered.
  void find(const std::filesystem::path& file, std::function<void(bool exists)> report);
  void cancel() { *cancelled_ = true; }
  /// Drops a preview that is requested or under way.
  void stopPreview() { preview_.cancel(); }

Q_SIGNALS:
  /// How far a preview is that takes long.
  void previewing(int percent);
  void previewReady(const dewpoint::trajectory::ExportPreview& preview);
  void previewFailed(const QString& sentence);
  void progressChanged(int percent);
  void finished(const dewpoint::trajectory::ExportSummary& summary);
  void failed(const QString& sentence);

private:
  LatestJob preview_{LatestJob::Overtaken::Dropped};
  LatestJob finding_{LatestJob::Overtaken::Dropped};
  BackgroundJob export_;
  /// Not the job's own canceling: how a canceled export ended is reported, too.
  std::shared_ptr<std::atomic<bool>> cancelled_;
};

} // namespace dewpoint::ui
