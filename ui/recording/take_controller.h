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

/// Records the live cameras of the run: starts and stops takes (recordings of all cameras;
/// actionRecord), shows their progress in the status bar, and reports where they are stored. The
/// user can set the number and notes of a take before it begins, and change the notes later
/// (actionTakeNotes). A take may include images from before its start. The live results of the run
/// are added to the take. A take continues while the run is paused or restarted. It ends when the
/// project is closed, its cameras are opened again, or the window is closed.
class TakeController : public QObject {
  Q_OBJECT
public:
  explicit TakeController(const Workbench& bench);

  bool isRecording() const { return recorder_ != nullptr; }
  /// Returns the folder for the takes (recordings of all cameras) of the open project: beside the
  /// project file or, for an unsaved project, in the user's folder for videos.
  std::filesystem::path folderForTakes() const;
  /// Returns the state of the current take (a recording of all cameras in progress); an empty state
  /// while nothing is being recorded.
  TakeStatus status() const;
  /// Starts a take (a recording of all cameras) that another program requested. Does nothing if a
  /// take is in progress or no live cameras are open. `name` becomes the notes of the take, unless
  /// the user has entered notes for it.
  void startTakeNamed(const QString& name);

Q_SIGNALS:
  /// Emitted when a take (a recording of all cameras) has started and its first files exist.
  void started();
  /// Emitted when a take (a recording of all cameras) has ended and its files are complete.
  void stopped(const TakeStatus& take);
  /// Emitted when the user wants to open a take (a recording of all cameras). `project` is its
  /// project file.
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
