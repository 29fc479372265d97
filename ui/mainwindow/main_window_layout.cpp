// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/session/session.h"
#include "ui/birdseye/birds_eye_view.h"
#include "ui/bridge/session_bridge.h"
#include "ui/camera/camera_view.h"
#include "ui/document/document.h"
#include "ui/mainwindow/dock_title.h"
#include "ui/mainwindow/main_window.h"
#include "ui/mainwindow/message_bar.h"
#include "ui/mainwindow/status_figures.h"
#include "ui/plots/convergence_plot.h"
#include "ui/settings/parameter_panel.h"
#include "ui/transport/transport_actions.h"

#include <QAction>
#include <QDockWidget>
#include <QMenuBar>
#include <QScrollArea>
#include <QSettings>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <QUndoStack>

#include <algorithm>

namespace dewpoint {

QDockWidget* MainWindow::makeDock(const QString& name, const QString& title, QWidget* content) {
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(name);
  dock->setWidget(content);
  dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable);
  auto* bar = new DockTitle(dock);
  dock->setTitleBarWidget(bar);
  connect(bar, &DockTitle::maximizeWanted, this, [this, dock] { toggleMaximized(dock); });
  return dock;
}

void MainWindow::makeDocks() {
  birdsEye_ = new BirdsEyeView(this);
  birdsEye_->setObjectName(QStringLiteral("birdsEyeView"));
  birdsEyeDock_ = makeDock(QStringLiteral("birdsEyeDock"), tr("Bird's-eye view"), birdsEye_);
  plot_ = new ConvergencePlot(this);
  plotDock_ = makeDock(QStringLiteral("plotDock"), tr("Convergence"), plot_);

  parameters_ = new ParameterPanel(*document_, this);
  auto* scroll = new QScrollArea(this);
  scroll->setObjectName(QStringLiteral("parameterScroll"));
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(276);
  scroll->setWidget(parameters_);
  parameterDock_ = makeDock(QStringLiteral("parameterDock"), tr("Parameters"), scroll);
  // The dock itself too: with a title bar of our own its minimum does not follow its content's.
  parameterDock_->setMinimumWidth(scroll->minimumWidth());

  figures_ = new StatusFigures(this);
  statusBar()->setSizeGripEnabled(false);
  statusBar()->addWidget(figures_, 1);
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
  const auto& cameras = document_->project().cameras;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    auto* view = new CameraView(static_cast<int>(i), this);
    const QString given = QString::fromStdString(cameras[i].camera.name);
    auto* dock = makeDock(QStringLiteral("cameraDock%1").arg(i),
                          given.isEmpty() ? tr("Camera %1").arg(i + 1) : given, view);
    auto* bar = static_cast<DockTitle*>(dock->titleBarWidget());
    bar->setState(view->state());
    connect(view, &CameraView::stateChanged, bar, &DockTitle::setState);
    view->setMaskShown(actions_->showMask->isChecked());
    cameraDocks_.push_back(dock);
    cameraViews_.push_back(view);
  }
  arrange();
}

void MainWindow::arrange() {
  addDockWidget(Qt::BottomDockWidgetArea, plotDock_);
  addDockWidget(Qt::LeftDockWidgetArea, birdsEyeDock_);
  if (!cameraDocks_.empty()) {
    // Cameras stand to the left of the bird's-eye view, in as many columns as keep them near
    // square.
    const std::size_t count = cameraDocks_.size();
    const std::size_t columns = count <= 3 ? 1 : count <= 8 ? 2 : 3;
    removeDockWidget(birdsEyeDock_);
    addDockWidget(Qt::LeftDockWidgetArea, cameraDocks_.front());
    splitDockWidget(cameraDocks_.front(), birdsEyeDock_, Qt::Horizontal);
    birdsEyeDock_->show();
    for (std::size_t i = 1; i < std::min(columns, count); ++i) {
      splitDockWidget(cameraDocks_[i - 1], cameraDocks_[i], Qt::Horizontal);
    }
    for (std::size_t i = columns; i < count; ++i) {
      splitDockWidget(cameraDocks_[i - columns], cameraDocks_[i], Qt::Vertical);
    }
  }
  splitDockWidget(birdsEyeDock_, parameterDock_, Qt::Horizontal);
  // The sizes can be given only once the layout has settled.
  QMetaObject::invokeMethod(this, &MainWindow::shareSpace, Qt::QueuedConnection);
}

