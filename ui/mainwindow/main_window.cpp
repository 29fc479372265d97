// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/main_window.h"

#include "core/project/project.h"
#include "ui/actions/action_registry.h"
#include "ui/actions/window_actions.h"
#include "ui/broadcast/output_controller.h"
#include "ui/calibration/board/board_installer.h"
#include "ui/calibration/calibration_mode.h"
#include "ui/calibration/exchange/exchange_installer.h"
#include "ui/calibration/guide/guide_installer.h"
#include "ui/calibration/manual/manual_installer.h"
#include "ui/calibration/planner/planner_installer.h"
#include "ui/calibration/wand/wand_installer.h"
#include "ui/calibration/world/world_installer.h"
#include "ui/cameras/cameras_installer.h"
#include "ui/cameraview/camera_docks.h"
#include "ui/cameraview/image_pick_tool.h"
#include "ui/color/color_dock.h"
#include "ui/color/color_panel.h"
#include "ui/correction/correction_mode.h"
#include "ui/document/camera_list_model.h"
#include "ui/document/document.h"
#include "ui/document/target_list_model.h"
#include "ui/experiments/experiment_installer.h"
#include "ui/export/export_installer.h"
#include "ui/export/video_installer.h"
#include "ui/help/crash_reports.h"
#include "ui/help/help_installer.h"
#include "ui/mainwindow/history_dock.h"
#include "ui/mainwindow/old_results_offer.h"
#include "ui/mainwindow/project_controller.h"
#include "ui/mainwindow/run_actions.h"
#include "ui/mainwindow/run_alerts.h"
#include "ui/mainwindow/run_writer.h"
#include "ui/mainwindow/status_bar_panel.h"
#include "ui/mainwindow/transport_bar.h"
#include "ui/mainwindow/view_pictures.h"
#include "ui/mainwindow/window_menus.h"
#include "ui/mainwindow/window_themes.h"
#include "ui/panels/inspector_docks.h"
#include "ui/people/people_dock.h"
#include "ui/plots/plot_dock.h"
#include "ui/plots/plot_panel.h"
#include "ui/plots/plot_stack.h"
#include "ui/recording/take_controller.h"
#include "ui/selection/selection.h"
#include "ui/text/language.h"
#include "ui/timeline/timeline.h"
#include "ui/timeline/timeline_dock.h"
#include "ui/trajectory/trajectory_dock.h"
#include "ui/trajectory/trajectory_panel.h"
#include "ui/view3d/birds_eye_dock.h"
#include "ui/view3d/birds_eye_view.h"
#include "ui/widgets/message_bar.h"
#include "ui/widgets/message_row.h"
#include "ui/widgets/notice_list.h"
#include "ui/workbench/dock_manager.h"
#include "ui/workbench/workbench.h"

#include <QAction>
#include <QCloseEvent>
#include <QDropEvent>
#include <QStatusBar>
#include <QUndoStack>

#include <optional>
#include <utility>

