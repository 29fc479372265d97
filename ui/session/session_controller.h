// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/playback_pace.h"
#include "ui/session/project_loader.h"

#include <QObject>
#include <QString>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace dewpoint::capture {
class EncodedFeed;
} // namespace dewpoint::capture
namespace dewpoint::project {
struct Project;
} // namespace dewpoint::project

namespace dewpoint::session {
struct TrackSnapshot;
} // namespace dewpoint::session

namespace dewpoint::ui {

class BackgroundImageLoader;
class Document;
class ResultRefresher;
class Selection;
class SessionBridge;
struct LoggedFrames;
struct LoggedIterations;
struct OpenRequest;
using TrackSnapshotPtr = std::shared_ptr<const TrackSnapshot>;

/// Controls the run of the window: starts and ends the run, passes changes of the document and the
/// selection to it, and gives snapshots to the views. Decides when a run starts to play, from which
/// frame on a new method applies, and whether the run must be reopened for a new calibration. The
/// ResultRefresher keeps results consistent with the settings.
class SessionController : public QObject {
  Q_OBJECT
public:
  SessionController(ProjectOpener opener, Document& document, Selection& selection,
                    QObject* parent = nullptr);
  ~SessionController() override;

  /// Opens the requested project in the background. Emits `runStarted()` or `openFailed()`
  /// afterwards.
  void open(OpenRequest request);
  bool isOpening() const { return loader_->isOpening(); }
  /// Ends the run and clears the document, so that nothing is open.
  void close();
  /// Sets whether a project starts to play as soon as it is open.
  void setPlayOnOpen(bool play) { playOnOpen_ = play; }
  /// Returns the function with which other classes open a project in their own threads.
  const ProjectOpener& opener() const { return loader_->opener(); }

  bool isRunning() const { return bridge_ != nullptr; }
  /// Returns the running session, or null while none is open.
  Session* session() const;
  /// Returns the newest snapshot given to the views, or null before the first one.
  const TrackSnapshotPtr& shownSnapshot() const { return shown_; }
  bool isPlaying() const;
  /// Returns the encoded images of each live camera of the run, which TakeRecorder can record;
  /// empty for recordings.
  const std::vector<std::shared_ptr<capture::EncodedFeed>>& encodedFeeds() const { return feeds_; }
  /// Returns a snapshot for camera views, in which live cameras whose image is delayed keep their
  /// last image.
  TrackSnapshotPtr withMissingImagesFilled(const TrackSnapshotPtr& snapshot);

