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

/// Unsaved work that a window left behind because it did not close properly.
struct RecoverableWork {
  std::filesystem::path file; ///< the copy, a complete project
  QString name;               ///< name of the project
  QString time;               ///< time of the last write, formatted for display
};

/// Writes a text to a file, as `writeTextFile()` does.
using TextWriter =
    std::function<Status(const std::filesystem::path& file, const std::string& text)>;

/// Folder with the copies of unsaved work, one per window. A lock file per window shows whether
/// that window is still running. All functions access the disk: call them in another thread, one at
/// a time.
class RecoveryFolder {
public:
  /// Creates the folder if it is missing, locks the copy of this window, and deletes stale locks
  /// and incomplete copies of closed windows.
  RecoveryFolder(std::filesystem::path folder, TextWriter write);
  ~RecoveryFolder(); ///< releases the lock

  /// Returns the copies that closed windows left in the folder, newest first.
  std::vector<RecoverableWork> orphanedBackups() const;
  /// Reads the project of a copy, with the path of the file it was loaded from.
  static Result<Project> read(const RecoverableWork& work);
  /// Discards a copy: it is not offered any more and is deleted after a week. `restore()` undoes
  /// this.
  static void discard(const RecoverableWork& work);
  static void restore(const RecoverableWork& work);
  static void remove(const RecoverableWork& work);

  /// Writes the copy of this window: `project`, which was loaded from `project.file`.
  Status writeOwn(const Project& project) const;
  void removeOwn() const;

private:
  void sweep() const;
  std::filesystem::path own() const;

  std::filesystem::path folder_;
  TextWriter write_;
  QString id_; ///< identifies this window
  std::unique_ptr<QLockFile> lock_;
};

} // namespace dewpoint::ui
