// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/jobs/background_job.h"
#include "ui/jobs/job_queue.h"
#include "ui/workbench/workbench.h"

#include <QObject>

#include <filesystem>

namespace dewpoint::ui {

/// Offers to compare a take (a recording of all cameras) with the results that were tracked live,
/// when a take with live results is opened as a project. The comparison tracks the take again in
/// the background, and a message reports whether the results are the same.
class TakeComparison : public QObject {
  Q_OBJECT
public:
  explicit TakeComparison(const Workbench& bench);

private:
  void offer();
  void compare(const std::filesystem::path& take);

  Workbench bench_;
  JobQueue* looking_; ///< looks whether a take has live results
  BackgroundJob* job_;
  QString question_;
  std::filesystem::path offered_; ///< project of the last offer, which is made once
};

} // namespace dewpoint::ui