void MainWindow::shareSpace() {
  const int inner = width() - parameterDock_->minimumSizeHint().width();
  QList<QDockWidget*> row{birdsEyeDock_, parameterDock_};
  QList<int> widths{inner, parameterDock_->minimumSizeHint().width()};
  if (!cameraDocks_.empty()) {
    row.prepend(cameraDocks_.front());
    widths.prepend(inner * 38 / 100);
    widths[1] = inner - widths.front();
  }
  resizeDocks(row, widths, Qt::Horizontal);
  const int plotHeight = height() * 22 / 100;
  resizeDocks({birdsEyeDock_, plotDock_}, {height() - plotHeight, plotHeight}, Qt::Vertical);
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
  QToolBar* bar = addToolBar(tr("Transport"));
  bar->setObjectName(QStringLiteral("transportBar"));
  bar->setMovable(false);
  bar->setIconSize({20, 20});
  bar->setContextMenuPolicy(Qt::PreventContextMenu);
  QAction* undo = document_->undoStack()->createUndoAction(this, tr("Undo"));
  QAction* redo = document_->undoStack()->createRedoAction(this, tr("Redo"));
  undo->setObjectName(QStringLiteral("actionUndo"));
  redo->setObjectName(QStringLiteral("actionRedo"));
  actions_->adopt(undo, QStringLiteral("undo"), QKeySequence::Undo);
  actions_->adopt(redo, QStringLiteral("redo"), QKeySequence::Redo);
  const std::vector<QAction*> shown{actions_->play,
                                    actions_->nextFrame,
                                    actions_->nextIteration,
                                    nullptr,
                                    actions_->restart,
                                    actions_->restartNewSeed,
                                    nullptr,
                                    actions_->showMask,
                                    nullptr,
                                    undo,
                                    redo,
                                    nullptr,
                                    actions_->openProject,
                                    actions_->save,
                                    actions_->exportTrajectory};
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
  for (QAction* action : {actions_->play, actions_->nextFrame, actions_->nextIteration}) {
    static_cast<QToolButton*>(bar->widgetForAction(action))
        ->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  }
  bar->widgetForAction(actions_->play)
      ->setMinimumWidth(bar->fontMetrics().horizontalAdvance(tr("Pause")) + 40);

  addToolBarBreak();
  QToolBar* messageRow = addToolBar(tr("Message"));
  messageRow->setObjectName(QStringLiteral("messageRow"));
  messageRow->setMovable(false);
  messageRow->setContextMenuPolicy(Qt::PreventContextMenu);
  messages_ = new MessageBar(this);
  messageRow->addWidget(messages_);
  messageRow->hide();
  connect(messages_, &MessageBar::wanted, messageRow, &QWidget::setVisible);
}

void MainWindow::makeMenus() {
  const auto fill = [](QMenu* menu, const char* name, const std::vector<QAction*>& entries) {
    menu->setObjectName(QLatin1String(name));
    for (QAction* entry : entries) {
      entry == nullptr ? (void)menu->addSeparator() : menu->addAction(entry);
    }
  };
  menuBar()->setObjectName(QStringLiteral("menuBar"));
  fill(menuBar()->addMenu(tr("&Project")), "menuProject",
       {actions_->openProject, actions_->openDemo, nullptr, actions_->save, actions_->saveAs,
        nullptr, actions_->exportTrajectory, nullptr, actions_->quit});
  fill(menuBar()->addMenu(tr("&Edit")), "menuEdit",
       {findChild<QAction*>(QStringLiteral("actionUndo")),
        findChild<QAction*>(QStringLiteral("actionRedo"))});
  fill(menuBar()->addMenu(tr("&Run")), "menuRun",
       {actions_->play, actions_->nextFrame, actions_->nextIteration, nullptr, actions_->restart,
        actions_->restartNewSeed});
  QMenu* view = menuBar()->addMenu(tr("&View"));
  fill(view, "menuView",
       {actions_->showMask, nullptr, actions_->lookFromAbove, actions_->lookFromFront,
        actions_->lookFree, nullptr});
  fill(view->addMenu(tr("Colors")), "menuColors",
       {actions_->themeSystem, actions_->themeLight, actions_->themeDark});
}

void MainWindow::connectActions() {
  const auto on = [this](QAction* action, auto&& run) {
    connect(action, &QAction::triggered, this, std::forward<decltype(run)>(run));
  };
  on(actions_->play, [this] { togglePlay(); });
  on(actions_->nextFrame, [this] { bridge_->session().stepFrame(); });
  on(actions_->nextIteration, [this] { bridge_->session().stepIteration(); });
  on(actions_->restart, [this] { restart(false); });
  on(actions_->restartNewSeed, [this] { restart(true); });
  connect(actions_->showMask, &QAction::toggled, this, [this](bool shown) {
    if (bridge_ != nullptr) {
      bridge_->session().setMasksWanted(shown);
    }
    for (CameraView* camera : cameraViews_) {
      camera->setMaskShown(shown);
    }
  });
  on(actions_->lookFromAbove, [this] { birdsEye_->lookFromAbove(); });
  on(actions_->lookFromFront, [this] { birdsEye_->lookFromFront(); });
  on(actions_->lookFree, [this] { birdsEye_->lookFree(); });
  on(actions_->openProject, [this] { askOpen(); });
  on(actions_->openDemo, [this] {
    if (mayDiscard()) {
      openProject({});
    }
  });
  on(actions_->save, [this] { save(); });
  on(actions_->saveAs, [this] { askSaveAs(); });
  on(actions_->exportTrajectory, [this] { exportTrajectory(); });
  on(actions_->quit, [this] { close(); });
  const auto onTheme = [this, on](QAction* action, Theme theme) {
    on(action, [this, theme] {
      setTheme(theme);
      QSettings().setValue(QStringLiteral("theme"), themeName(theme));
    });
  };
  onTheme(actions_->themeSystem, Theme::System);
  onTheme(actions_->themeLight, Theme::Light);
  onTheme(actions_->themeDark, Theme::Dark);
}

} // namespace dewpoint
