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

/// Work that a window left behind without a proper end.
struct RecoverableWork {
  std::filesystem::path file; ///< the copy, a whole project
  QString name;               ///< of the project
  QString time;               ///< when it was last written, for people
};

/// Writes a text to a file, as writeTextFile() does.
using TextWriter =
    std::function<Status(const std::filesystem::path& file, const std::string& text)>;

/// The folder with the copies of unsaved work, one for each window; one lock in it says which of
/// them have a living window. Everything here reads or writes the disk: call it in a thread, and
/// one call at a time.
class RecoveryFolder {
public:
  /// Makes the folder when it is missing, locks the copy of this window, and clears away what
  /// windows that were closed left of locks and half copies.
  RecoveryFolder(std::filesystem::path folder, TextWriter write);
  ~RecoveryFolder(); ///< takes the lock away

  /// What windows that were closed left in the folder, the newest first.
  std::vector<RecoverableWork> orphanedBackups() const;
  /// The project of such a copy, with the file it was loaded from.
  static Result<Project> read(const RecoverableWork& work);
  /// Puts the copy where it is not offered any more; what lies there is gone after a week.
  static void discard(const RecoverableWork& work);
  static void restore(const RecoverableWork& work);
  static void remove(const RecoverableWork& work);

  /// Writes this window's copy: `project`, which was loaded from `project.file`.
  Status writeOwn(const Project& project) const;
  void removeOwn() const;

private:
  void sweep() const;
  std::filesystem::path own() const;

  std::filesystem::path folder_;
  TextWriter write_;
  QString id_; ///< of this window
  std::unique_ptr<QLockFile> lock_;
};

} // namespace dewpoint::ui
