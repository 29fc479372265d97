// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/main_window.h"

#include "core/project/project.h"
#include "core/session/session.h"
#include "ui/actions/action_registry.h"
#include "ui/actions/window_actions.h"
#include "ui/calibration/manual/grid_layer.h"
#include "ui/cameraview/camera_view.h"
#include "ui/color/color_panel.h"
#include "ui/document/document.h"
#include "ui/mainwindow/camera_motion_alerts.h"
#include "ui/mainwindow/status_bar_panel.h"
#include "ui/panels/camera_panel.h"
#include "ui/panels/parameter_panel.h"
#include "ui/panels/target_panel.h"
#include "ui/people/people_panel.h"
#include "ui/plots/plot_panel.h"
#include "ui/selection/selection.h"
#include "ui/session/session_bridge.h"
#include "ui/start/recent_projects.h"
#include "ui/text/error_sentence.h"
#include "ui/timeline/timeline.h"
#include "ui/trajectory/box_panel.h"
#include "ui/trajectory/trajectory_panel.h"
#include "ui/view3d/birds_eye_view.h"
#include "ui/widgets/message_bar.h"

#include <QAction>
#include <QDockWidget>
#include <QRandomGenerator>
#include <QTimer>
#include <QUndoStack>

#include <algorithm>
#include <utility>

