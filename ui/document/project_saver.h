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

/// Writes a project to a file, as saveProject() does.
using ProjectWriter =
    std::function<Status(const Project& project, const std::filesystem::path& file)>;

/// Writes the document to its file beside the window: however slow the disk is, work goes on. What
/// was begun is written to the end, also when the window closes meanwhile.
class ProjectSaver : public QObject {
  Q_OBJECT
public:
  /// `write`: saveProject() when there is none.
  explicit ProjectSaver(Document& document, QObject* parent = nullptr, ProjectWriter write = {});

  void setWriter(ProjectWriter write) { write_ = std::move(write); }
  /// Writes the document as it is now; one file after the other.
  void save(const std::filesystem::path& file);
  bool isSaving() const { return underWay_ > 0; }

Q_SIGNALS:
  void saved(const QString& file);
  void failed(const QString& sentence);

private:
  Document& document_;
  ProjectWriter write_;
  JobQueue queue_;
  int underWay_ = 0;           ///< how many files are under way
  std::uint64_t projects_ = 0; ///< counts the projects that were in the document
};

} // namespace dewpoint::ui
