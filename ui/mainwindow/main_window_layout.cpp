// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/session/session.h"
#include "ui/actions/action_registry.h"
#include "ui/actions/command_palette.h"
#include "ui/calibration/board/board_layer.h"
#include "ui/calibration/manual/grid_layer.h"
#include "ui/cameraview/camera_view.h"
#include "ui/color/color_panel.h"
#include "ui/document/document.h"
#include "ui/mainwindow/main_window.h"
#include "ui/mainwindow/status_bar_panel.h"
#include "ui/panels/camera_panel.h"
#include "ui/panels/parameter_panel.h"
#include "ui/panels/target_panel.h"
#include "ui/people/add_person_tool.h"
#include "ui/people/people_panel.h"
#include "ui/plots/plot_panel.h"
#include "ui/selection/selection.h"
#include "ui/session/session_bridge.h"
#include "ui/text/retranslation.h"
#include "ui/trajectory/trajectory_panel.h"
#include "ui/view3d/birds_eye_view.h"
#include "ui/widgets/dock_title.h"
#include "ui/widgets/message_bar.h"

#include <QAction>
#include <QDockWidget>
#include <QScrollArea>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <QUndoStack>
#include <QUndoView>

#include <algorithm>

namespace dewpoint::ui {

namespace {
/// Property of docks: nothing of them is seen, because they lie behind another tab.
constexpr auto kBehind = "behind";
} // namespace

bool MainWindow::focusNextPrevChild(bool next) {
  const auto isBehind = [](const QWidget* widget) {
    for (; widget != nullptr; widget = widget->parentWidget()) {
      if (widget->property(kBehind).toBool()) {
        return true;
      }
    }
    return false;
  };
  const QWidget* before = focusWidget();
  bool moved = QMainWindow::focusNextPrevChild(next);
  while (moved && focusWidget() != before && isBehind(focusWidget())) {
    moved = QMainWindow::focusNextPrevChild(next);
  }
  return moved;
}

QDockWidget* MainWindow::makeDock(const QString& name, const std::function<QString()>& title,
                                  QWidget* content) {
  auto* dock = new QDockWidget(this);
  onRetranslate(dock, [dock, title] { dock->setWindowTitle(title()); });
  dock->setObjectName(name);
  dock->setWidget(content);
  dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable |
                    QDockWidget::DockWidgetClosable);
  connect(dock->toggleViewAction(), &QAction::triggered, dock,
          [dock](bool shown) { dock->setProperty("closedByChoice", !shown); });
  connect(dock, &QDockWidget::visibilityChanged, dock,
          [dock](bool seen) { dock->setProperty(kBehind, !seen); });
  auto* bar = new DockTitle(dock);
  dock->setTitleBarWidget(bar);
  addPictureMenu(dock, bar);
  connect(bar, &DockTitle::maximizeWanted, this, [this, dock] { toggleMaximized(dock); });
  return dock;
}

void MainWindow::makeDocks() {
  birdsEye_ = new BirdsEyeView(this);
  birdsEye_->setObjectName(QStringLiteral("birdsEyeView"));
  birdsEyeDock_ = makeDock(
      QStringLiteral("birdsEyeDock"), [] { return tr("Bird's-eye view"); }, birdsEye_);
  plot_ = new PlotPanel(*actions_, *selection_, this);
  plotDock_ = makeDock(
      QStringLiteral("plotDock"), [] { return tr("Plots"); }, plot_);
  auto* plotTitle = static_cast<DockTitle*>(plotDock_->titleBarWidget());
  plotTitle->addTool(plot_->makeTools(plotTitle));
  trajectory_ = new TrajectoryPanel(*actions_, *selection_, this);
  trajectoryDock_ = makeDock(
      QStringLiteral("trajectoryDock"), [] { return tr("Trajectory"); }, trajectory_);

  makeTimeline();
  makeInspector();
  makePeople();
  makeCalibration();
  auto* history = new QUndoView(document_->undoStack(), this);
  history->setObjectName(QStringLiteral("historyList"));
  history->setFrameShape(QFrame::NoFrame);
  onRetranslate(history, [history] {
    history->setEmptyLabel(tr("As it was opened"));
    history->setAccessibleName(tr("History of changes"));
  });
  historyDock_ = makeDock(
      QStringLiteral("historyDock"), [] { return tr("History"); }, history);
  historyDock_->setProperty("closedByChoice", true);

  palette_ = new CommandPalette(*actions_, this);
  palette_->setMore([this] { return moreForPalette(); });
  figures_ = new StatusBarPanel(this);
  onRetranslate(figures_, [this] {
    if (shown_) {
      figures_->show(*shown_, selection_->target());
    }
  });
  statusBar()->setSizeGripEnabled(false);
  statusBar()->addWidget(figures_, 1);
}

