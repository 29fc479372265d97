// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/color/color_dock.h"

#include "core/project/project.h"
#include "core/session/snapshot/snapshot.h"
#include "core/tracking/catalog/method_catalog.h"
#include "ui/actions/action_registry.h"
#include "ui/cameraview/camera_docks.h"
#include "ui/cameraview/image_pick_tool.h"
#include "ui/color/color_panel.h"
#include "ui/document/document.h"
#include "ui/panels/inspector_docks.h"
#include "ui/panels/target_panel.h"
#include "ui/widgets/message_bar.h"
#include "ui/workbench/dock_manager.h"

#include <QAction>
#include <QMainWindow>
#include <QScrollArea>

namespace dewpoint::ui {

namespace {

constexpr qint64 kMaskMs = 2000; ///< of playing, until the mask of a learned color is hidden

} // namespace

ColorDock::ColorDock(const Workbench& bench, const CameraDocks& cameras, const TargetDock& targets)
    : QObject(&bench.window), bench_(bench), targetDock_(targets.dock), targets_(targets.panel),
      panel_(new ColorPanel(bench.document, cameras.pickTool(), &bench.window)) {
  auto* scroll = new QScrollArea(&bench_.window);
  scroll->setObjectName(QStringLiteral("colorScroll"));
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidget(panel_);
  dock_ = bench_.docks.makeDock({.name = QStringLiteral("colorDock"),
                                 .title = [] { return tr("Color"); },
                                 .content = scroll,
                                 .orderInArea = 3});
  bench_.connectImageView(panel_);
  connect(dock_, &QDockWidget::visibilityChanged, panel_, &ColorPanel::setPanelVisible);
  connect(panel_, &ColorPanel::failed, &bench_.messages, &MessageBar::showError);
  connect(panel_, &ColorPanel::pickingChanged, this, &ColorDock::showAwaited);
  connect(panel_, &ColorPanel::colorLearned, this, &ColorDock::colorLearned);
  connect(targets_, &TargetPanel::targetChosen, panel_, &ColorPanel::setTarget);
  cameras.imageMenu().addSection(
      [this, pick = &cameras.pickTool()](int camera, const QPointF& pixel) {
        return menuEntries(*pick, camera, pixel);
      });
  connectActions();
}

std::vector<ImageMenuEntry> ColorDock::menuEntries(ImagePickTool& pick, int camera,
                                                   const QPointF& pixel) {
  if (!bench_.session.isRunning() || bench_.document.methodFamily().findsTargets()) {
    return {}; // such a method needs no color
  }
  const auto point = [&pick, camera, pixel](Qt::KeyboardModifiers modifiers) {
    return [&pick, camera, pixel, modifiers] { pick.pickAt(camera, pixel, modifiers); };
  };
  if (panel_->targetsAreBoxes()) {
    return {{QStringLiteral("imageTakeBox"), tr("Set box here"),
             tr("Track this object, starting from a box around it"), true, point(Qt::NoModifier)}};
  }
  return {{QStringLiteral("imageLearnColor"), tr("Learn the color here"),
           tr("Learn the target's color from this spot"), true, point(Qt::NoModifier)},
          {QStringLiteral("imageAddSample"), tr("Add color sample here"),
           tr("Add this color to the colors of the target (Shift-click does the same)"),
           panel_->hasTarget(), point(Qt::ShiftModifier)},
          {QStringLiteral("imageExclude"), tr("Exclude this color"),
           tr("Remove this color from the colors of the target (Ctrl+Shift-click does the same)"),
           panel_->hasTarget(), point(Qt::AltModifier)}};
}

void ColorDock::connectActions() {
  bench_.onToggled("actionLearnColor", this, [this](bool starts) { learn(starts); });
  bench_.onToggled("actionAddTarget", this, [this](bool starts) { addTarget(starts); });
  // A page opened now has the clicks.
  bench_.onToggled("actionCalibrateByHand", this, [this](bool opened) {
    if (opened && panel_->clickAddsTarget()) {
      panel_->setPicking(false);
    }
    showAwaited();
  });
  bench_.requireRun({"actionLearnColor", "actionAddTarget"});
  bench_.onToggled("actionShowMask", this, [this](bool) { isMaskOfLearning_ = false; });
  connect(&bench_.session, &SessionController::snapshotChanged, this, &ColorDock::hideLearned);
  connect(&bench_.session, &SessionController::runStarted, this, &ColorDock::updateLearnActionText);
  connect(&bench_.document, &Document::methodChanged, this, &ColorDock::updateLearnActionText);
}

void ColorDock::learn(bool starts) {
  if (showsAwaited_) {
    return;
  }
  if (starts && panel_->clickAddsTarget()) {
    panel_->setTarget(targets_->chosenTarget());
  }
  panel_->setPicking(starts);
  if (starts) {
    dock_->raise();
  }
  showAwaited();
}

void ColorDock::addTarget(bool starts) {
  if (showsAwaited_) {
    return;
  }
  if (starts) {
    panel_->setTarget(-1);
    dock_->raise();
  }
  panel_->setPicking(starts);
  showAwaited();
}

void ColorDock::showAwaited() {
  const bool adds = panel_->isPicking() && panel_->clickAddsTarget();
  const bool learns =
      panel_->isPicking() && (!adds || bench_.action("actionCalibrateByHand")->isChecked());
  showsAwaited_ = true;
  bench_.action("actionLearnColor")->setChecked(learns);
  bench_.action("actionAddTarget")->setChecked(adds);
  showsAwaited_ = false;
}

void ColorDock::updateLearnActionText() {
  bench_.actions.rename(bench_.action("actionLearnColor"),
                        panel_->targetsAreBoxes() ? QT_TRANSLATE_NOOP("Actions", "Set box")
                                                  : QT_TRANSLATE_NOOP("Actions", "Learn the color"),
                        "learn");
}

void ColorDock::colorLearned(int target, bool isNew) {
  targets_->chooseTarget(target);
  if (panel_->targetsAreBoxes()) {
    targetDock_->raise();
    bench_.session.startAfterBoxDrawn(isNew);
    return;
  }
  dock_->raise();
  showLearned();
  bench_.session.startAfterLearning(isNew);
}

void ColorDock::showLearned() {
  QAction* mask = bench_.action("actionShowMask");
  const bool isNew = !mask->isChecked();
  mask->setChecked(true);
  isMaskOfLearning_ = isMaskOfLearning_ || isNew;
  playing_.invalidate();
}

void ColorDock::hideLearned(const TrackSnapshotPtr& snapshot) {
  if (!isMaskOfLearning_) {
    return;
  }
  const bool isPlaying = snapshot && snapshot->state == PlayState::Playing && !panel_->isPicking();
  if (!isPlaying) {
    playing_.invalidate();
  } else if (!playing_.isValid()) {
    playing_.start();
  } else if (playing_.elapsed() >= kMaskMs) {
    bench_.action("actionShowMask")->setChecked(false);
  }
}

} // namespace dewpoint::ui
