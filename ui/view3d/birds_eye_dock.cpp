// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/birds_eye_dock.h"

#include "core/project/project.h"
#include "ui/document/document.h"
#include "ui/document/method_presentation.h"
#include "ui/selection/selection.h"
#include "ui/view3d/birds_eye_view.h"
#include "ui/workbench/dock_manager.h"
#include "ui/workbench/volume_layer.h"
#include "ui/workbench/workbench.h"

#include <QMainWindow>

namespace dewpoint::ui {

namespace {

void showForMethod(const Workbench& bench, ViewDock* dock) {
  const bool hasBirdsEyeView = bench.document.methodPresentation().hasBirdsEyeView;
  if (!bench.session.isRunning() || dock->isHidden() != hasBirdsEyeView) {
    return;
  }
  dock->setVisible(hasBirdsEyeView && !dock->isHiddenByUser());
  if (bench.document.project().windowLayout.empty()) { // else it is as the person wanted it
    bench.docks.distributeDockSizesSoon();
  }
}

} // namespace

BirdsEyeView* installBirdsEyeView(const Workbench& bench) {
  auto* view = new BirdsEyeView(&bench.window);
  ViewDock* dock =
      bench.docks.makeDock({.name = QStringLiteral("birdsEyeDock"),
                            .title = [] { return BirdsEyeView::tr("Bird's-eye view"); },
                            .content = view,
                            .area = DockArea::Scene});
  bench.connectView(view);
  QObject::connect(&bench.document, &Document::projectReplaced, view,
                   &BirdsEyeView::resetForNewProject);
  QObject::connect(&bench.selection, &Selection::targetSelected, view,
                   &BirdsEyeView::setChosenTarget);
  bench.onToggled("actionShowBest", view,
                  [view](bool shown) { view->setBestParticleShown(shown); });
  bench.onToggled("actionShowRays", view, [view](bool shown) { view->setRaysShown(shown); });
  bench.onToggled("actionShowImagesInScene", view,
                  [view](bool shown) { view->setImagesShown(shown); });
  connectVolume(bench, view,
                [view](const std::optional<WorldBox>& volume) { view->showVolume(volume); });
  bench.onTriggered("actionLookFromAbove", view, [view] { view->lookFromAbove(); });
  bench.onTriggered("actionLookFromFront", view, [view] { view->lookFromFront(); });
  bench.onTriggered("actionLookFromSide", view, [view] { view->lookFromSide(); });
  bench.onTriggered("actionLookFree", view, [view] { view->lookInPerspective(); });
  bench.onTriggered("actionFitScene", view, [view] { view->resetView(); });
  const auto update = [bench, dock] { showForMethod(bench, dock); };
  QObject::connect(&bench.docks, &DockManager::layoutChanged, dock, update);
  QObject::connect(&bench.document, &Document::methodChanged, dock, update);
  return view;
}

} // namespace dewpoint::ui
