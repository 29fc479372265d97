// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/playback_pace.h"
#include "ui/session/project_loader.h"

#include <QObject>
#include <QString>

#include <cstdint>
#include <memory>
#include <optional>

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

/// The run of the window: opens it, ends it, passes on changes of the document and the selection,
/// and gives the views what they show. Decides when a run begins to play, from which frame on
/// another method holds, and whether another calibration keeps the run or opens it again; that
/// results are those of the settings shown is the work of the ResultKeeper.
class SessionController : public QObject {
  Q_OBJECT
public:
  SessionController(ProjectOpener opener, Document& document, Selection& selection,
                    QObject* parent = nullptr);
  ~SessionController() override;

  /// Opens in the background what is requested; runStarted() or openFailed() follow.
  void open(OpenRequest request);
  bool isOpening() const { return loader_->isOpening(); }
  /// Ends the run, and empties the document: nothing is open any more.
  void close();
  /// Whether a project plays as soon as it is open.
  void setPlayOnOpen(bool play) { playOnOpen_ = play; }
  /// For others that open a project in a thread of theirs.
  const ProjectOpener& opener() const { return loader_->opener(); }

  bool isRunning() const { return bridge_ != nullptr; }
  /// The running machine; null while none is open.
  Session* session() const;
  /// The newest snapshot that the views were given; null before the first.
  const TrackSnapshotPtr& shown() const { return shown_; }
  bool isPlaying() const;
  /// A snapshot as camera views show it: with the last images of live cameras that are late.
  TrackSnapshotPtr withFilledFrames(const TrackSnapshotPtr& snapshot);

  /// Plays or pauses; at the end, plays from the beginning.
  void togglePlay();
  void play();
  /// How fast this run and those to come are played.
  void setPace(const Pace& pace);
  const Pace& pace() const { return pace_; }
  /// Shows a frame, or where the run stands: nothing.
  void show(std::optional<qint64> frame);
  /// From the beginning, with another seed or the same.
  void restart(bool newSeed);
  /// The filter of the run goes on with as many threads as the preferences say.
  void useFilterThreads();
  /// Tracks again from the current frame.
  void rerun();
  /// Which results are of earlier settings.
  ResultKeeper& results() { return *results_; }
  /// The color of a target was learned: whoever points at an object to follow wants to see it
  /// tracked. A recording of which more was tracked than its beginning is left to the rule for
  /// changes, and stays where it is.
  void startAfterLearning(bool isNew);
  /// The same of a target's box. More boxes are given on the same image, and a run that the user
  /// has stopped stays where it is: only the first of all plays.
  void startAfterBox(bool isNew);

Q_SIGNALS:
  void openingChanged(bool opening);
  /// The sentence why nothing was opened.
  void openFailed(const QString& sentence);
  /// It may be because these files are not there: to open it again with where they are.
  void filesMissing(const OpenRequest& request, const MissingFiles& missing);
  /// The run before is gone, and the document is about to change.
  void replacing(const OpenRequest& request);
  /// The document holds what was opened; the run begins with the next turn of the event loop.
  void replaced(const OpenRequest& request);
  /// There is a session: views are made and connected to it. The first snapshot follows.
  void runStarted();
  /// The run has begun to play, or waits for the user.
  void opened(const OpenRequest& request);
  /// The run begins again from the beginning: nothing of what it was is shown any more.
  void restarting();
  /// The session is gone; snapshotChanged() with null follows.
  void runEnded();
  /// The user closed the project.
  void closed();
  /// What views show from now on; null: nothing, the run is over.
  void snapshotChanged(const TrackSnapshotPtr& snapshot);
  /// What was logged since the last time, all of it again after a restart. Frames come before the
  /// snapshot that follows them, iterations after it.
  void framesLogged(const LoggedFrames& frames);
  void iterationsLogged(const LoggedIterations& iterations);
  /// Something of the project cannot be used: the sentence why.
  void failed(const QString& sentence);
  void paceChanged(const Pace& pace);

private:
  /// How far one of the session's logs was read.
  struct LogCursor {
    std::uint64_t generation = 0;
    std::size_t position = 0;
  };
  void connectDocument();
  void applyOpened(const OpenRequest& request, const std::shared_ptr<SessionInputs>& inputs);
  /// The document takes the image sizes that live cameras were found to send.
  void takeSizes(const Project& opened);
  void start(const OpenRequest& request, SessionInputs inputs);
  void endRun();
  void publish(const TrackSnapshotPtr& snapshot);
  /// What was to come after frames are tracked again does not come.
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
  int starts_ = 0; ///< of runs, and closings: a start that was overtaken does not happen
  bool playOnOpen_ = true;
  Pace pace_;
  // Requested while frames were tracked again, and done after that.
  bool playsWhenRenewed_ = false;
  std::optional<std::optional<qint64>> showsWhenRenewed_;
  TrackSnapshotPtr shown_;
  TrackSnapshotPtr filledFrom_; ///< what filled_ was made of
  TrackSnapshotPtr filled_;
  LogCursor frames_;
  LogCursor iterations_;
};

} // namespace dewpoint::ui
