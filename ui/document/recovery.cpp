// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/recovery.h"

#include "core/base/text_file.h"
#include "ui/document/document.h"
#include "ui/text/error_sentence.h"

#include <QStandardPaths>
#include <QUndoStack>

#include <utility>

namespace dewpoint::ui {

namespace {

constexpr int kDelayMs = 1000; ///< half of the two seconds that may be lost; the disk has the rest

} // namespace

std::filesystem::path Recovery::standardFolder() {
  const QString data = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
  return std::filesystem::path(data.toStdString()) / "recovery";
}

Recovery::Recovery(Document& document, std::filesystem::path folder, QObject* parent,
                   TextWriter write)
    : QObject(parent), document_(document), folder_(std::make_shared<Folder>()) {
  queue_.add([own = folder_, folder = std::move(folder),
              write = write ? std::move(write) : TextWriter(&writeTextFile)] {
    own->emplace(folder, write);
    return nullptr;
  });
  timer_.setSingleShot(true);
  timer_.setInterval(kDelayMs);
  connect(&timer_, &QTimer::timeout, this, &Recovery::write);
  connect(&document_, &Document::changed, this, &Recovery::schedule);
  connect(&document_, &Document::projectReplaced, this, [this] {
    removeOwnBackup();
    if (document_.isUnsaved()) {
      schedule();
    }
  });
  connect(&document_, &Document::fileChanged, this, [this] {
    removeBackup();
    if (document_.isUnsaved()) { // it was changed while it was saved
      schedule();
    }
  });
}

Recovery::~Recovery() { // the document may be gone already
  queue_.add([own = std::move(folder_)] {
    own->reset(); // takes the lock away, which is work for the disk, too
    return nullptr;
  });
}

void Recovery::runInFolder(std::function<void(RecoveryFolder&)> work) {
  queue_.add([own = folder_, work = std::move(work)] {
    work(**own);
    return nullptr;
  });
}

void Recovery::schedule() {
  // Not started anew by each change: a person who never pauses is saved, too.
  if (!timer_.isActive()) {
    timer_.start();
  }
}

void Recovery::write() {
  if (!document_.isUnsaved()) {
    removeOwnBackup(); // undone to what is in the file
    return;
  }
  if (std::exchange(writing_, true)) {
    schedule(); // the disk is slow: what is newest then
    return;
  }
  Q_EMIT backupStarting();
  queue_.add([this, own = folder_, project = document_.sharedProject()] {
    const Status written = (*own)->writeOwnBackup(*project);
    const QString failure = written ? QString() : errorText(written.error());
    return std::function<void()>([this, failure] {
      writing_ = false;
      if (failure != lastFailure_ && !failure.isEmpty()) {
        Q_EMIT failed(failure);
      }
      lastFailure_ = failure;
      if (failure.isEmpty()) {
        removeTakenOver();
        Q_EMIT backupWritten();
      }
    });
  });
}

void Recovery::removeTakenOver() {
  for (const RecoverableWork& work : std::exchange(takenOver_, {})) {
    runInFolder([work](RecoveryFolder&) { RecoveryFolder::remove(work); });
  }
}

void Recovery::removeBackup() {
  removeOwnBackup();
  removeTakenOver();
}

void Recovery::removeOwnBackup() {
  timer_.stop();
  runInFolder([](const RecoveryFolder& folder) { folder.removeOwnBackup(); });
}

void Recovery::findBackups(std::function<void(const std::vector<RecoverableWork>&)> then) {
  queue_.add([own = folder_, then = std::move(then)] {
    return std::function<void()>([then, left = (*own)->orphanedBackups()] { then(left); });
  });
}

void Recovery::recover(const RecoverableWork& work,
                       std::function<void(const Result<Project>&)> then) {
  queue_.add([work, then = std::move(then)] {
    return std::function<void()>(
        [then, project = RecoveryFolder::readBackup(work)] { then(project); });
  });
}

void Recovery::discard(const RecoverableWork& work) {
  runInFolder([work](RecoveryFolder&) { RecoveryFolder::discard(work); });
}

void Recovery::undoDiscard(const RecoverableWork& work) {
  runInFolder([work](RecoveryFolder&) { RecoveryFolder::undoDiscard(work); });
}

} // namespace dewpoint::ui