namespace dewpoint::ui {

namespace {

void rememberOpened(const Project& project) {
  if (!project.file.empty()) {
    addRecentProject(QString::fromStdString(project.file.string()));
  }
}

} // namespace

MainWindow::MainWindow(ProjectOpener opener, QWidget* parent)
    : QMainWindow(parent), loader_(new ProjectLoader(std::move(opener), this)),
      document_(new Document(this)), selection_(new Selection(this)),
      actions_(new ActionRegistry(this)) {
  setObjectName(QStringLiteral("mainWindow"));
  setDockNestingEnabled(true);
  declareWindowActions(*actions_);
  makeStart();
  makeDocks();
  makeToolBar();
  makeMenus();
  connectActions();
  connectPeople();
  connectRun();
  linkViews();
  makeBumps();
  setTheme(theme_);
  updateTitle();
  updateEnabled();
  resize(1400, 900);
  arrange();
  showStart(true);
  birdsEye_->prepare();
}

MainWindow::~MainWindow() {
  if (bridge_ != nullptr) {
    disconnect(bridge_, nullptr, this, nullptr);
  }
  document_->disconnect(this);
  document_->undoStack()->disconnect(this);
}

void MainWindow::connectRun() {
  connect(
      loader_, &ProjectLoader::opened, this,
      [this](const std::shared_ptr<SessionInputs>& inputs) { adoptInputs(std::move(*inputs)); });
  connect(loader_, &ProjectLoader::failed, this, [this](const QString& sentence) {
    opening_ = {};
    messages_->showError(sentence);
    Q_EMIT openFailed(sentence);
  });
  connect(loader_, &ProjectLoader::openingChanged, this, &MainWindow::updateEnabled);
  connect(document_, &Document::parameterChanged, this, [this] {
    if (bridge_ != nullptr) {
      bridge_->session().setParameters(document_->project().parameters);
    }
  });
  connect(document_, &Document::methodChanged, this, [this] { takeMethod(); });
  connect(document_, &Document::methodChanged, this, [this] {
    showFamily();
    sayWhatMethodNeeds();
  });
  connect(document_, &Document::targetsChanged, this, [this] {
    if (bridge_ != nullptr) {
      bridge_->session().setTargets(document_->project().targets);
    }
  });
  // Queued: what is being edited may be a view that goes with it.
  connect(document_, &Document::calibrationChanged, this, &MainWindow::takeCalibration,
          Qt::QueuedConnection);
  connectRooms();
  connect(document_, &Document::sourcesChanged, this, &MainWindow::reopen, Qt::QueuedConnection);
  connect(document_, &Document::replaced, this, &MainWindow::updateTitle);
  connect(document_, &Document::changed, this, &MainWindow::updateTitle);
  connect(document_, &Document::fileChanged, this, &MainWindow::updateTitle);
  connect(document_->undoStack(), &QUndoStack::cleanChanged, this,
          [this] { setWindowModified(document_->isUnsaved()); });
}

void MainWindow::takeMethod() {
  if (bridge_ == nullptr) {
    return;
  }
  const Project& project = document_->project();
  Session& session = bridge_->session();
  // Whoever looks at an earlier moment wants to see the other method from there; what was tracked
  // of a recording is tracked again.
  const bool tracked = shown_ && shown_->frameCount && shown_->history.head >= 0;
  if (selection_->isPast() || tracked) {
    session.setMethodFrom(selection_->isPast() ? selection_->moment() : 0, project.method,
                          project.parameters);
  } else {
    session.setMethod(project.method, project.parameters);
  }
}

void MainWindow::openProject(const std::filesystem::path& file) {
  opening_ = {};
  loader_->open(file);
}

void MainWindow::reopen() {
  // A project that is being opened takes the place of this one anyway.
  if (bridge_ != nullptr && (!loader_->isOpening() || opening_.keepHistory)) {
    opening_ = {};
    opening_.keepHistory = true;
    loader_->open(document_->project());
  }
}

void MainWindow::adoptInputs(SessionInputs inputs) {
  if (bridge_ != nullptr) {
    loader_->retire(bridge_->release());
    delete std::exchange(bridge_, nullptr);
  }
  clearViews();
  const Opening opening = std::exchange(opening_, {});
  messages_->forget(!opening.keepHistory);
  if (!opening.keepHistory) {
    document_->replace(inputs.project, opening.unsaved);
    rememberOpened(inputs.project);
  }
  if (opening.recovered) {
    recovery_->take(*opening.recovered);
  }
  // The panels have just been filled; the views come with the next turn of the event loop, so that
  // neither holds it for long.
  QTimer::singleShot(0, this,
                     [this, opening, shared = std::make_shared<SessionInputs>(std::move(inputs))] {
                       startSession(std::move(*shared), opening.unsaved);
                       if (!opening.note.isEmpty()) {
                         messages_->showNotice(opening.note);
                       }
                     });
}

void MainWindow::startSession(SessionInputs inputs, bool unsaved) {
  // Without a target a recording waits for the click instead of running away.
  const bool wantsTarget =
      inputs.project.targets.empty() && methodFamily(inputs.project.method) != MethodFamily::People;
  const bool waits = unsaved || (wantsTarget && !inputs.source->isLive());
  bridge_ = new SessionBridge(std::move(inputs), this);
  connect(bridge_, &SessionBridge::snapshotChanged, this, &MainWindow::showSnapshot);
  trajectory_->follow([session = &bridge_->session()](auto& generation, auto& position) {
    return session->samplesSince(generation, position);
  });
  showStart(false);
  trajectory_->boxes().follow([session = &bridge_->session()](auto& generation, auto& position) {
    return session->boxesSince(generation, position);
  });
  makeCameraDocks();
  bridge_->session().setMasksWanted(action("actionShowMask")->isChecked());
  bridge_->session().setLikelihoodMapsWanted(action("actionShowEvidence")->isChecked());
  bridge_->session().setShapesWanted(action("actionShowVolumes")->isChecked());
  updateEnabled();
  showFamily();
  showSnapshot(bridge_->session().newest());
  if (playOnOpen_ && !waits) {
    bridge_->session().play();
  } else {
    bridge_->session().stepFrame(); // something to look at
  }
  Q_EMIT projectOpened();
}

void MainWindow::clearViews() {
  trajectory_->follow({}); // first: what follows may make them look at the run, which is gone
  trajectory_->boxes().follow({});
  layoutBehindPages_.clear();
  shown_.reset();
  cameras_->setSnapshot({});
  people_->show(TrackSnapshotPtr());
  selection_->clear();
  logGeneration_ = 0;
  logPosition_ = 0;
  noticesShown_ = 0;
  bumps_->clear();
  figures_->clear();
  frameGeneration_ = 0;
  framePosition_ = 0;
  plot_->clear();
  timeline_->clear();
  birdsEye_->show(TrackSnapshotPtr());
}

void MainWindow::showSnapshot(const TrackSnapshotPtr& snapshot) {
  shown_ = snapshot;
  const TrackSnapshotPtr seen = bridge_->asSeen(snapshot);
  for (CameraView* view : cameraViews_) {
    view->show(seen);
  }
  for (GridLayer* layer : gridLayers_) {
    layer->setSnapshot(seen);
  }
  birdsEye_->show(snapshot);
  color_->setSnapshot(seen);
  cameras_->setSnapshot(seen);
  targets_->show(*snapshot);
  people_->show(snapshot);
  plot_->show(*snapshot);
  trajectory_->show(*snapshot);
  snapshot->state == PlayState::Playing
      ? actions_->rename(action("actionPlay"), QT_TRANSLATE_NOOP("Actions", "Pause"), "pause")
      : actions_->rename(action("actionPlay"), QT_TRANSLATE_NOOP("Actions", "Play"), "play");
  pullLog();
  showMoment(*snapshot);
  showNotices(*snapshot);
  Q_EMIT snapshotShown(snapshot);
}

void MainWindow::pullLog() {
  const Session::LogPiece piece = bridge_->session().logSince(logGeneration_, logPosition_);
  if (piece.restarted) {
    plot_->clear();
  }
  plot_->append(piece.records);
  trajectory_->refresh();
}

void MainWindow::showNotices(const TrackSnapshot& snapshot) {
  const std::size_t count =
      snapshot.notices.size() - std::min(snapshot.bumps.size(), snapshot.notices.size());
  if (count > noticesShown_) {
    messages_->showNotice(errorSentence(snapshot.notices[count - 1]));
  }
  noticesShown_ = count;
  bumps_->show(snapshot);
}

void MainWindow::trackLearned(int target, bool isNew) {
  targets_->choose(target);
  if (followsBoxes()) {
    targetDock_->raise();
    // From a frame that was tracked already it is tracked again by itself, up to where the run
    // stands; at the end there is nothing to play.
    const bool again = shown_ && shown_->past && shown_->frame <= shown_->history.head;
    // Only the first of all boxes plays: more of them are given on the same image, and a run that
    // a person has stopped stays where it is.
    const auto& targets = document_->project().targets;
    const auto hasBox = [](const Target& one) { return one.box.has_value(); };
    const bool only =
        std::ranges::count_if(targets, hasBox) == 1 && shown_ && shown_->history.head <= 0;
    if (bridge_ != nullptr && shown_ && shown_->state == PlayState::Paused && isNew && only &&
        !again) {
      bridge_->session().play();
    }
    return;
  }
  colorDock_->raise();
  action("actionShowMask")->setChecked(true);
  // The first click starts tracking; a sample more or less takes no run away.
  if (bridge_ != nullptr && shown_ && shown_->state != PlayState::Playing && isNew) {
    togglePlay(); // at the end: from the beginning
  }
}

void MainWindow::togglePlay() {
  if (bridge_ == nullptr) {
    return;
  }
  Session& session = bridge_->session();
  const PlayState state = shown_ ? shown_->state : PlayState::Paused;
  if (state == PlayState::Playing) {
    session.pause();
    return;
  }
  if (state == PlayState::Ended) {
    session.restart();
  }
  session.play();
}

void MainWindow::restart(bool newSeed) {
  if (bridge_ == nullptr) {
    return;
  }
  if (newSeed) {
    // 31 bits: short enough to be read out and typed.
    bridge_->session().restart(QRandomGenerator::global()->generate() >> 1U);
  } else {
    bridge_->session().restart();
  }
}

QAction* MainWindow::action(const char* id) const {
  return actions_->action(id);
}

void MainWindow::updateTitle() {
  const QString name = QString::fromStdString(document_->project().name);
  setWindowTitle(name.isEmpty() ? tr("Dewpoint") : tr("%1[*] – Dewpoint").arg(name));
  setWindowModified(document_->isUnsaved());
}

void MainWindow::updateEnabled() {
  const bool running = bridge_ != nullptr;
  for (const char* id : {"actionPlay",
                         "actionNextFrame",
                         "actionNextIteration",
                         "actionRestart",
                         "actionRestartNewSeed",
                         "actionShowMask",
                         "actionShowEvidence",
                         "actionPreviousFrame",
                         "actionRerun",
                         "actionAddMark",
                         "actionRemoveMark",
                         "actionPreviousMark",
                         "actionNextMark",
                         "actionZoomToSpan",
                         "actionSave",
                         "actionSaveAs",
                         "actionExportTrajectory",
                         "actionCloseProject",
                         "actionCalibrateByHand",
                         "actionCalibrateWand",
                         "actionImportCalibration",
                         "actionExportCalibration",
                         "actionPlanRig",
                         "actionShowMap",
                         "actionPlanCamera",
                         "actionFindPlace",
                         "actionResolveCamera",
                         "actionCalibrateBoard",
                         "actionRemoveTarget",
                         "actionSavePicture",
                         "actionAddTarget",
                         "actionLearnColor",
                         "actionResetLayout"}) {
    action(id)->setEnabled(running);
  }
  if (!running) {
    action("actionNow")->setEnabled(false); // else the moment shown decides
  }
  suitMethod();
  action("actionOpen")->setEnabled(!loader_->isOpening());
  action("actionOpenDemo")->setEnabled(!loader_->isOpening());
}

void MainWindow::setTheme(Theme theme) {
  theme_ = theme;
  applyTheme(theme);
  actions_->drawIcons(themePalette(isDark(theme)));
  QAction* chosen = action(theme == Theme::Light  ? "actionThemeLight"
                           : theme == Theme::Dark ? "actionThemeDark"
                                                  : "actionThemeSystem");
  chosen->setChecked(true);
}

} // namespace dewpoint::ui
