// SPDX-License-Identifier: GPL-3.0-or-later
// Menus, and what each action does.
#include "core/session/session.h"
#include "ui/actions/action_registry.h"
#include "ui/actions/command_palette.h"
#include "ui/actions/shortcut_editor.h"
#include "ui/cameraview/camera_view.h"
#include "ui/color/color_panel.h"
#include "ui/document/document.h"
#include "ui/mainwindow/main_window.h"
#include "ui/panels/target_panel.h"
#include "ui/session/session_bridge.h"
#include "ui/text/language.h"
#include "ui/view3d/birds_eye_view.h"

#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QEvent>
#include <QLocale>
#include <QMenuBar>
#include <QSettings>
#include <QUndoStack>

namespace dewpoint::ui {

void MainWindow::makeMenus() {
  qDeleteAll(menuBar()->findChildren<QMenu*>(Qt::FindDirectChildrenOnly));
  menuBar()->clear();
  menuBar()->setObjectName(QStringLiteral("menuBar"));
  const auto add = [this](const QString& title, const char* name,
                          std::initializer_list<const char*> ids) {
    QMenu* menu = menuBar()->addMenu(title);
    menu->setObjectName(QLatin1String(name));
    for (const char* id : ids) {
      id == nullptr ? (void)menu->addSeparator() : menu->addAction(action(id));
    }
    return menu;
  };
  QMenu* project = add(tr("&Project"), "menuProject",
                       {"actionNew", "actionOpen", "actionOpenDemo", nullptr, "actionSave",
                        "actionSaveAs", nullptr, "actionExportTrajectory", "actionExportPeople",
                        "actionSavePicture", nullptr, "actionCloseProject", "actionQuit"});
  auto* recent = new QMenu(tr("Open recent"), project);
  recent->setObjectName(QStringLiteral("menuRecent"));
  recent->setToolTipsVisible(true);
  connect(recent, &QMenu::aboutToShow, this, [this, recent] { fillRecentMenu(recent); });
  project->insertMenu(action("actionOpenDemo"), recent);
  add(tr("&Edit"), "menuEdit",
      {"actionUndo", "actionRedo", nullptr, "actionLearnColor", "actionAddTarget",
       "actionRemoveTarget", nullptr, "actionPlacePerson", "actionRemovePerson", nullptr,
       "actionShortcuts"});
  add(tr("&Calibration"), "menuCalibration",
      {"actionCalibrateByHand", "actionCalibrateBoard", "actionPrintBoard", "actionCalibrateWand",
       nullptr, "actionPlanRig", "actionPlanCamera", "actionFindPlace", "actionResolveCamera",
       nullptr, "actionImportCalibration", "actionExportCalibration"});
  add(tr("&Run"), "menuRun",
      {"actionPlay", "actionNextFrame", "actionNextIteration", "actionPreviousFrame", nullptr,
       "actionNow", "actionRerun", nullptr, "actionAddMark", "actionRemoveMark",
       "actionPreviousMark", "actionNextMark", "actionZoomToSpan", nullptr, "actionRestart",
       "actionRestartNewSeed", nullptr, "actionExperiments"});
  fillViewMenu(add(tr("&View"), "menuView",
                   {"actionPalette", nullptr, "actionShowMask", "actionShowEvidence",
                    "actionShowVolumes", "actionShowMap", nullptr, "actionLookFromAbove",
                    "actionLookFromFront", "actionLookFree", nullptr, "actionResetLayout"}));
}

void MainWindow::fillViewMenu(QMenu* view) {
  QMenu* views = view->addMenu(tr("Views"));
  views->setObjectName(QStringLiteral("menuViews"));
  connect(views, &QMenu::aboutToShow, this, [this, views] {
    views->clear();
    for (QDockWidget* dock : findChildren<QDockWidget*>()) {
      views->addAction(dock->toggleViewAction());
    }
  });
  QMenu* colors = view->addMenu(tr("Colors"));
  colors->setObjectName(QStringLiteral("menuColors"));
  for (const char* theme : {"actionThemeSystem", "actionThemeLight", "actionThemeDark"}) {
    colors->addAction(action(theme));
  }
  QMenu* language = view->addMenu(tr("Language"));
  language->setObjectName(QStringLiteral("menuLanguage"));
  fillLanguageMenu(language);
}

void MainWindow::connectActions() {
  const auto on = [this](QAction* action, auto&& run) {
    connect(action, &QAction::triggered, this, std::forward<decltype(run)>(run));
  };
  QUndoStack* history = document_->undoStack();
  on(action("actionUndo"), [history] { history->undo(); });
  on(action("actionRedo"), [history] { history->redo(); });
  connect(history, &QUndoStack::indexChanged, this, &MainWindow::sayHistory);
  sayHistory();
  connect(action("actionLearnColor"), &QAction::toggled, this, [this](bool learning) {
    color_->setPicking(learning);
    if (learning) {
      colorDock_->raise();
    }
  });
  on(action("actionAddTarget"), [this] {
    color_->setTarget(-1);
    color_->setPicking(true);
    colorDock_->raise();
  });
  on(action("actionRemoveTarget"), [this] { targets_->removeChosen(); });
  on(action("actionPlay"), [this] { togglePlay(); });
  on(action("actionNextFrame"), [this] { bridge_->session().stepFrame(); });
  on(action("actionNextIteration"), [this] { bridge_->session().stepIteration(); });
  on(action("actionExperiments"), [this] { openExperiments(); });
  on(action("actionRestart"), [this] { restart(false); });
  on(action("actionRestartNewSeed"), [this] { restart(true); });
  connectTravel();
  connect(action("actionShowMask"), &QAction::toggled, this, [this](bool shown) {
    if (bridge_ != nullptr) {
      bridge_->session().setMasksWanted(shown);
    }
    for (CameraView* camera : cameraViews_) {
      camera->setMaskShown(shown);
    }
  });
  on(action("actionLookFromAbove"), [this] { birdsEye_->lookFromAbove(); });
  on(action("actionLookFromFront"), [this] { birdsEye_->lookFromFront(); });
  on(action("actionLookFree"), [this] { birdsEye_->lookFree(); });
  on(action("actionOpen"), [this] { askOpen(); });
  on(action("actionOpenDemo"), [this] {
    if (mayDiscard()) {
      openProject({});
    }
  });
  on(action("actionNew"), [this] {
    if (mayDiscard()) {
      beginNewProject({});
    }
  });
  on(action("actionCloseProject"), [this] { closeProject(); });
  on(action("actionShortcuts"), [this] { openShortcuts(); });
  on(action("actionPalette"), [this] { palette_->open(); });
  on(action("actionResetLayout"), [this] { resetLayout(); });
  on(action("actionSave"), [this] { save(); });
  on(action("actionSaveAs"), [this] { askSaveAs(); });
  on(action("actionExportTrajectory"), [this] { exportTrajectory(); });
  on(action("actionSavePicture"), [this] { choosePicture(); });
  on(action("actionQuit"), [this] { close(); });
  const auto onTheme = [this, on](QAction* action, Theme theme) {
    on(action, [this, theme] {
      setTheme(theme);
      QSettings().setValue(QStringLiteral("theme"), themeName(theme));
    });
  };
  onTheme(action("actionThemeSystem"), Theme::System);
  onTheme(action("actionThemeLight"), Theme::Light);
  onTheme(action("actionThemeDark"), Theme::Dark);
}

void MainWindow::sayHistory() {
  // The step itself is in the text, so that menus and lists of actions say what would happen.
  const QUndoStack& history = *document_->undoStack();
  QAction* undo = action("actionUndo");
  QAction* redo = action("actionRedo");
  undo->setEnabled(history.canUndo());
  redo->setEnabled(history.canRedo());
  undo->setText(history.canUndo() ? tr("Undo: %1").arg(history.undoText()) : tr("Undo"));
  redo->setText(history.canRedo() ? tr("Redo: %1").arg(history.redoText()) : tr("Redo"));
}

void MainWindow::openShortcuts() {
  auto* editor = findChild<ShortcutEditor*>();
  if (editor == nullptr) {
    editor = new ShortcutEditor(*actions_, this);
  }
  editor->show();
  editor->raise();
  editor->activateWindow();
}

void MainWindow::fillLanguageMenu(QMenu* menu) {
  auto* choice = new QActionGroup(menu);
  const QString now = QSettings().value(QStringLiteral("language")).toString();
  const auto add = [&](const QString& text, const QString& language) {
    QAction* entry = menu->addAction(text);
    entry->setObjectName(QStringLiteral("qt_language_") + language); // each in its own words
    entry->setCheckable(true);
    entry->setChecked(language == now);
    choice->addAction(entry);
    connect(entry, &QAction::triggered, this, [this, language] { setLanguage(language); });
  };
  add(tr("Like the system"), {});
  for (const QString& language : languages()) {
    const QString name = QLocale(language).nativeLanguageName();
    add(name.isEmpty() ? language : name.at(0).toUpper() + name.mid(1), language);
  }
}

std::vector<CommandPalette::Entry> MainWindow::moreForPalette() {
  std::vector<CommandPalette::Entry> entries;
  if (bridge_ != nullptr) {
    for (QDockWidget* dock : findChildren<QDockWidget*>()) {
      if (dock != calibrationDock_) { // that one is an action
        entries.push_back({tr("Views"), dock->windowTitle(), tr("Show this view"), {}, {}, [dock] {
                             dock->setProperty("closedByChoice", false);
                             dock->show();
                             dock->raise();
                           }});
      }
    }
  }
  for (QAction* language : findChildren<QAction*>()) {
    if (language->objectName().startsWith(QStringLiteral("qt_language_"))) {
      entries.push_back(
          {tr("Language"), language->text(), tr("Speak this language"), {}, {}, [language] {
             language->trigger();
           }});
    }
  }
  return entries;
}

void MainWindow::setLanguage(const QString& language) {
  QSettings().setValue(QStringLiteral("language"), language);
  useLanguage(language);
}

void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) {
    actions_->retranslate();
    sayHistory();
    updateTitle();
    makeMenus();
  }
}

} // namespace dewpoint::ui
