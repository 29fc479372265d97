// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/camera_docks.h"

#include "core/base/overloaded.h"
#include "core/project/project.h"
#include "core/session/session.h"
#include "core/tracking/catalog/method_catalog.h"
#include "ui/cameraview/camera_view.h"
#include "ui/cameraview/image_pick_tool.h"
#include "ui/document/document.h"
#include "ui/document/method_presentation.h"
#include "ui/selection/selection.h"
#include "ui/text/camera_motion_text.h"
#include "ui/text/camera_names.h"
#include "ui/text/reason_text.h"
#include "ui/widgets/dock_title.h"
#include "ui/workbench/dock_manager.h"
#include "ui/workbench/volume_layer.h"

#include <QAction>
#include <QMainWindow>

namespace dewpoint::ui {

CameraDocks::CameraDocks(const Workbench& bench)
    : QObject(&bench.window), bench_(bench), pick_(new ImagePickTool(bench.cameras, this)) {
  connect(pick_, &ImagePickTool::cameraChosen, &bench_.selection, &Selection::selectCamera);
  connect(&bench_.session, &SessionController::runStarted, this, &CameraDocks::make);
  connect(&bench_.session, &SessionController::closed, this, &CameraDocks::make);
  connect(&bench_.session, &SessionController::snapshotChanged, this, &CameraDocks::explain);
  connect(&bench_.selection, &Selection::targetSelected, this, [this](int target) {
    for (CameraView* view : views_) {
      view->setChosenTarget(target);
    }
    explain();
  });
  connectActions();
  connectVolume(bench_, this, [this](const std::optional<WorldBox>& volume) {
    volume_ = volume;
    for (CameraView* view : views_) {
      view->setVolume(volume);
    }
  });
}

void CameraDocks::connectActions() {
  bench_.needRun({"actionShowMask", "actionShowEvidence"},
                 [document = &bench_.document] { return document->presentation().hasOverlays; });
  bench_.onToggled("actionShowMask", this, [this](bool shown) {
    if (Session* session = bench_.session.session()) {
      session->setMasksWanted(shown);
    }
    for (CameraView* view : views_) {
      view->setMaskShown(shown);
    }
  });
  bench_.needRun({"actionShowBest"}, [document = &bench_.document] {
    return document->methodFamily().hasBestParticle;
  });
  bench_.needRun({"actionShowVolumeOfInterest"},
                 [document = &bench_.document] { return document->presentation().searchesRoom; });
  bench_.onToggled("actionShowBest", this, [this](bool shown) {
    for (CameraView* view : views_) {
      view->setBestShown(shown);
    }
  });
  bench_.onToggled("actionShowEvidence", this, [this](bool shown) {
    if (Session* session = bench_.session.session()) {
      session->setLikelihoodMapsWanted(shown);
    }
    for (CameraView* view : views_) {
      view->setEvidenceShown(shown);
    }
  });
}

void CameraDocks::make() {
  bench_.docks.restoreMaximized();
  for (ViewDock* dock : docks_) {
    bench_.docks.remove(dock);
  }
  docks_.clear();
  views_.clear();
  const bool mask = bench_.action("actionShowMask")->isChecked();
  const bool evidence = bench_.action("actionShowEvidence")->isChecked();
  const bool best = bench_.action("actionShowBest")->isChecked();
  const auto& cameras = bench_.document.project().cameras;
  for (int camera = 0; camera < static_cast<int>(cameras.size()); ++camera) {
    auto* view = new CameraView(camera, &bench_.window);
    const auto index = static_cast<std::size_t>(camera);
    ViewDock* dock = bench_.docks.make(
        {.name = QStringLiteral("cameraDock%1").arg(camera),
         .title = [given = cameras[index].camera.name, index] { return cameraName(given, index); },
         .content = view,
         .place = DockPlace::Cameras,
         .rank = camera});
    dock->title().setState(view->state());
    connect(view, &CameraView::stateChanged, &dock->title(), &DockTitle::setState);
    view->setMaskShown(mask);
    view->setEvidenceShown(evidence);
    view->setBestShown(best);
    view->setVolume(volume_);
    view->setChosenTarget(bench_.selection.target());
    bench_.connectImageView(view);
    pick_->attach(camera, view);
    Q_EMIT viewMade(camera, view);
    docks_.push_back(dock);
    views_.push_back(view);
  }
  bench_.docks.layOut();
  if (Session* session = bench_.session.session()) {
    session->setMasksWanted(mask);
    session->setLikelihoodMapsWanted(evidence);
  }
}

namespace {

/// Whether a camera's reason is worth saying: that a box is hidden is its state already.
bool isWorthSaying(const TrackEstimate& estimate, const CameraReport& reason) {
  const bool isHidden = reason.status == CameraStatus::Hidden;
  return std::visit(Overloaded{[](const SphereEstimate&) { return true; },
                               [isHidden](const BoxEstimate&) { return !isHidden; },
                               [](const PersonEstimate&) { return true; },
                               [](const AbsentEstimate&) { return true; }},
                    estimate);
}

} // namespace

void CameraDocks::explain() {
  const TrackSnapshotPtr& snapshot = bench_.session.shown();
  if (!snapshot) {
    return;
  }
  const TargetSnapshot* target = targetToExplain(*snapshot, bench_.selection.target());
  for (std::size_t k = 0; k < docks_.size(); ++k) {
    const bool known = target != nullptr && k < target->reasons.size() &&
                       isWorthSaying(target->estimate, target->reasons[k]);
    const QString motion = cameraMotionText(cameraMotionOf(*snapshot, static_cast<int>(k)));
    docks_[k]->title().setReason(!motion.isEmpty() ? motion
                                 : known           ? cameraReasonText(target->reasons[k])
                                                   : QString());
  }
}

} // namespace dewpoint::ui