void MainWindow::makeInspector() {
  parameters_ = new ParameterPanel(*document_, this);
  auto* scroll = new QScrollArea(this);
  scroll->setObjectName(QStringLiteral("parameterScroll"));
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(324); // room for the names of all tabs
  scroll->setWidget(parameters_);
  parameterDock_ = makeDock(
      QStringLiteral("parameterDock"), [] { return tr("Parameters"); }, scroll);
  // The dock itself too: with a title bar of our own its minimum does not follow its content's.
  parameterDock_->setMinimumWidth(scroll->minimumWidth());

  targets_ = new TargetPanel(*document_, this);
  targetDock_ = makeDock(
      QStringLiteral("targetDock"), [] { return tr("Target"); }, targets_);
  cameras_ = new CameraPanel(*document_, this);
  cameraListDock_ = makeDock(
      QStringLiteral("cameraListDock"), [] { return tr("Cameras"); }, cameras_);
  connect(cameras_, &CameraPanel::calibrationWanted, this, &MainWindow::loadCalibrationOf);
  connect(cameras_, &CameraPanel::failed, this,
          [this](const QString& sentence) { messages_->showError(sentence); });
  color_ = new ColorPanel(*document_, this);
  auto* colorScroll = new QScrollArea(this);
  colorScroll->setObjectName(QStringLiteral("colorScroll"));
  colorScroll->setWidgetResizable(true);
  colorScroll->setFrameShape(QFrame::NoFrame);
  colorScroll->setWidget(color_);
  colorDock_ = makeDock(
      QStringLiteral("colorDock"), [] { return tr("Color"); }, colorScroll);
  connect(colorDock_, &QDockWidget::visibilityChanged, color_, &ColorPanel::setInFront);
  connect(color_, &ColorPanel::failed, this,
          [this](const QString& sentence) { messages_->showError(sentence); });
  connect(color_, &ColorPanel::pickingChanged, action("actionLearnColor"), &QAction::setChecked);
  connect(color_, &ColorPanel::learned, this, &MainWindow::trackLearned);
  connect(targets_, &TargetPanel::targetChosen, color_, &ColorPanel::setTarget);
  connect(targets_, &TargetPanel::targetChosen, selection_, &Selection::selectTarget);
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
}

void MainWindow::makeCameraDocks() {
  if (maximized_ != nullptr) {
    toggleMaximized(maximized_);
  }
  for (QDockWidget* dock : cameraDocks_) {
    removeDockWidget(dock);
    delete dock;
  }
  cameraDocks_.clear();
  cameraViews_.clear();
  gridLayers_.clear();
  const auto& cameras = document_->project().cameras;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    auto* view = new CameraView(static_cast<int>(i), this);
    const QString given = QString::fromStdString(cameras[i].camera.name);
    const auto title = [given, i] { return given.isEmpty() ? tr("Camera %1").arg(i + 1) : given; };
    auto* dock = makeDock(QStringLiteral("cameraDock%1").arg(i), title, view);
    auto* bar = static_cast<DockTitle*>(dock->titleBarWidget());
    bar->setState(view->state());
    connect(view, &CameraView::stateChanged, bar, &DockTitle::setState);
    view->setMaskShown(action("actionShowMask")->isChecked());
    color_->attach(static_cast<int>(i), view);
    gridLayers_.push_back(new GridLayer(static_cast<int>(i), view, *hand_, *points_));
    new BoardLayer(static_cast<int>(i), view, *board_);
    view->setEvidenceShown(action("actionShowEvidence")->isChecked());
    view->setChosenTarget(selection_->target());
    placer_->attach(static_cast<int>(i), view);
    cameraDocks_.push_back(dock);
    cameraViews_.push_back(view);
  }
  arrange();
  const auto layout =
      QByteArray::fromBase64(QByteArray::fromStdString(document_->project().layout));
  if (!layout.isEmpty()) {
    restoreState(layout);
  }
  showCalibration(action("actionCalibrateByHand")->isChecked()); // a mode, no part of the layout
  messages_->raise();
}

void MainWindow::keepLayout() {
  // What the views were before one filled the window, or a page took their place.
  const QByteArray layout = maximized_ != nullptr          ? layoutBeforeMaximized_
                            : layoutBehindPages_.isEmpty() ? saveState()
                                                           : layoutBehindPages_;
  document_->setLayout(layout.toBase64().toStdString());
}

void MainWindow::resetLayout() {
  document_->setLayout({});
  makeCameraDocks();
  showFamily();
  showSnapshot(shown_);
}

