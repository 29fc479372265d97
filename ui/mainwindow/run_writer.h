// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/jobs/job_queue.h"
#include "ui/workbench/workbench.h"

#include <filesystem>
#include <functional>

namespace dewpoint::ui {

/// Writes the results of a run so far (`RunRecord`) to a folder in another thread. Runs are written
/// one after another, even if the window closes meanwhile. Errors are shown in the window.
class RunWriter : public QObject {
  Q_OBJECT
public:
  explicit RunWriter(const Workbench& bench);

  /// Writes the run to `folder`. `written` is called from the writing thread with true on success.
  /// If no project is open, `written` is called immediately with false.
  void write(const std::filesystem::path& folder, std::function<void(bool)> written);

private:
  Workbench bench_;
  JobQueue queue_;
};

} // namespace dewpoint::ui
