// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/project_saver.h"

#include "core/project/project.h"
#include "core/project/project_save.h"
#include "ui/document/document.h"
#include "ui/text/error_sentence.h"

#include <utility>

namespace dewpoint::ui {

ProjectSaver::ProjectSaver(Document& document, QObject* parent, ProjectWriter write)
    : QObject(parent), document_(document),
      write_(write ? std::move(write) : ProjectWriter(&saveProject)) {
  connect(&document_, &Document::projectReplaced, this, [this] { ++projectCount_; });
}

void ProjectSaver::save(const std::filesystem::path& file) {
  ++pendingWrites_;
  queue_.add(
      [this, file, write = write_, state = document_.sharedProject(), project = projectCount_] {
        const Status written = write(*state, file);
        return std::function<void()>([this, file, state, project, written] {
          --pendingWrites_;
          if (!written) {
            Q_EMIT failed(errorText(written.error()));
            return;
          }
          if (project == projectCount_) {
            document_.markSaved(*state, file);
          }
          Q_EMIT saved(QString::fromStdString(file.string()));
        });
      });
}

} // namespace dewpoint::ui
