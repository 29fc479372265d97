// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/recovery.h"

#include "core/base/text_file.h"
#include "ui/document/document.h"
#include "ui/text/error_sentence.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QLockFile>
#include <QStandardPaths>
#include <QUndoStack>
#include <QUuid>

#include <utility>

namespace dewpoint::ui {

namespace {

constexpr int kDelayMs = 1000; ///< half of the two seconds that may be lost; the disk has the rest
const QString kProject = QStringLiteral(".toml");
const QString kOrigin = QStringLiteral(".origin"); ///< the file the project was loaded from
const QString kLock = QStringLiteral(".lock");
const QString kAside = QStringLiteral(".aside"); ///< a project nobody wanted back
constexpr int kDaysAside = 7;

void removeFile(const std::filesystem::path& file) {
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
}

void moveFile(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::error_code ignored; // it stays, and is offered again
  std::filesystem::rename(from, to, ignored);
}

std::filesystem::path asideOf(const std::filesystem::path& copy) {
  return std::filesystem::path(copy).replace_extension(kAside.toStdString());
}

std::filesystem::path originOf(const std::filesystem::path& copy) {
  return std::filesystem::path(copy).replace_extension(kOrigin.toStdString());
}

} // namespace

std::filesystem::path Recovery::standardFolder() {
  const QString data = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
  return std::filesystem::path(data.toStdString()) / "recovery";
}

Recovery::Recovery(Document& document, std::filesystem::path folder, QObject* parent)
    : QObject(parent), document_(document), folder_(std::move(folder)),
      id_(QUuid::createUuid().toString(QUuid::WithoutBraces)) {
  QDir().mkpath(QString::fromStdString(folder_.string()));
  lock_ = std::make_unique<QLockFile>(
      QString::fromStdString((folder_ / (id_ + kLock).toStdString()).string()));
  lock_->setStaleLockTime(0); // stale only when its process is gone
  lock_->tryLock(0);
  sweep();
  timer_.setSingleShot(true);
  timer_.setInterval(kDelayMs);
  connect(&timer_, &QTimer::timeout, this, &Recovery::write);
  connect(&document_, &Document::changed, this, &Recovery::schedule);
  connect(&document_, &Document::replaced, this, [this] {
    removeOwn();
    if (document_.isUnsaved()) {
      schedule();
    }
  });
  connect(&document_, &Document::fileChanged, this, &Recovery::forget);
}

Recovery::~Recovery() = default; // the document may be gone already

/// Windows that are gone may have left a lock without any work, or half a copy; and what was put
/// aside long ago is not wanted back.
void Recovery::sweep() {
  const QDir folder(QString::fromStdString(folder_.string()));
  const QDateTime old = QDateTime::currentDateTime().addDays(-kDaysAside);
  for (const QFileInfo& file : folder.entryInfoList({QStringLiteral("*") + kAside}, QDir::Files)) {
    if (file.lastModified() < old) {
      removeFile(file.filePath().toStdString());
    }
  }
  const QStringList ours{QStringLiteral("*") + kLock, QStringLiteral("*") + kOrigin,
                         QStringLiteral("*.part")};
  for (const QFileInfo& file : folder.entryInfoList(ours, QDir::Files)) {
    const QString id = file.fileName().section(QLatin1Char('.'), 0, 0);
    if (id == id_ || folder.exists(id + kProject) || folder.exists(id + kAside)) {
      continue;
    }
    QLockFile lock(folder.filePath(id + kLock));
    lock.setStaleLockTime(0);
    if (lock.tryLock(0)) {
      if (!file.fileName().endsWith(kLock)) {
        removeFile(file.filePath().toStdString());
      }
      lock.unlock(); // takes the file away
    }
  }
}

std::filesystem::path Recovery::copyOf(const QString& id) const {
  return folder_ / (id + kProject).toStdString();
}

void Recovery::schedule() {
  // Not started anew by each change: a person who never pauses is saved, too.
  if (!timer_.isActive()) {
    timer_.start();
  }
}

void Recovery::write() {
  if (!document_.isUnsaved()) {
    removeOwn(); // undone to what is in the file
    return;
  }
  Q_EMIT writing();
  const Project& project = document_.project();
  const std::filesystem::path copy = copyOf(id_);
  // The copy lies in no project's folder: all its paths are absolute.
  writer_ =
      std::jthread([this, copy, text = projectText(project, copy), origin = project.file.string()] {
        auto written = writeTextFile(originOf(copy), origin);
        if (written) {
          written = writeTextFile(copy, text);
        }
        const QString failure = written ? QString() : errorSentence(written.error());
        QMetaObject::invokeMethod(
            this,
            [this, failure] {
              if (failure != lastFailure_ && !failure.isEmpty()) {
                Q_EMIT failed(failure);
              }
              lastFailure_ = failure;
              if (failure.isEmpty()) {
                removeTaken();
                Q_EMIT kept();
              }
            },
            Qt::QueuedConnection);
      });
}

void Recovery::removeTaken() {
  for (const RecoverableWork& work : std::exchange(taken_, {})) {
    discard(work);
  }
}

void Recovery::forget() {
  removeOwn();
  removeTaken();
}

void Recovery::removeOwn() {
  timer_.stop();
  if (writer_.joinable()) {
    writer_.join();
  }
  removeFile(copyOf(id_));
  removeFile(originOf(copyOf(id_)));
}

std::vector<RecoverableWork> Recovery::leftBehind() const {
  std::vector<RecoverableWork> all;
  const QDir folder(QString::fromStdString(folder_.string()));
  for (const QFileInfo& file :
       folder.entryInfoList({QStringLiteral("*") + kProject}, QDir::Files, QDir::Time)) {
    const QString id = file.completeBaseName();
    QLockFile lock(folder.filePath(id + kLock));
    lock.setStaleLockTime(0);
    if (id == id_ || !lock.tryLock(0)) {
      continue; // its window lives
    }
    lock.unlock();
    const auto project = loadProject(file.filePath().toStdString());
    all.push_back({file.filePath().toStdString(),
                   project ? QString::fromStdString(project->name) : file.fileName(),
                   QLocale().toString(file.lastModified(), QLocale::ShortFormat)});
  }
  return all;
}

Result<Project> Recovery::recover(const RecoverableWork& work) {
  auto project = loadProject(work.file);
  if (project) {
    project->file = readTextFile(originOf(work.file)).value_or(std::string());
  }
  return project;
}

void Recovery::putAside(const RecoverableWork& work) {
  moveFile(work.file, asideOf(work.file));
}

void Recovery::takeBack(const RecoverableWork& work) {
  moveFile(asideOf(work.file), work.file);
}

void Recovery::discard(const RecoverableWork& work) {
  removeFile(work.file);
  removeFile(originOf(work.file));
  removeFile(std::filesystem::path(work.file).replace_extension(kLock.toStdString()));
}

} // namespace dewpoint::ui
