// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/window_menus.h"

#include "ui/actions/action_registry.h"
#include "ui/actions/shortcut_editor.h"
#include "ui/document/camera_list_model.h"
#include "ui/document/target_list_model.h"
#include "ui/preferences/preferences.h"
#include "ui/selection/selection.h"
#include "ui/text/language.h"
#include "ui/workbench/dock_manager.h"

#include <QAction>
#include <QActionGroup>
#include <QLocale>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>

#include <utility>

namespace dewpoint::ui {

namespace {

/// The name of a language in this language. Qt begins some with the variant ("American English"),
/// under which nobody looks for them.
QString nameOfLanguage(const QString& language) {
  if (language == QLatin1String("en")) {
    return QStringLiteral("English (US)");
  }
  if (language == QLatin1String("es")) {
    return QStringLiteral("Español (España)");
  }
  const QString name = QLocale(language).nativeLanguageName();
  return name.isEmpty() ? language : name.at(0).toUpper() + name.mid(1);
}

} // namespace

WindowMenus::WindowMenus(const Workbench& bench, Callbacks callbacks)
    : QObject(&bench.window), bench_(bench), callbacks_(std::move(callbacks)),
      palette_(new CommandPalette(bench.actions, &bench.window)) {
  palette_->setExtraEntries([this] { return extraPaletteEntries(); });
  bench_.onTriggered("actionPalette", this, [this] { openCommandPalette(); });
  bench_.onTriggered("actionShortcuts", this, [this] { openShortcuts(); });
}

QMenu* WindowMenus::add(const QString& title, const char* name,
                        std::initializer_list<ActionId> ids) {
  QMenu* menu = bench_.window.menuBar()->addMenu(title);
  menu->setObjectName(QLatin1String(name));
  for (const ActionId id : ids) {
    id.isSeparator() ? (void)menu->addSeparator() : menu->addAction(bench_.action(id));
  }
  return menu;
}

void WindowMenus::makeMenus() {
  QMenuBar* bar = bench_.window.menuBar();
  qDeleteAll(bar->findChildren<QMenu*>(Qt::FindDirectChildrenOnly));
  bar->clear();
  bar->setObjectName(QStringLiteral("menuBar"));
  makeFileMenu();
  add(tr("&Edit"), "menuEdit",
      {"actionUndo", "actionRedo", nullptr, "actionLearnColor", "actionAddTarget",
       "actionRemoveTarget", "actionHideTarget", nullptr, "actionCameras", "actionLockColors",
       nullptr, "actionCorrectPosition", "actionRemoveCorrection", nullptr, "actionPlacePerson",
       "actionRemovePerson", nullptr, "actionShortcuts"});
  makeViewMenu();
  add(tr("&Calibration"), "menuCalibration",
      {"actionCalibrate", nullptr, "actionCalibrateByHand", "actionCalibrateBoard",
       "actionPrintBoard", "actionCalibrateWand", "actionCalibrateWorld", nullptr, "actionPlanRig",
       "actionPlanCamera", "actionFindPlace", "actionResolveCamera", nullptr,
       "actionImportCalibration", "actionExportCalibration"});
  add(tr("&Run"), "menuRun",
      {"actionPlay",
       "actionNextFrame",
       "actionNextIteration",
       "actionPreviousFrame",
       nullptr,
       "actionSlower",
       "actionFaster",
       "actionNormalSpeed",
       "actionSlowStart",
       nullptr,
       "actionNow",
       "actionRerun",
       "actionTrackAgain",
       nullptr,
       "actionAddMark",
       "actionRemoveMark",
       "actionPreviousMark",
       "actionNextMark",
       "actionZoomToSpan",
       nullptr,
       "actionGoToFrame",
       "actionPreviousTrouble",
       "actionNextTrouble",
       nullptr,
       "actionRestart",
       "actionRestartNewSeed",
       nullptr,
       "actionRecord",
       "actionTakeNotes",
       "actionSendResults",
       "actionOutputs",
       nullptr,
       "actionFilterThreads",
       "actionExperiments"});
  add(tr("&Help"), "menuHelp",
      {"actionQuickStart", "actionLegend", "actionShortcuts", nullptr, "actionManual",
       "actionMethods", nullptr, "actionMessages", "actionCheckProject", "actionReportProblem",
       "actionAbout"});
}

void WindowMenus::makeFileMenu() {
  QMenu* file =
      add(tr("&File"), "menuFile",
          {"actionNew", "actionOpen", "actionOpenDemo", nullptr, "actionSave", "actionSaveAs",
           nullptr, "actionExportTrajectory", "actionExportPeople", "actionExportVideo",
           "actionSavePicture", nullptr, "actionCloseProject", "actionQuit"});
  auto* recent = new QMenu(tr("Open recent"), file);
  recent->setObjectName(QStringLiteral("menuRecent"));
  recent->setToolTipsVisible(true);
  connect(recent, &QMenu::aboutToShow, this, [this, recent] { callbacks_.fillRecent(recent); });
  file->insertMenu(bench_.action("actionOpenDemo"), recent);
}

void WindowMenus::makeViewMenu() {
  QMenu* view = add(tr("&View"), "menuView",
                    {"actionPalette",
                     nullptr,
                     "actionShowMask",
                     "actionShowEvidence",
                     "actionShowBest",
                     "actionShowRays",
                     "actionShowImagesInScene",
                     "actionShowMagnifier",
                     "actionShowVolumeOfInterest",
                     "actionShowVolumes",
                     "actionShowMap",
                     nullptr,
                     "actionZoomIn",
                     "actionZoomOut",
                     "actionFitImage",
                     nullptr,
                     "actionLookFree",
                     "actionLookFromAbove",
                     "actionLookFromFront",
                     "actionLookFromSide",
                     "actionFitScene",
                     nullptr,
                     "actionResetLayout",
                     "actionFullScreen"});
  QMenu* views = view->addMenu(tr("Views"));
  views->setObjectName(QStringLiteral("menuViews"));
  connect(views, &QMenu::aboutToShow, this, [this, views] {
    views->clear();
    for (ViewDock* dock : bench_.docks.docks()) {
      views->addAction(dock->toggleViewAction());
    }
  });
  QMenu* colors = view->addMenu(tr("Theme"));
  colors->setObjectName(QStringLiteral("menuColors"));
  for (const ActionId theme : std::initializer_list<ActionId>{
           "actionThemeSystem", "actionThemeLight", "actionThemeDark"}) {
    colors->addAction(bench_.action(theme));
  }
  QMenu* language = view->addMenu(tr("Language"));
  language->setObjectName(QStringLiteral("menuLanguage"));
  fillLanguageMenu(language);
}

void WindowMenus::fillLanguageMenu(QMenu* menu) {
  auto* choice = new QActionGroup(menu);
  const QString now = Preferences().language();
  languages_.clear();
  const auto addComboBox = [&](const QString& text, const QString& language) {
    QAction* entry = menu->addAction(text);
    entry->setObjectName(QStringLiteral("qt_language_") + language); // each in its own words
    entry->setCheckable(true);
    entry->setChecked(language == now);
    choice->addAction(entry);
    connect(entry, &QAction::triggered, this,
            [this, language] { callbacks_.setLanguage(language); });
    languages_.push_back(entry);
  };
  addComboBox(tr("Follow system"), {});
  for (const QString& language : availableLanguages()) {
    addComboBox(nameOfLanguage(language), language);
  }
}

void WindowMenus::openShortcuts() {
  auto* editor = bench_.window.findChild<ShortcutEditor*>();
  if (editor == nullptr) {
    editor = new ShortcutEditor(bench_.actions, &bench_.window);
  }
  Workbench::presentDialog(editor);
}

std::vector<CommandPalette::Entry> WindowMenus::extraPaletteEntries() {
  std::vector<CommandPalette::Entry> entries;
  if (bench_.session.isRunning()) {
    for (ViewDock* dock : bench_.docks.docks()) {
      if (!dock->isOpenedByAction()) { // that is in the list already
        entries.push_back({tr("Views"), dock->windowTitle(), tr("Show this view"), {}, {}, [dock] {
                             dock->bringToFront();
                           }});
      }
    }
  }
  const auto addAll = [&](const NameListModel& list, const QString& group, const QString& hint,
                          void (Selection::*select)(int)) {
    for (int row = 0; row < list.rowCount(); ++row) {
      const QModelIndex one = list.index(row);
      entries.push_back(
          {group,
           one.data().toString(),
           hint,
           {},
           one.data(Qt::DecorationRole).value<QIcon>(),
           [selection = &bench_.selection, select, row] { (selection->*select)(row); }});
    }
  };
  if (bench_.session.isRunning()) {
    addAll(bench_.cameras, tr("Cameras"), tr("Choose this camera"), &Selection::selectCamera);
    addAll(bench_.targets, tr("Targets"), tr("Choose this target"), &Selection::selectTarget);
  }
  for (QAction* language : languages_) {
    entries.push_back(
        {tr("Language"), language->text(), tr("Switch to this language"), {}, {}, [language] {
           language->trigger();
         }});
  }
  return entries;
}

} // namespace dewpoint::ui
