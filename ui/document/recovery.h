// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/document/recovery_folder.h"
#include "ui/jobs/job_queue.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace dewpoint::ui {

class Document;

/// Keeps a copy of unsaved work beside the user's data, so that a crash costs two seconds at
/// most: every change is on the disk that much later, written beside, flushed and renamed. The copy
/// goes when the work is saved or given up. All this is done in order beside the window, which
/// never waits for the disk.
class Recovery : public QObject {
  Q_OBJECT
public:
  /// `folder` is made when it is missing; `write`: how texts are written, writeTextFile() when
  /// there is none.
  Recovery(Document& document, std::filesystem::path folder, QObject* parent = nullptr,
           TextWriter write = {});
  ~Recovery() override;

  /// Finds what windows that were closed left in the folder, the newest first.
  void look(std::function<void(const std::vector<RecoverableWork>&)> then);
  /// Reads the project of such a copy, with the file it was loaded from.
  void recover(const RecoverableWork& work, std::function<void(const Result<Project>&)> then);
  /// The document is that work now: its copy goes as soon as this window has written its own, or
  /// the work is saved or given up.
  void take(const RecoverableWork& work) { taken_.push_back(work); }
  /// Puts the copy where it is not offered any more; a slip can be taken back. What lies there is
  /// gone after a week.
  void discard(const RecoverableWork& work);
  void restore(const RecoverableWork& work);
  /// Removes the copy of this window, and what it took over: the work is saved or given up.
  void removeBackup();

  static std::filesystem::path standardFolder();

Q_SIGNALS:
  /// A copy is about to be written: what is not in the document yet goes there now.
  void writing();
  /// A copy is safely on the disk.
  void kept();
  /// The copy cannot be written: the sentence why, once per reason.
  void failed(const QString& sentence);

private:
  using Folder = std::optional<RecoveryFolder>; ///< made, used and closed by the queue alone
  void inFolder(std::function<void(RecoveryFolder&)> work);
  void schedule();
  void removeOwn();
  void removeTaken();
  void write();

  Document& document_;
  std::shared_ptr<Folder> folder_;
  QTimer timer_;
  std::vector<RecoverableWork> taken_; ///< thrown away once this window has its own copy
  QString lastFailure_;
  bool writing_ = false;
  JobQueue queue_;
};

} // namespace dewpoint::ui
