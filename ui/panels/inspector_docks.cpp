// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/inspector_docks.h"

#include "core/tracking/catalog/method_catalog.h"
#include "ui/document/document.h"
#include "ui/panels/background_image_taker.h"
#include "ui/panels/camera_panel.h"
#include "ui/panels/parameter_panel.h"
#include "ui/panels/target_panel.h"
#include "ui/selection/selection.h"
#include "ui/widgets/message_bar.h"
#include "ui/workbench/dock_manager.h"
#include "ui/workbench/workbench.h"

#include <QAction>
#include <QMainWindow>
#include <QScrollArea>

namespace dewpoint::ui {

namespace {

void showMethodRequirements(const Workbench& bench) {
  const MethodFamily family = bench.document.methodFamily();
  if (!family.needsCalibration && family.lacksTargets(bench.document.project().targets)) {
    bench.messages.showNotice(
        ParameterPanel::tr("Click the object or drag a box around it in any camera view."));
  }
}

} // namespace

void installParameters(const Workbench& bench) {
  auto* scroll = new QScrollArea(&bench.window);
  scroll->setObjectName(QStringLiteral("parameterScroll"));
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(324); // room for the names of all tabs
  scroll->setWidget(new ParameterPanel(bench.document, &bench.window));
  ViewDock* dock = bench.docks.makeDock({.name = QStringLiteral("parameterDock"),
                                         .title = [] { return ParameterPanel::tr("Parameters"); },
                                         .content = scroll,
                                         .orderInArea = 0});
  // The dock itself too: with a title bar of our own its minimum does not follow its content's.
  dock->setMinimumWidth(scroll->minimumWidth());
  QObject::connect(&bench.document, &Document::methodChanged, dock,
                   [bench] { showMethodRequirements(bench); });
}

TargetDock installTargets(const Workbench& bench) {
  auto* panel = new TargetPanel(bench.document, bench.targets, &bench.window);
  panel->addTools(bench.action("actionAddTarget"), bench.action("actionRemoveTarget"),
                  bench.action("actionLearnColor"));
  ViewDock* dock = bench.docks.makeDock({.name = QStringLiteral("targetDock"),
                                         .title = [] { return TargetPanel::tr("Target"); },
                                         .content = panel,
                                         .orderInArea = 2});
  bench.connectView(panel);
  QObject::connect(panel, &TargetPanel::targetChosen, &bench.selection, &Selection::selectTarget);
  QObject::connect(&bench.selection, &Selection::targetSelected, panel, &TargetPanel::chooseTarget);
  bench.onTriggered("actionRemoveTarget", panel, [panel] { panel->removeChosenTarget(); });
  bench.onTriggered("actionHideTarget", panel,
                    [panel] { panel->toggleTargetShown(panel->chosenTarget()); });
  bench.requireRun({"actionRemoveTarget", "actionHideTarget"});
  return {dock, panel};
}

CameraPanel* installCameras(const Workbench& bench) {
  auto* panel = new CameraPanel(bench.document, bench.selection, bench.cameras, &bench.window);
  bench.docks.makeDock({.name = QStringLiteral("cameraListDock"),
                        .title = [] { return CameraPanel::tr("Cameras"); },
                        .content = panel,
                        .orderInArea = 4});
  bench.connectImageView(panel);
  QObject::connect(panel, &CameraPanel::calibrationImportRequested,
                   bench.action("actionImportCalibration"), &QAction::trigger);
  const BackgroundImageTaker* taker = &panel->backgroundImageTaker();
  QObject::connect(taker, &BackgroundImageTaker::failed, &bench.messages, &MessageBar::showError);
  QObject::connect(taker, &BackgroundImageTaker::messageRequested, &bench.messages,
                   &MessageBar::showNotice);
  QObject::connect(taker, &BackgroundImageTaker::confirmationRequested, &bench.messages,
                   [bar = &bench.messages](const QString& question, const QString& yes,
                                           const std::function<void()>& act) {
                     bar->showQuestion(question, {{yes, act}});
                   });
  return panel;
}

} // namespace dewpoint::ui
