// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/project.h"

#include <QString>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

class QLockFile;

namespace dewpoint::ui {

/// Unsaved work of a window that was not closed properly.
struct RecoverableWork {
  std::filesystem::path backupFile; ///< file with the copy, a complete project
  QString projectName;
  QString backupTimeText; ///< time of the last write, formatted for display
};

/// Function that writes text to a file, like `writeTextFile()`.
using TextWriter =
    std::function<Status(const std::filesystem::path& file, const std::string& text)>;

/// Folder with the copies of unsaved work, one per window. A lock file per window shows whether
/// that window is still running. All functions access the disk, so call them from another thread,
/// one at a time.
class RecoveryFolder {
public:
  /// Creates the folder if it is missing, and a lock file that shows that this window is running.
  /// Deletes stale locks and incomplete copies of closed windows.
  RecoveryFolder(std::filesystem::path folder, TextWriter write);
  ~RecoveryFolder(); ///< releases the lock of this window's copy

  /// Returns the copies of unsaved work that closed windows left in the folder, newest first.
  std::vector<RecoverableWork> orphanedBackups() const;
  /// Reads the project in a copy of unsaved work. The project names the file from which it was
  /// originally loaded.
  static Result<Project> readBackup(const RecoverableWork& work);
  /// Discards a copy of unsaved work: it is no longer offered to the user, and it is deleted after
  /// a week. `undoDiscard()` undoes this.
  static void discard(const RecoverableWork& work);
  static void undoDiscard(const RecoverableWork& work);
  static void remove(const RecoverableWork& work);

  /// Writes `project`, which was loaded from `project.file`, to the copy of this window's unsaved
  /// work.
  Status writeOwnBackup(const Project& project) const;
  void removeOwnBackup() const;

private:
  void removeLeftovers() const;
  std::filesystem::path own() const;

  std::filesystem::path folder_;
  TextWriter write_;
  QString id_; ///< identifies this window
  std::unique_ptr<QLockFile> lock_;
};

} // namespace dewpoint::ui
