// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/calibration_mode.h"

#include "ui/calibration/calibration_dock.h"
#include "ui/calibration/manual_calibration.h"
#include "ui/workbench/dock_manager.h"
#include "ui/workbench/view_dock.h"

#include <QAction>
#include <QMainWindow>

#include <algorithm>
#include <utility>

namespace dewpoint::ui {

namespace {
constexpr QLatin1String kHandPage("handPage");
constexpr QLatin1String kBoardPage("boardPage");
} // namespace

CalibrationMode::CalibrationMode(const Workbench& bench)
    : QObject(&bench.window), bench_(bench),
      manual_(new ManualCalibration(bench.document, bench.selection, bench.cameras, this)),
      pages_(new CalibrationDock(&bench.window)) {
  dock_ = bench_.docks.makeDock({.name = QStringLiteral("calibrationDock"),
                                 .title = [] { return tr("Calibration"); }, // a tab: short
                                 .content = pages_,
                                 .orderInArea = 5,
                                 .isHiddenAtFirst = true,
                                 .isOpenedByAction = true});
  dock_->setMinimumWidth(400); // room for the names of all tabs, and three numbers
  QAction* mode = bench_.action("actionCalibrateByHand");
  connect(mode, &QAction::triggered, this, [this, mode](bool checked) {
    if (!checked && pages_->shownPage() != kHandPage) {
      isReturning_ = true;
      mode->setChecked(true); // another page was in front
      isReturning_ = false;
    }
  });
  connect(mode, &QAction::toggled, this, [this](bool shown) {
    if (shown) {
      pages_->showPage(kHandPage); // first: the page before is not opened again
    }
    show(shown);
  });
  connect(dock_, &ViewDock::toggledByUser, mode, &QAction::setChecked);
  connect(pages_, &CalibrationDock::pageChanged, this, [this, mode] {
    Q_EMIT pageChanged();
    show(mode->isChecked());
  });
  // A mode, no part of the layout.
  connect(&bench_.docks, &DockManager::layoutChanged, this,
          [this, mode] { show(mode->isChecked()); });
  // One thing at a time is meant by a click in an image. A color is also learned for the wand, with
  // the panel open: then the images belong to it until the color is known.
  bench_.onToggled("actionLearnColor", this, [this](bool learning) {
    manual_->setSuspended(learning);
    if (learning) {
      Q_EMIT imageClicksTakenOver();
    }
  });
  bench_.requireRun({"actionCalibrateByHand"});
}

void CalibrationMode::addPage(QWidget* page, const std::function<QString()>& title) {
  pages_->addPage(page, title);
}

void CalibrationMode::setHeader(QWidget* header) {
  pages_->setHeader(header);
}

void CalibrationMode::open(const QString& page) {
  bench_.action("actionCalibrateByHand")->setChecked(true);
  pages_->showPage(page);
}

std::vector<ViewDock*> CalibrationMode::docksInFront() const {
  std::vector<ViewDock*> front;
  for (ViewDock* view : bench_.window.findChildren<ViewDock*>()) {
    if (view != dock_ && !view->isHidden() && !view->isBehindOtherDocks()) {
      front.push_back(view);
    }
  }
  return front;
}

void CalibrationMode::show(bool isShown) {
  if (isShown && page_.isEmpty() && !isReturning_) {
    manual_->storeEarlierCameras(EarlierCameras::PanelOpened);
  }
  const bool wasInFront =
      dock_->isHidden() || !dock_->isBehindOtherDocks(); // hidden: by its own button
  const bool opens = isShown && dock_->isHidden();
  const auto front = opens ? docksInFront() : std::vector<ViewDock*>();
  dock_->setShownByUserChoice(isShown);
  if (opens) { // only now: Qt does not tell what shares its place with a hidden dock
    const auto together = bench_.window.tabifiedDockWidgets(dock_);
    const auto before =
        std::ranges::find_if(front, [&](ViewDock* view) { return together.contains(view); });
    dockBefore_ = before != front.end() ? *before : nullptr;
  }
  if (isShown) {
    dock_->raise();
  } else if (ViewDock* before = std::exchange(dockBefore_, nullptr).data(); before && wasInFront) {
    before->raise(); // not just the next tab
  }
  // The grid would lie over the board that is shown to the cameras.
  manual_->setActive(isShown && pages_->shownPage() != kBoardPage);
  const QString page = isShown ? pages_->shownPage() : QString();
  if (page != page_) { // a new layout of the views shows the same page again
    page_ = page;
    if (isShown) {
      bench_.action("actionLearnColor")->setChecked(false);
    }
    Q_EMIT pageShown(page);
  }
}

} // namespace dewpoint::ui