void MainWindow::arrange() {
  for (QDockWidget* dock : findChildren<QDockWidget*>()) {
    dock->setFloating(false);
    removeDockWidget(dock); // or splits and tabs would build on what was
  }
  addDockWidget(Qt::BottomDockWidgetArea, plotDock_);
  splitDockWidget(plotDock_, timelineDock_, Qt::Vertical);
  tabifyDockWidget(plotDock_, trajectoryDock_);
  addDockWidget(Qt::LeftDockWidgetArea, birdsEyeDock_);
  if (!cameraDocks_.empty()) {
    // Cameras stand to the left of the bird's-eye view, in as many columns as keep them near
    // square.
    const std::size_t count = cameraDocks_.size();
    const std::size_t columns = count <= 3 ? 1 : count <= 8 ? 2 : 3;
    removeDockWidget(birdsEyeDock_);
    addDockWidget(Qt::LeftDockWidgetArea, cameraDocks_.front());
    splitDockWidget(cameraDocks_.front(), birdsEyeDock_, Qt::Horizontal);
    for (std::size_t i = 1; i < std::min(columns, count); ++i) {
      splitDockWidget(cameraDocks_[i - 1], cameraDocks_[i], Qt::Horizontal);
    }
    for (std::size_t i = columns; i < count; ++i) {
      splitDockWidget(cameraDocks_[i - columns], cameraDocks_[i], Qt::Vertical);
    }
  }
  splitDockWidget(birdsEyeDock_, parameterDock_, Qt::Horizontal);
  splitDockWidget(parameterDock_, historyDock_, Qt::Vertical); // before there are tabs
  // The inspector: one tab for each kind of thing that can be looked into.
  for (QDockWidget* dock :
       {peopleDock_, targetDock_, colorDock_, cameraListDock_, calibrationDock_}) {
    tabifyDockWidget(parameterDock_, dock);
  }
  showViews(bridge_ != nullptr);
  parameterDock_->raise();
  plotDock_->raise();
  // The sizes can be given only once the layout has settled.
  QMetaObject::invokeMethod(this, &MainWindow::shareSpace, Qt::QueuedConnection);
}

void MainWindow::shareSpace() {
  const int inner = width() - parameterDock_->minimumSizeHint().width();
  QList<QDockWidget*> row{birdsEyeDock_, parameterDock_};
  QList<int> widths{inner, parameterDock_->minimumSizeHint().width()};
  if (!cameraDocks_.empty() && birdsEyeDock_->isHidden()) {
    row[0] = cameraDocks_.front();
  } else if (!cameraDocks_.empty()) {
    row.prepend(cameraDocks_.front());
    widths.prepend(inner * 38 / 100);
    widths[1] = inner - widths.front();
  }
  resizeDocks(row, widths, Qt::Horizontal);
  const int plotHeight = height() * 29 / 100;
  const int timelineHeight = timelineDock_->sizeHint().height();
  resizeDocks({row.front(), plotDock_, timelineDock_},
              {height() - plotHeight - timelineHeight, plotHeight, timelineHeight}, Qt::Vertical);
  QList<QDockWidget*> column(cameraDocks_.begin(), cameraDocks_.end());
  resizeDocks(column, QList<int>(column.size(), height() / 3), Qt::Vertical);
}

void MainWindow::toggleMaximized(QDockWidget* dock) {
  if (dock->isFloating()) {
    dock->setFloating(false);
    return;
  }
  const bool restoring = maximized_ != nullptr;
  for (QDockWidget* other : findChildren<QDockWidget*>()) {
    if (other != dock && !other->isFloating()) {
      other->setVisible(restoring);
    }
  }
  if (restoring) {
    restoreState(layoutBeforeMaximized_);
    maximized_ = nullptr;
  } else {
    layoutBeforeMaximized_ = saveState();
    maximized_ = dock;
  }
}

void MainWindow::makeToolBar() {
  QToolBar* bar = addToolBar(QString());
  onRetranslate(bar, [bar] { bar->setWindowTitle(tr("Transport")); });
  bar->setObjectName(QStringLiteral("transportBar"));
  bar->setMovable(false);
  bar->setIconSize({20, 20});
  bar->setContextMenuPolicy(Qt::PreventContextMenu);
  const std::vector<QAction*> shown{action("actionPlay"),
                                    action("actionPreviousFrame"),
                                    action("actionNextFrame"),
                                    action("actionNextIteration"),
                                    nullptr,
                                    action("actionNow"),
                                    action("actionRerun"),
                                    nullptr,
                                    action("actionRestart"),
                                    action("actionRestartNewSeed"),
                                    nullptr,
                                    action("actionLearnColor"),
                                    action("actionShowMask"),
                                    nullptr,
                                    action("actionUndo"),
                                    action("actionRedo"),
                                    nullptr,
                                    action("actionOpen"),
                                    action("actionSave"),
                                    action("actionExportTrajectory"),
                                    nullptr,
                                    action("actionPalette")};
  for (QAction* action : shown) {
    if (action == nullptr) {
      bar->addSeparator();
      continue;
    }
    bar->addAction(action);
    QWidget* button = bar->widgetForAction(action);
    button->setObjectName(action->objectName() + QStringLiteral("Button"));
    button->setFocusPolicy(Qt::NoFocus); // Space stays with play
  }
  for (QAction* action :
       {action("actionPlay"), action("actionNextFrame"), action("actionNextIteration")}) {
    static_cast<QToolButton*>(bar->widgetForAction(action))
        ->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  }
  bar->widgetForAction(action("actionPlay"))
      ->setMinimumWidth(bar->fontMetrics().horizontalAdvance(tr("Pause")) + 40);

  messages_ = new MessageBar(this);
  messages_->keepBelow(bar);
}

} // namespace dewpoint::ui
