// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/trajectory_export.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace dewpoint::ui {

/// Previews and exports in a thread of its own, one after the other. Of several previews that were
/// asked for only the last one is made.
class ExportWorker : public QObject {
  Q_OBJECT
public:
  explicit ExportWorker(QObject* parent = nullptr);
  ~ExportWorker() override; ///< cancels, and waits for what is under way

  using TrajectoryPtr = std::shared_ptr<const Trajectory>;
  void preview(TrajectoryPtr trajectory, const ExportOptions& options,
               const std::filesystem::path& file);
  void run(TrajectoryPtr trajectory, const ExportOptions& options,
           const std::filesystem::path& file);
  /// Something else that takes long, such as drawing a figure; said as finished or failed.
  void run(std::function<Status()> task, const std::filesystem::path& file);
  void cancel() { cancelled_ = true; }
  /// A preview that is asked for or under way is not wanted any more.
  void stopPreview() { ++wish_; }

Q_SIGNALS:
  /// How far a preview is that takes long.
  void previewing(int percent);
  void previewReady(const dewpoint::trajectory::ExportPreview& preview);
  void previewFailed(const QString& sentence);
  void progressChanged(int percent);
  void finished(const dewpoint::trajectory::ExportSummary& summary);
  void failed(const QString& sentence);

private:
  using Job = std::function<void()>;
  void work(const std::stop_token& stop);
  void add(std::optional<Job>& place, Job job);
  /// Sends a signal from the window's thread.
  void post(std::function<void()> say);

  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::optional<Job> nextPreview_;
  std::optional<Job> nextExport_;
  std::atomic<bool> cancelled_ = false;
  std::atomic<unsigned> wish_ = 0; ///< counts up: an older preview is not wanted any more
  std::jthread thread_;            // last: it uses the rest
};

} // namespace dewpoint::ui