  /// Plays or pauses the run. At the end, plays from the beginning.
  void togglePlay();
  void play();
  /// Sets the playback speed of this run and of later runs.
  void setPace(const Pace& pace);
  const Pace& pace() const { return pace_; }
  /// Shows a frame. If `frame` is empty, shows the frame that the run is at.
  void showFrame(std::optional<qint64> frame);
  /// Restarts the run from the beginning, with a new seed or the same seed.
  void restart(bool newSeed);
  /// Applies the number of filter threads in the preferences to the run.
  void applyFilterThreadCount();
  /// Tracks frames again, from the frame shown on.
  void rerun();
  /// Returns the object that keeps results consistent with the settings, and that knows which
  /// results are from earlier settings.
  ResultRefresher& resultRefresher() { return *results_; }
  /// Starts the run after the color of a new target was learned, because a user who points at an
  /// object wants to see it tracked. Does nothing if `isNewTarget` is false (the target existed
  /// before). If more than the beginning of a recording has been tracked, the run stays at its
  /// current frame, and the ResultRefresher decides whether to track again. Emits
  /// `startedAtLaterFrame()` if the run does not start at the first frame of a recording.
  void startAfterLearning(bool isNewTarget);
  /// Starts the run after a target got its first box. A later box does not start the run, because
  /// users often set several boxes in the same image, and a run that the user has paused stays
  /// paused.
  void startAfterBoxDrawn(bool isFirstBox);

Q_SIGNALS:
  void openingChanged(bool opening);
  /// Emitted with a sentence that explains why the project was not opened.
  void openFailed(const QString& sentence);
  /// Emitted if opening may have failed because these files are missing. The request can be
  /// repeated with their new paths.
  void filesMissing(const OpenRequest& request, const MissingFiles& missing);
  /// Emitted when the previous run has ended and the document is about to change.
  void documentAboutToBeReplaced(const OpenRequest& request);
  /// Emitted when the document contains the opened project. The run starts in the next iteration of
  /// the event loop.
  void documentReplaced(const OpenRequest& request);
  /// Emitted when a session has been created. Views must now be created and connected to the
  /// session. The first snapshot follows.
  void runStarted();
  /// Emitted when opening a project is complete: the run has started to play, or waits for the user
  /// to start it.
  void opened(const OpenRequest& request);
  /// Emitted when the run is about to restart from the beginning. Earlier data are no longer shown.
  void runAboutToRestart();
  /// Emitted when the run has started at this frame because a target was learned there. The frames
  /// before it are not tracked.
  void startedAtLaterFrame(qint64 frame);
  /// Emitted when the session is about to end, while it still exists.
  void runAboutToEnd();
  /// Emitted when the session has ended. `snapshotChanged()` with null follows.
  void runEnded();
  /// Emitted when the user has closed the project.
  void closed();
  /// Emitted with the snapshot that the views show from now on. Null means that the run is over and
  /// nothing is shown.
  void snapshotChanged(const TrackSnapshotPtr& snapshot);
  /// Emitted with the records logged since the last signal, or with all records after a restart.
  /// The records of frames (framesLogged()) are emitted before each snapshot, those of filter
  /// iterations (iterationsLogged()) after it.
  void framesLogged(const LoggedFrames& frames);
  void iterationsLogged(const LoggedIterations& iterations);
  /// Emitted with a sentence that explains why part of the project cannot be used.
  void failed(const QString& sentence);
  void paceChanged(const Pace& pace);

private:
  /// Read position in one of the session's logs.
  struct LogCursor {
    std::uint64_t generation = 0;
    std::size_t position = 0;
  };
  void connectDocument();
  /// Returns whether the run has as many cameras as the document. If not, it is opened again soon
  /// with the document's cameras, and changes that name cameras by index are not for this run.
  bool followsDocument() const;
  void applyOpened(const OpenRequest& request, const std::shared_ptr<SessionInputs>& inputs);
  /// Stores the image sizes reported by live cameras in the document.
  void storeImageSizes(const Project& opened);
  void start(const OpenRequest& request, SessionInputs inputs);
  void endRun();
  void publish(const TrackSnapshotPtr& snapshot);
  /// Discards the requests to play and to show a frame that wait until frames have been tracked
  /// again.
  void discardRequests();
  void reopen();
  void applyMethod();
  void applyCalibration();

  ProjectLoader* loader_;
  BackgroundImageLoader* backgroundImageLoader_;
  ResultRefresher* results_;
  Document& document_;
  Selection& selection_;
  SessionBridge* bridge_ = nullptr;
  int starts_ = 0; ///< number of times a run was started or closed; outdated starts are skipped
  bool playOnOpen_ = true;
  Pace pace_;
  // Requests made while frames were tracked again. They are carried out afterwards.
  bool playWhenRefreshed_ = false;
  std::optional<std::optional<qint64>> showWhenRefreshed_;
  TrackSnapshotPtr shown_;
  TrackSnapshotPtr filledFrom_; ///< snapshot to which the last images of delayed cameras were
                                ///< added to make `filled_`
  TrackSnapshotPtr filled_;
  LogCursor frames_;
  LogCursor iterations_;
  std::vector<std::shared_ptr<capture::EncodedFeed>> feeds_;
  std::size_t cameraCount_ = 0; ///< number of cameras of the run
};

} // namespace dewpoint::ui
