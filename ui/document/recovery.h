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

/// Keeps a copy of unsaved work in a folder, so that a crash loses at most two seconds of work. The
/// copy is removed when the work is saved or discarded. Files are written in order in another
/// thread; the window never waits for the disk.
class Recovery : public QObject {
  Q_OBJECT
public:
  /// Creates `folder`, in which the copies of unsaved work are kept, if it is missing. `write` is
  /// the function that writes text files; `writeTextFile()` by default.
  Recovery(Document& document, std::filesystem::path folder, QObject* parent = nullptr,
           TextWriter write = {});
  ~Recovery() override;

  /// Finds the copies of unsaved work that closed windows left in the folder, and passes them to
  /// `then`, newest first.
  void findBackups(std::function<void(const std::vector<RecoverableWork>&)> then);
  /// Reads the project in a copy of unsaved work, and passes it to `then`. The project names the
  /// file from which it was originally loaded.
  void recover(const RecoverableWork& work, std::function<void(const Result<Project>&)> then);
  /// Notes that the document now contains this recovered work. The copy from which the work was
  /// read is removed once this window has written a copy of its own, or when the work is saved or
  /// discarded.
  void adoptBackup(const RecoverableWork& work) { takenOver_.push_back(work); }
  /// Discards a copy of unsaved work: it is no longer offered to the user, and it is deleted after
  /// a week. `undoDiscard()` undoes this.
  void discard(const RecoverableWork& work);
  void undoDiscard(const RecoverableWork& work);
  /// Removes this window's copy of unsaved work, and the copies that were recovered in this window.
  /// Call this when the work was saved or discarded.
  void removeBackup();

  static std::filesystem::path standardFolder();

Q_SIGNALS:
  /// Emitted before a copy of the unsaved work is written. Receivers must now apply their pending
  /// changes to the document.
  void backupStarting();
  /// Emitted when a copy of the unsaved work is safely on the disk.
  void backupWritten();
  /// Emitted with the reason when the copy of the unsaved work cannot be written. Each reason is
  /// reported once.
  void failed(const QString& sentence);

private:
  using Folder = std::optional<RecoveryFolder>; ///< created, used and destroyed only in the queue
  void runInFolder(std::function<void(RecoveryFolder&)> work);
  void schedule();
  void removeOwnBackup();
  void removeTakenOver();
  void write();

  Document& document_;
  std::shared_ptr<Folder> folder_;
  QTimer timer_;
  std::vector<RecoverableWork> takenOver_; ///< removed once this window has its own copy
  QString lastFailure_;
  bool writing_ = false;
  JobQueue queue_;
};

} // namespace dewpoint::ui
