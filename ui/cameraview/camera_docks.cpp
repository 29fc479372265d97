// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/camera_docks.h"

#include "core/base/overloaded.h"
#include "core/project/project.h"
#include "core/session/session.h"
#include "core/tracking/catalog/method_catalog.h"
#include "ui/cameraview/camera_view.h"
#include "ui/cameraview/image_menu.h"
#include "ui/cameraview/image_pick_tool.h"
#include "ui/cameraview/image_zoom.h"
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
#include <QApplication>
#include <QCursor>
#include <QMainWindow>

#include <algorithm>

namespace dewpoint::ui {

CameraDocks::CameraDocks(const Workbench& bench)
    : QObject(&bench.window), bench_(bench), pick_(new ImagePickTool(bench.cameras, this)),
      menu_(new ImageMenu(bench)) {
  connect(pick_, &ImagePickTool::cameraChosen, &bench_.selection, &Selection::selectCamera);
  connect(&bench_.session, &SessionController::runStarted, this, &CameraDocks::makeDocks);
  connect(&bench_.session, &SessionController::closed, this, &CameraDocks::makeDocks);
  connect(&bench_.session, &SessionController::snapshotChanged, this, &CameraDocks::updateTitles);
  connect(&bench_.selection, &Selection::targetSelected, this, [this](int target) {
    for (CameraView* view : views_) {
      view->setChosenTarget(target);
    }
    updateTitles();
  });
  connectActions();
  connectZoom();
  connectVolume(bench_, this, [this](const std::optional<WorldBox>& volume) {
    volume_ = volume;
    for (CameraView* view : views_) {
      view->setVolume(volume);
    }
  });
}

void CameraDocks::connectActions() {
  bench_.requireRun({"actionShowMask", "actionShowEvidence"}, [document = &bench_.document] {
    return document->methodPresentation().hasOverlays;
  });
  bench_.onToggled("actionShowMask", this, [this](bool shown) {
    if (Session* session = bench_.session.session()) {
      session->setMasksShown(shown);
    }
    for (CameraView* view : views_) {
      view->setMaskShown(shown);
    }
  });
  bench_.requireRun({"actionShowBest"}, [document = &bench_.document] {
    return document->methodFamily().hasBestParticle;
  });
  bench_.requireRun({"actionShowVolumeOfInterest"}, [document = &bench_.document] {
    return document->methodPresentation().limitsSearchToVolume;
  });
  bench_.onToggled("actionShowBest", this, [this](bool shown) {
    for (CameraView* view : views_) {
      view->setBestParticleShown(shown);
    }
  });
  bench_.onToggled("actionShowEvidence", this, [this](bool shown) {
    if (Session* session = bench_.session.session()) {
      session->setLikelihoodMapsShown(shown);
    }
    for (CameraView* view : views_) {
      view->setLikelihoodShown(shown);
    }
  });
}

void CameraDocks::connectZoom() {
  bench_.requireRun({"actionZoomIn", "actionZoomOut", "actionFitImage"});
  bench_.requireRun({"actionShowMagnifier"}, [document = &bench_.document] {
    return document->methodPresentation().limitsSearchToVolume;
  });
  bench_.onToggled("actionShowMagnifier", this, [this](bool shown) {
    for (CameraView* view : views_) {
      view->setMagnifierShown(shown);
    }
  });
  bench_.onTriggered("actionZoomIn", this, [this] { zoom(ImageZoom::kZoomStep); });
  bench_.onTriggered("actionZoomOut", this, [this] { zoom(1.0 / ImageZoom::kZoomStep); });
  bench_.onTriggered("actionFitImage", this, [this] {
    if (CameraView* view = viewToZoom()) {
      view->fitImage();
    }
  });
}

CameraView* CameraDocks::viewToZoom() const {
  const QWidget* under = QApplication::widgetAt(QCursor::pos());
  const auto pointed = std::ranges::find_if(views_, [under](const CameraView* view) {
    return under != nullptr && (view == under || view->isAncestorOf(under));
  });
  if (pointed != views_.end()) {
    return *pointed;
  }
  const int selected = bench_.selection.camera();
  if (selected >= 0 && static_cast<std::size_t>(selected) < views_.size() &&
      views_[static_cast<std::size_t>(selected)]->isVisible()) {
    return views_[static_cast<std::size_t>(selected)];
  }
  const auto seen = std::ranges::find_if(views_, &CameraView::isVisible);
  return seen != views_.end() ? *seen : nullptr;
}

void CameraDocks::zoom(double factor) {
  if (CameraView* view = viewToZoom()) {
    const QPointF pointer = view->mapFromGlobal(QPointF(QCursor::pos()));
    const QRectF seen = view->shownArea();
    view->zoomBy(factor, seen.contains(pointer) ? pointer : seen.center());
  }
}

void CameraDocks::makeDocks() {
  bench_.docks.restoreMaximized();
  for (ViewDock* dock : docks_) {
    bench_.docks.removeDock(dock);
  }
  docks_.clear();
  views_.clear();
  const bool mask = bench_.action("actionShowMask")->isChecked();
  const bool evidence = bench_.action("actionShowEvidence")->isChecked();
  const bool best = bench_.action("actionShowBest")->isChecked();
  const bool magnifier = bench_.action("actionShowMagnifier")->isChecked();
  const auto& cameras = bench_.document.project().cameras;
  for (int camera = 0; camera < static_cast<int>(cameras.size()); ++camera) {
    auto* view = new CameraView(camera, &bench_.window);
    const auto index = static_cast<std::size_t>(camera);
    ViewDock* dock = bench_.docks.makeDock(
        {.name = QStringLiteral("cameraDock%1").arg(camera),
         .title = [given = cameras[index].camera.name, index] { return cameraName(given, index); },
         .content = view,
         .area = DockArea::Cameras,
         .orderInArea = camera});
    dock->title().setState(view->state());
    connect(view, &CameraView::stateChanged, &dock->title(), &DockTitle::setState);
    connect(view, &CameraView::estimatePainted, this, [this](double seconds) {
      if (Session* session = bench_.session.session()) {
        session->addDrawingTime(seconds);
      }
    });
    view->setMaskShown(mask);
    view->setLikelihoodShown(evidence);
    view->setBestParticleShown(best);
    view->setMagnifierShown(magnifier);
    view->setVolume(volume_);
    view->setChosenTarget(bench_.selection.target());
    bench_.connectImageView(view);
    connect(view, &CameraView::menuRequested, menu_,
            [this, camera, view](const QPointF& position) { menu_->open(camera, view, position); });
    pick_->attach(camera, view);
    Q_EMIT viewCreated(camera, view);
    docks_.push_back(dock);
    views_.push_back(view);
  }
  bench_.docks.layOut();
  if (Session* session = bench_.session.session()) {
    session->setMasksShown(mask);
    session->setLikelihoodMapsShown(evidence);
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

void CameraDocks::updateTitles() {
  const TrackSnapshotPtr& snapshot = bench_.session.shownSnapshot();
  if (!snapshot) {
    return;
  }
  const TargetSnapshot* target = targetToExplain(*snapshot, bench_.selection.target());
  for (std::size_t k = 0; k < docks_.size(); ++k) {
    const int camera = static_cast<int>(k);
    DockTitle& title = docks_[k]->title();
    const bool known = target != nullptr && k < target->cameraReports.size() &&
                       isWorthSaying(target->estimate, target->cameraReports[k]);
    if (const CameraMotionReport* motion = cameraMotionOf(*snapshot, camera)) {
      title.setReason(cameraMotionText(motion));
    } else if (!known) {
      title.setReason({});
    } else if (isCameraBlind(target->cameraReports[k]) &&
               trackingState(*snapshot, camera) == TrackingState::Held) {
      // The others hold it: here that word would be a riddle.
      title.showReasonInsteadOfState(cameraBlindText(target->cameraReports[k]));
    } else {
      title.setReason(cameraReasonTextInImage(target->cameraReports[k]));
    }
  }
}

} // namespace dewpoint::ui
