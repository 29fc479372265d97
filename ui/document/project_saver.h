// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "ui/jobs/job_queue.h"

#include <QObject>
#include <QString>

#include <cstdint>
#include <filesystem>
#include <functional>

namespace dewpoint::project {
struct Project;
} // namespace dewpoint::project

namespace dewpoint::ui {

class Document;

/// Function that writes a project to a file, as `saveProject()` does.
using ProjectWriter =
    std::function<Status(const Project& project, const std::filesystem::path& file)>;

/// Saves the document to its file in another thread, so that a slow disk does not block the window.
/// A write that has begun completes even if the window is closed.
class ProjectSaver : public QObject {
  Q_OBJECT
public:
  /// Creates an object that saves `document`. `write` is the function that writes the project;
  /// `saveProject()` by default.
  explicit ProjectSaver(Document& document, QObject* parent = nullptr, ProjectWriter write = {});

  void setWriter(ProjectWriter write) { write_ = std::move(write); }
  /// Starts to save the current state of the document, in another thread. If an earlier save is
  /// still being written, this one is written after it.
  void save(const std::filesystem::path& file);
  bool isSaving() const { return pendingWrites_ > 0; }

Q_SIGNALS:
  void saved(const QString& file);
  void failed(const QString& sentence);

private:
  Document& document_;
  ProjectWriter write_;
  JobQueue queue_;
  int pendingWrites_ = 0;          ///< number of writes in progress
  std::uint64_t projectCount_ = 0; ///< number of projects that the document has held
};

} // namespace dewpoint::ui
