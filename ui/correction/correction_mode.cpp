// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/correction/correction_mode.h"

#include "core/project/project.h"
#include "core/session/session.h"
#include "core/session/snapshot/snapshot.h"
#include "ui/cameraview/camera_docks.h"
#include "ui/cameraview/camera_view.h"
#include "ui/correction/backward_tracker.h"
#include "ui/correction/correction_tool.h"
#include "ui/document/document.h"
#include "ui/document/method_presentation.h"
#include "ui/selection/selection.h"
#include "ui/text/error_sentence.h"
#include "ui/trajectory/trajectory_panel.h"
#include "ui/view3d/birds_eye_view.h"
#include "ui/widgets/message_bar.h"

#include <QAction>
#include <QMainWindow>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::ui {

CorrectionMode::CorrectionMode(const Workbench& bench, const CameraDocks& cameras,
                               BirdsEyeView& birdsEye, TrajectoryPanel& trajectory)
    : QObject(&bench.window), bench_(bench), tool_(new CorrectionTool(bench, birdsEye, this)),
      backwardTracker_(new BackwardTracker(bench, this)) {
  bench_.connectView(tool_);
  connect(&cameras, &CameraDocks::viewCreated, tool_, &CorrectionTool::attach);
  connect(tool_, &CorrectionTool::corrected, this, &CorrectionMode::storeCorrection);
  connect(tool_, &CorrectionTool::failed, &bench_.messages, &MessageBar::showError);
  connect(tool_, &CorrectionTool::canceled, this, &CorrectionMode::end);
  connect(&bench_.document, &Document::correctionsChanged, tool_, &CorrectionTool::refresh);
  connect(&bench_.document, &Document::targetsChanged, tool_, &CorrectionTool::refresh);
  connect(&bench_.selection, &Selection::targetSelected, tool_, &CorrectionTool::refresh);
  connect(&trajectory, &TrajectoryPanel::correctionRemovalRequested, this,
          [this](qint64 frame, int target) { remove(frame, target); });
  cameras.imageMenu().addSection(
      [this](int camera, const QPointF& pixel) { return menuEntries(camera, pixel); });
  connectActions();
}

std::vector<ImageMenuEntry> CorrectionMode::menuEntries(int camera, const QPointF& pixel) {
  if (!bench_.session.isRunning() || !bench_.document.methodPresentation().limitsSearchToVolume) {
    return {};
  }
  return {
      {QStringLiteral("imageCorrect"), bench_.action("actionCorrectPosition")->text(),
       tr("Set the target's position in this frame to this point; tracking continues from there"),
       tool_->canCorrect(), [this, camera, pixel] { tool_->correctAt(camera, pixel); }}};
}

void CorrectionMode::connectActions() {
  bench_.requireRun({"actionCorrectPosition", "actionRemoveCorrection"},
                    [document = &bench_.document] {
                      return document->methodPresentation().limitsSearchToVolume;
                    });
  bench_.onToggled("actionCorrectPosition", this, [this](bool active) { setActive(active); });
  bench_.onTriggered("actionRemoveCorrection", this, [this] {
    remove(bench_.selection.currentFrame(), bench_.selection.target());
  });
  // One thing at a time is meant by a press in an image.
  for (const ActionId other : std::initializer_list<ActionId>{"actionLearnColor", "actionAddTarget",
                                                              "actionCalibrateByHand"}) {
    bench_.onToggled(other, this, [this](bool on) {
      if (on) {
        end();
      }
    });
  }
  connect(&bench_.session, &SessionController::runEnded, this, &CorrectionMode::end);
  connect(&bench_.document, &Document::methodChanged, this, [this] {
    if (!bench_.document.methodPresentation().limitsSearchToVolume) {
      end();
    }
  });
}

void CorrectionMode::end() {
  bench_.action("actionCorrectPosition")->setChecked(false);
}

void CorrectionMode::setActive(bool active) {
  const bool can = active && bench_.session.isRunning() &&
                   bench_.document.methodPresentation().limitsSearchToVolume;
  if (can) {
    bench_.action("actionLearnColor")->setChecked(false);
    bench_.action("actionAddTarget")->setChecked(false);
    bench_.action("actionCalibrateByHand")->setChecked(false);
  }
  tool_->setActive(can);
  const QString hint = tr("Drag the target to its true position in one image. To set its depth as "
                          "well, do the same in a second image. Press Esc to finish.");
  if (can) {
    bench_.messages.showNotice(hint);
  } else if (bench_.messages.text() == hint) {
    bench_.messages.dismiss();
  }
}

void CorrectionMode::storeCorrection(const PositionCorrection& correction) {
  if (bench_.session.session() == nullptr) {
    return;
  }
  // Before the frames from here on are tracked again.
  std::vector<TrajectorySample> believed = bench_.session.session()->trajectory().samples;
  const std::string mergeKey = "correction " + std::to_string(++correctionCount_);
  const auto edited = bench_.document.edit(
      tr("Correct position"), [&](Project& project) { addCorrection(project, correction); },
      mergeKey);
  if (edited) {
    backwardTracker_->start(correction, std::move(believed), mergeKey);
  } else {
    bench_.messages.showError(errorText(edited.error()));
  }
}

void CorrectionMode::remove(std::int64_t frame, int target) {
  const auto isMeant = [&](const PositionCorrection& correction) {
    return correction.frame == frame && (target < 0 || correction.target == target);
  };
  if (std::ranges::none_of(bench_.document.project().corrections, isMeant)) {
    bench_.messages.showNotice(tr("There is no correction in this frame."));
    return;
  }
  const std::vector<PositionCorrection> all = bench_.document.project().corrections;
  (void)bench_.document.edit(tr("Remove correction"), [&](Project& project) {
    for (const PositionCorrection& correction : all) {
      if (isMeant(correction)) {
        removeCorrection(project, frame, correction.target);
      }
    }
  });
}

} // namespace dewpoint::ui