namespace dewpoint::ui {

namespace {

/// The pointer's place in time is shown wherever there is a time axis.
void shareCursor(PlotStack& plots, PlotStack& trajectory, Timeline* timeline) {
  plots.shareCursor(trajectory);
  for (PlotStack* stack : {&plots, &trajectory}) {
    QObject::connect(stack, &PlotStack::frameHovered, timeline, &Timeline::setHoveredFrame);
    QObject::connect(timeline, &Timeline::frameHovered, stack, [stack](qint64 frame) {
      stack->setHoveredFrame(frame < 0 ? std::nullopt : std::optional<std::int64_t>(frame));
    });
  }
}

} // namespace

MainWindow::MainWindow(ProjectOpener opener, QWidget* parent)
    : QMainWindow(parent), document_(new Document(this)),
      cameraList_(new CameraListModel(*document_, this)),
      targetList_(new TargetListModel(*document_, this)), selection_(new Selection(this)),
      session_(new SessionController(std::move(opener), *document_, *selection_, this)),
      actions_(new ActionRegistry(this)),
      docks_(new DockManager(*this, *document_, *session_, this)), messages_(new MessageBar(this)),
      notices_(new NoticeList(this)),
      bench_(new Workbench{*this, *actions_, *document_, *cameraList_, *targetList_, *selection_,
                           *session_, *docks_, *messages_}),
      runWriter_(new RunWriter(*bench_)) {
  setObjectName(QStringLiteral("mainWindow"));
  declareWindowActions(*actions_);
  themes_ = new WindowThemes(*bench_);
  installFeatures();
  setTheme(Theme::System);
  updateTitle();
  resize(1400, 900);
  docks_->layOut();
  projects_->showStartPage();
}

MainWindow::~MainWindow() {
  // Children go in the order they came, and these speak while others that listen are half gone.
  document_->blockSignals(true);
  document_->undoStack()->blockSignals(true);
}

void MainWindow::installFeatures() {
  const Workbench& bench = *bench_;
  projects_ = new ProjectController(bench);
  new ViewPictures(bench);
  auto* cameras = new CameraDocks(bench);
  BirdsEyeView* birdsEye = installBirdsEyeView(bench);
  PlotPanel* plots = installPlots(bench);
  TrajectoryPanel* trajectory = installTrajectory(bench, *birdsEye);
  Timeline* timeline = installTimeline(bench);
  shareCursor(plots->stack(), trajectory->plots(), timeline);
  installParameters(bench);
  const TargetDock targets = installTargets(bench);
  installCameras(bench);
  auto* color = new ColorDock(bench, *cameras, targets);
  auto* people = new PeopleDock(bench, *cameras, *birdsEye, {targets.dock, color->dock()});
  connect(&cameras->pickTool(), &ImagePickTool::imageClicked, people, &PeopleDock::selectPersonAt);
  new CorrectionMode(bench, *cameras, *birdsEye, *trajectory);
  auto* calibration = new CalibrationMode(bench);
  connect(calibration, &CalibrationMode::pageShown, &color->panel(),
          [panel = &color->panel()](const QString& page) {
            panel->setClicksUsedElsewhere(!page.isEmpty());
          });
  installCalibrationGuide(bench, *calibration);
  installManualCalibration(bench, *calibration, *cameras);
  installBoardCalibration(bench, *calibration, *cameras);
  installWandCalibration(bench, *calibration);
  installWorldPage(bench, *calibration, *cameras);
  new PlannerInstaller(bench, *calibration, *birdsEye);
  installCalibrationExchange(bench);
  installExport(bench, *timeline);
  installVideoExport(bench, *timeline);
  installExperiments(bench);
  installCameraSources(bench);
  auto* outputs = new OutputController(bench);
  auto* takes = new TakeController(bench);
  connect(outputs, &OutputController::recordingRequested, takes, &TakeController::startTakeNamed);
  connect(takes, &TakeController::openRequested, this, &MainWindow::openProject);
  new RunAlerts(bench, *notices_, *calibration);
  new OldResultsOffer(bench);
  installRunActions(bench);
  history_ = new HistoryDock(bench);
  menus_ = new WindowMenus(bench, {[this](QMenu* menu) { projects_->fillRecentMenu(menu); },
                                   [this](const QString& language) { setLanguage(language); }});
  installStatusBar();
  installHelp(bench);
  installTransportBar(bench);
  messageRow_ = new MessageRow(messages_, notices_, this);
  placeMessageRow();
  connect(messageRow_, &MessageRow::heightAboutToChange, docks_,
          [this] { docks_->lockLowerDockHeights(true); });
  connect(messageRow_, &MessageRow::heightChanged, docks_,
          [this] { docks_->lockLowerDockHeights(false); });
  menus_->makeMenus();
  connectRun();
  birdsEye->prepareFirstImage();
}

void MainWindow::installStatusBar() {
  auto* figures = new StatusBarPanel(this);
  statusBar()->setSizeGripEnabled(false);
  statusBar()->addWidget(figures, 1);
  bench_->connectView(figures);
  connect(selection_, &Selection::targetSelected, figures, &StatusBarPanel::setTarget);
  connect(figures, &StatusBarPanel::frameClicked, bench_->action("actionGoToFrame"),
          &QAction::trigger);
  // While no views are shown there is nothing to measure.
  connect(docks_, &DockManager::viewsAboutToChange, figures, &QWidget::setVisible);
}

void MainWindow::connectRun() {
  connect(session_, &SessionController::opened, this, &MainWindow::projectOpened);
  connect(session_, &SessionController::openFailed, this, &MainWindow::openFailed);
  connect(session_, &SessionController::iterationsLogged, this,
          [this] { Q_EMIT snapshotShown(session_->shownSnapshot()); });
  connect(document_, &Document::projectReplaced, this, &MainWindow::updateTitle);
  connect(document_, &Document::changed, this, &MainWindow::updateTitle);
  connect(document_, &Document::fileChanged, this, &MainWindow::updateTitle);
  connect(document_->undoStack(), &QUndoStack::cleanChanged, this,
          [this] { setWindowModified(document_->isUnsaved()); });
  connect(docks_, &DockManager::viewsShownChanged, this, &MainWindow::placeMessageRow);
  connect(docks_, &DockManager::layoutChanged, this, &MainWindow::placeMessageRow);
  bench_->onTriggered("actionResetLayout", docks_, [this] { docks_->resetLayout(); });
  bench_->requireRun({"actionResetLayout"});
  bench_->onTriggered("actionQuit", this, [this] { close(); });
  bench_->onToggled("actionFullScreen", this, [this](bool full) {
    setWindowState(full ? windowState() | Qt::WindowFullScreen
                        : windowState() & ~Qt::WindowFullScreen);
  });
}

void MainWindow::placeMessageRow() {
  // A layout that was saved before there was this row puts it anywhere.
  if (!toolBarBreak(messageRow_)) {
    removeToolBar(messageRow_);
    addToolBarBreak(Qt::TopToolBarArea);
    addToolBar(Qt::TopToolBarArea, messageRow_);
  }
  messageRow_->show();
}

void MainWindow::openProject(const std::filesystem::path& file) {
  projects_->open(file);
}

void MainWindow::setPlayOnOpen(bool play) {
  session_->setPlayOnOpen(play);
}

void MainWindow::enableRecovery(const std::filesystem::path& folder, TextWriter write) {
  projects_->enableRecovery(folder, std::move(write));
}

void MainWindow::offerCrashReports(const std::filesystem::path& folder) {
  new CrashReports(*bench_, folder);
}

ProjectSaver& MainWindow::saver() {
  return projects_->saver();
}

TrackSnapshotPtr MainWindow::shown() const {
  return session_->shownSnapshot();
}

void MainWindow::saveRun(const std::filesystem::path& folder, std::function<void(bool)> written) {
  runWriter_->write(folder, std::move(written));
}

void MainWindow::setTheme(Theme theme) {
  themes_->setTheme(theme);
}

Theme MainWindow::theme() const {
  return themes_->theme();
}

void MainWindow::restoreAndSaveGeometry() {
  keepsGeometry_ = true;
  restoreGeometry(Preferences().windowGeometry());
}

void MainWindow::setLanguage(const QString& language) {
  Preferences().setLanguage(language);
  useLanguage(language);
}

void MainWindow::updateTitle() {
  const QString name = QString::fromStdString(document_->project().name);
  setWindowTitle(name.isEmpty() ? tr("Dewpoint") : tr("%1[*] – Dewpoint").arg(name));
  setWindowModified(document_->isUnsaved());
}

void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) {
    actions_->retranslateUi();
    history_->updateActionTexts();
    updateTitle();
    menus_->makeMenus();
  } else if (event->type() == QEvent::WindowStateChange) {
    bench_->action("actionFullScreen")->setChecked(isFullScreen());
  }
}

bool MainWindow::focusNextPrevChild(bool next) {
  const QWidget* before = focusWidget();
  bool moved = QMainWindow::focusNextPrevChild(next);
  while (moved && focusWidget() != before && DockManager::isBehindOtherDocks(focusWidget())) {
    moved = QMainWindow::focusNextPrevChild(next);
  }
  return moved;
}

void MainWindow::closeEvent(QCloseEvent* event) {
  event->setAccepted(projects_->confirmClose());
  if (event->isAccepted() && keepsGeometry_) {
    Preferences().setWindowGeometry(saveGeometry());
  }
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (ProjectController::canDrop(*event->mimeData())) {
    event->setDropAction(Qt::CopyAction); // nobody's files are moved
    event->accept();
  }
}

void MainWindow::dropEvent(QDropEvent* event) {
  event->setDropAction(Qt::CopyAction);
  event->accept();
  projects_->drop(*event->mimeData());
}

} // namespace dewpoint::ui
