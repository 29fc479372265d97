// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/project.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <filesystem>
#include <memory>
#include <optional>
#include <thread>

class QLockFile;

namespace dewpoint::ui {

class Document;

/// Work that a window left behind without a proper end.
struct RecoverableWork {
  std::filesystem::path file; ///< the copy, a whole project
  QString name;               ///< of the project
  QString time;               ///< when it was last written, for people
};

/// Keeps a copy of unsaved work beside the person's data, so that a crash costs two seconds at
/// most: every change is on the disk that much later, written beside, flushed and renamed. The copy
/// goes when the work is saved or given up.
class Recovery : public QObject {
  Q_OBJECT
public:
  /// `folder` is made when it is missing; one lock in it says which copies have a living window.
  Recovery(Document& document, std::filesystem::path folder, QObject* parent = nullptr);
  ~Recovery() override;

  /// What windows that are gone left in the folder, the newest first.
  std::vector<RecoverableWork> leftBehind() const;
  /// The project of such a copy, with the file it was loaded from.
  Result<Project> recover(const RecoverableWork& work);
  /// The document is that work now: its copy goes as soon as this window has written its own, or
  /// the work is saved or given up.
  void take(const RecoverableWork& work) { taken_.push_back(work); }
  /// Puts the copy where it is not offered any more; a slip can be taken back. What lies there is
  /// gone after a week.
  void putAside(const RecoverableWork& work);
  void takeBack(const RecoverableWork& work);
  /// Forgets the copy of this window, and what it took over: the work is saved or given up.
  void forget();

  static std::filesystem::path standardFolder();

Q_SIGNALS:
  /// A copy is about to be written: what is not in the document yet goes there now.
  void writing();
  /// A copy is safely on the disk.
  void kept();
  /// The copy cannot be written: the sentence why, once per reason.
  void failed(const QString& sentence);

private:
  void sweep();
  void discard(const RecoverableWork& work);
  void schedule();
  void removeOwn();
  void removeTaken();
  void write();
  std::filesystem::path copyOf(const QString& id) const;

  Document& document_;
  std::filesystem::path folder_;
  QString id_; ///< of this window
  std::unique_ptr<QLockFile> lock_;
  QTimer timer_;
  std::vector<RecoverableWork> taken_; ///< thrown away once this window has its own copy
  QString lastFailure_;
  std::jthread writer_; ///< flushing takes long on some disks
};

} // namespace dewpoint::ui
