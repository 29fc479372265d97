// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/recovery_folder.h"

#include "core/base/text_file.h"
#include "core/project/project_load.h"
#include "core/project/project_save.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QLockFile>
#include <QUuid>

#include <utility>

namespace dewpoint::ui {

namespace {

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

RecoveryFolder::RecoveryFolder(std::filesystem::path folder, TextWriter write)
    : folder_(std::move(folder)), write_(std::move(write)),
      id_(QUuid::createUuid().toString(QUuid::WithoutBraces)) {
  QDir().mkpath(QString::fromStdString(folder_.string()));
  lock_ = std::make_unique<QLockFile>(
      QString::fromStdString((folder_ / (id_ + kLock).toStdString()).string()));
  lock_->setStaleLockTime(0); // stale only when its process is gone
  lock_->tryLock(0);
  removeLeftovers();
}

RecoveryFolder::~RecoveryFolder() = default;

/// Windows that are gone may have left a lock without any work, or half a copy; and what was put
/// aside long ago is not wanted back.
void RecoveryFolder::removeLeftovers() const {
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

std::filesystem::path RecoveryFolder::own() const {
  return folder_ / (id_ + kProject).toStdString();
}

Status RecoveryFolder::writeOwnBackup(const Project& project) const {
  const std::filesystem::path copy = own();
  // The copy lies in no project's folder: all its paths are absolute.
  return write_(originOf(copy), project.file.string()).and_then([&] {
    return write_(copy, projectText(project, copy));
  });
}

void RecoveryFolder::removeOwnBackup() const {
  removeFile(own());
  removeFile(originOf(own()));
}

std::vector<RecoverableWork> RecoveryFolder::orphanedBackups() const {
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

Result<Project> RecoveryFolder::readBackup(const RecoverableWork& work) {
  auto project = loadProject(work.backupFile);
  if (project) {
    project->file = readTextFile(originOf(work.backupFile)).value_or(std::string());
  }
  return project;
}

void RecoveryFolder::discard(const RecoverableWork& work) {
  moveFile(work.backupFile, asideOf(work.backupFile));
}

void RecoveryFolder::undoDiscard(const RecoverableWork& work) {
  moveFile(asideOf(work.backupFile), work.backupFile);
}

void RecoveryFolder::remove(const RecoverableWork& work) {
  removeFile(work.backupFile);
  removeFile(originOf(work.backupFile));
  removeFile(std::filesystem::path(work.backupFile).replace_extension(kLock.toStdString()));
}

} // namespace dewpoint::ui
