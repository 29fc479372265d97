// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/jobs/job_queue.h"
#include "ui/workbench/workbench.h"

#include <filesystem>
#include <functional>

namespace dewpoint::ui {

/// Writes what a run leaves so far (RunRecord) into a folder, beside the window: one run after the
/// other, and also when the window closes meanwhile. What failed is shown in the window.
class RunWriter : public QObject {
  Q_OBJECT
public:
  explicit RunWriter(const Workbench& bench);

  /// `written` is called with whether it succeeded, in the thread that writes; with false at once
  /// when nothing is open.
  void write(const std::filesystem::path& folder, std::function<void(bool)> written);

private:
  Workbench bench_;
  JobQueue queue_;
};

} // namespace dewpoint::ui
