// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/playback_pace.h"
#include "ui/session/project_loader.h"

#include <QObject>
#include <QString>

#include <cstdint>
#include <memory>
#include <optional>

namespace dewpoint::project {
struct Project;
} // namespace dewpoint::project

namespace dewpoint::session {
struct TrackSnapshot;
} // namespace dewpoint::session

namespace dewpoint::ui {

class EmptyRoomLoader;
class Document;
class ResultKeeper;
class Selection;
class SessionBridge;
struct LoggedFrames;
struct LoggedIterations;
struct OpenRequest;
using TrackSnapshotPtr = std::shared_ptr<const TrackSnapshot>;

/// Controls the run of the window: opens and ends it, passes on changes of the document and the
/// selection, and gives the views their snapshots. Decides when a run starts to play, from which
/// frame on a new method applies, and whether a new calibration keeps the run or reopens it. The
/// ResultKeeper keeps results consistent with the settings.
class SessionController : public QObject {
  Q_OBJECT
public:
  SessionController(ProjectOpener opener, Document& document, Selection& selection,
                    QObject* parent = nullptr);
  ~SessionController() override;

  /// Opens the requested project in the background; `runStarted()` or `openFailed()` follows.
  void open(OpenRequest request);
  bool isOpening() const { return loader_->isOpening(); }
  /// Ends the run and clears the document, so that nothing is open.
  void close();
  /// Sets whether a project plays as soon as it is open.
  void setPlayOnOpen(bool play) { playOnOpen_ = play; }
  /// Function for other classes that open a project in their own thread.
  const ProjectOpener& opener() const { return loader_->opener(); }

  bool isRunning() const { return bridge_ != nullptr; }
  /// Running session; null while none is open.
  Session* session() const;
  /// Newest snapshot given to the views; null before the first.
  const TrackSnapshotPtr& shown() const { return shown_; }
  bool isPlaying() const;
  /// Returns a snapshot as camera views show it: live cameras that are late keep their last image.
  TrackSnapshotPtr withFilledFrames(const TrackSnapshotPtr& snapshot);

  /// Plays or pauses; at the end, plays from the beginning.
  void togglePlay();
  void play();
  /// Sets the playback speed of this run and of later ones.
  void setPace(const Pace& pace);
  const Pace& pace() const { return pace_; }
  /// Shows a frame; nothing: the current frame of the run.
  void show(std::optional<qint64> frame);
  /// Restarts the run from the beginning, with a new seed or the same one.
  void restart(bool newSeed);
  /// Applies the number of filter threads in the preferences to the run.
  void useFilterThreads();
  /// Tracks again from the current frame.
  void rerun();
  /// Keeper of the results, which knows those of earlier settings.
  ResultKeeper& results() { return *results_; }
  /// Starts the run after a color was learned, because a user who points at an object wants to see
  /// it tracked. A recording of which more than the beginning was tracked stays where it is, and
  /// the rule for changes applies.
  void startAfterLearning(bool isNew);
  /// Starts the run after a target got its box. Only the first box starts it: users often set more
  /// boxes on the same image, and a run that the user has stopped stays where it is.
  void startAfterBox(bool isNew);

Q_SIGNALS:
  void openingChanged(bool opening);
  /// A sentence that explains why the project was not opened.
  void openFailed(const QString& sentence);
  /// Opening may have failed because these files are missing; the request can be repeated with
  /// their new paths.
  void filesMissing(const OpenRequest& request, const MissingFiles& missing);
  /// The previous run has ended, and the document is about to change.
  void replacing(const OpenRequest& request);
  /// The document holds the opened project; the run starts with the next turn of the event loop.
  void replaced(const OpenRequest& request);
  /// A session exists: views are created and connected to it. The first snapshot follows.
  void runStarted();
  /// The run has started to play, or waits for the user.
  void opened(const OpenRequest& request);
  /// The run starts over from the beginning; earlier data are no longer shown.
  void restarting();
  /// The session has ended; `snapshotChanged()` with null follows.
  void runEnded();
  /// The user closed the project.
  void closed();
  /// Snapshot that the views show from now on; null: nothing, the run is over.
  void snapshotChanged(const TrackSnapshotPtr& snapshot);
  /// Records logged since the last signal, or all of them after a restart. Frames are sent before
  /// the snapshot that follows them, iterations after it.
  void framesLogged(const LoggedFrames& frames);
  void iterationsLogged(const LoggedIterations& iterations);
  /// A sentence that explains why a part of the project cannot be used.
  void failed(const QString& sentence);
  void paceChanged(const Pace& pace);

private:
  /// Read position in one of the logs of the session.
  struct LogCursor {
    std::uint64_t generation = 0;
    std::size_t position = 0;
  };
  void connectDocument();
  void applyOpened(const OpenRequest& request, const std::shared_ptr<SessionInputs>& inputs);
  /// Stores the image sizes reported by live cameras in the document.
  void takeSizes(const Project& opened);
  void start(const OpenRequest& request, SessionInputs inputs);
  void endRun();
  void publish(const TrackSnapshotPtr& snapshot);
  /// Drops what was to be done after frames are tracked again.
  void forgetRequests();
  void reopen();
  void applyMethod();
  void applyCalibration();

  ProjectLoader* loader_;
  EmptyRoomLoader* emptyRooms_;
  ResultKeeper* results_;
  Document& document_;
  Selection& selection_;
  SessionBridge* bridge_ = nullptr;
  int starts_ = 0; ///< counts starts and closings; an outdated start is skipped
  bool playOnOpen_ = true;
  Pace pace_;
  // Requests made while frames were tracked again, and carried out afterwards.
  bool playsWhenRenewed_ = false;
  std::optional<std::optional<qint64>> showsWhenRenewed_;
  TrackSnapshotPtr shown_;
  TrackSnapshotPtr filledFrom_; ///< snapshot that `filled_` was made from
  TrackSnapshotPtr filled_;
  LogCursor frames_;
  LogCursor iterations_;
};

} // namespace dewpoint::ui
