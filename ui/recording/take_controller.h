// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/take/take_recorder.h"
#include "ui/jobs/background_job.h"
#include "ui/jobs/job_queue.h"
#include "ui/recording/take_dialog.h"
#include "ui/workbench/workbench.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <filesystem>
#include <memory>

class QLabel;

namespace dewpoint::ui {

/// Records the live cameras of the run: starts and stops takes (actionRecord), shows in the status
/// bar what has been recorded, and says where a take is. Number and notes of a take can be set
/// before it begins, and its notes also later (actionTakeNotes). A take may begin with
/// images from before its start. If the run tracks, its results are added to the take. A take goes
/// on while the run is paused or restarted; it ends when the project is closed or its cameras are
/// opened again. Closing the window completes it.
class TakeController : public QObject {
  Q_OBJECT
public:
  explicit TakeController(const Workbench& bench);

  bool isRecording() const { return recorder_ != nullptr; }
  /// Returns the folder in which the takes of the open project are: beside its file, or for an
  /// unsaved project in the user's folder for videos.
  std::filesystem::path takesFolder() const;
  /// Returns what the current take has recorded so far; empty while nothing is recorded.
  TakeStatus status() const;
  /// Starts a take for another program, unless one is in progress or no live cameras are open.
  /// `name` becomes its notes, unless the user has entered some for the next take.
  void startNamed(const QString& name);

Q_SIGNALS:
  /// Emitted when the first files of a take exist.
  void started();
  /// Emitted when the files of a take are complete.
  void stopped(const TakeStatus& take);
  /// Emitted when the user wants to open a take. `project` is its project file.
  void openRequested(const std::filesystem::path& project);

private:
  void toggle(bool record);
  /// Opens the dialog for the notes of a take; null: for number and notes of the next one.
  void editDetails(const std::shared_ptr<TakeRecorder>& take);
  void saveNotes(const std::shared_ptr<TakeRecorder>& take, const QString& notes);
  void start();
  void stop(const QString& reason);
  /// Returns the results of the run, which belong to the take that ends now; empty without a run.
  std::shared_ptr<const LiveRun> liveRun() const;
  void finish(const std::shared_ptr<TakeRecorder>& recorder, const QString& reason);
  /// Makes the cameras keep their last images as the preferences say.
  void keepPreRoll();
  /// Returns the options of the next take.
  TakeOptions nextOptions() const;
  void showStatus();
  void updateAction();

  Workbench bench_;
  QAction* action_;
  QLabel* label_;
  QTimer timer_; ///< updates the label
  BackgroundJob* job_;
  JobQueue* notesJobs_; ///< writes notes, one after the other
  std::shared_ptr<TakeRecorder> recorder_;
  TakeDetails next_; ///< of the next take
  QString name_;     ///< that another program gave the take that is starting; may be empty
  QString shownProblem_;
};

} // namespace dewpoint::ui
