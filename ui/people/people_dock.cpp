// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/people/people_dock.h"

#include "core/project/project.h"
#include "core/session/session.h"
#include "core/session/snapshot/snapshot.h"
#include "core/session/snapshot/snapshot_state.h"
#include "ui/cameraview/camera_docks.h"
#include "ui/cameraview/camera_view.h"
#include "ui/document/document.h"
#include "ui/document/method_presentation.h"
#include "ui/jobs/latest_job.h"
#include "ui/people/add_person_tool.h"
#include "ui/people/people_panel.h"
#include "ui/selection/selection.h"
#include "ui/text/error_sentence.h"
#include "ui/view3d/birds_eye_view.h"
#include "ui/widgets/message_bar.h"
#include "ui/workbench/dock_manager.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QMainWindow>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

namespace dewpoint::ui {

namespace {

/// Where a person of a snapshot stands; nothing when nobody there is this one.
std::optional<Eigen::Vector2d> placeOfPerson(const TrackSnapshotPtr& snapshot, int identity) {
  if (snapshot == nullptr) {
    return std::nullopt;
  }
  const auto people = peopleIn(*snapshot);
  const auto found = std::ranges::find(
      people, identity, [](const PersonInSnapshot& person) { return person.estimate->identity; });
  return found == people.end()
             ? std::nullopt
             : std::optional<Eigen::Vector2d>(found->estimate->position.head<2>());
}

} // namespace

PeopleDock::PeopleDock(const Workbench& bench, const CameraDocks& cameras, BirdsEyeView& birdsEye,
                       std::vector<ViewDock*> others)
    : QObject(&bench.window), bench_(bench),
      panel_(new PeoplePanel(bench.selection, bench.action("actionPlacePerson"),
                             bench.action("actionRemovePerson"), &bench.window)),
      addPersonTool_(new AddPersonTool(&birdsEye, bench.cameras, this)),
      check_(new LatestJob(LatestJob::SupersededJob::Dropped, this)),
      writing_(new LatestJob(LatestJob::SupersededJob::Kept, this)), others_(std::move(others)) {
  dock_ = bench_.docks.makeDock({.name = QStringLiteral("peopleDock"),
                                 .title = [] { return tr("People"); },
                                 .content = panel_,
                                 .orderInArea = 1,
                                 .isHiddenAtFirst = true}); // until a method for people is chosen
  dock_->setMinimumWidth(384);                              // room for all columns
  bench_.connectView(panel_);
  connectPlacer(cameras);
  connectActions();
  connect(&birdsEye, &BirdsEyeView::personClicked, &bench_.selection, &Selection::selectTarget);
  connect(&bench_.session, &SessionController::runStarted, this, [this] {
    bench_.session.session()->setBodyShapesShown(bench_.action("actionShowVolumes")->isChecked());
    updateForMethod();
  });
  connect(&bench_.session, &SessionController::runEnded, this, [this] { ++run_; });
  connect(&bench_.document, &Document::projectReplaced, this, &PeopleDock::updateForMethod);
  connect(&bench_.document, &Document::methodChanged, this, &PeopleDock::updateForMethod);
}

bool PeopleDock::tracksPeople() const {
  return bench_.document.methodPresentation().listsPeople;
}

void PeopleDock::connectPlacer(const CameraDocks& cameras) {
  QAction* place = bench_.action("actionPlacePerson");
  connect(&cameras, &CameraDocks::viewCreated, addPersonTool_, &AddPersonTool::attachView);
  connect(addPersonTool_, &AddPersonTool::personClicked, this,
          [this, place](int camera, const Eigen::Vector2d& pixel) {
            correct(tr("Add a person"), {.click = PersonCorrection::Click{camera, pixel}});
            place->setChecked(false);
          });
  connect(addPersonTool_, &AddPersonTool::floorClicked, this,
          [this, place](const Eigen::Vector2d& where) {
            correct(tr("Add a person"), {.position = where});
            place->setChecked(false);
          });
  connect(addPersonTool_, &AddPersonTool::canceled, place, [place] { place->setChecked(false); });
}

void PeopleDock::connectActions() {
  bench_.onToggled("actionPlacePerson", this, [this](bool placing) { placePeople(placing); });
  bench_.onTriggered("actionRemovePerson", this, [this] {
    if (const auto place = placeOfPerson(bench_.session.shownSnapshot(), panel_->chosenPerson())) {
      correct(tr("Remove a person"), {.position = *place, .isPresent = false});
    }
  });
  bench_.onToggled("actionShowVolumes", this, [this](bool shown) {
    if (Session* session = bench_.session.session()) {
      session->setBodyShapesShown(shown);
    }
  });
  bench_.onTriggered("actionExportPeople", this, [this] { requestExport(); });
  bench_.requireRun(
      {"actionPlacePerson", "actionRemovePerson", "actionExportPeople", "actionShowVolumes"},
      [this] { return tracksPeople(); });
}

void PeopleDock::correct(const QString& step, PersonCorrection correction) {
  const TrackSnapshotPtr& shown = bench_.session.shownSnapshot();
  if (shown == nullptr) {
    return;
  }
  correction.frame = std::max<std::int64_t>(0, shown->frame);
  const auto edited = bench_.document.edit(
      step, [&](Project& project) { addPersonCorrection(project, correction); });
  if (!edited) {
    bench_.messages.showError(errorText(edited.error()));
  }
}

void PeopleDock::selectPersonAt(int camera, const QPointF& pixel) {
  const TrackSnapshotPtr& shown = bench_.session.shownSnapshot();
  const int person = shown ? personIndexAt(*shown, camera, {pixel.x(), pixel.y()}) : -1;
  if (person >= 0) {
    bench_.selection.selectTarget(person);
  }
}

void PeopleDock::updateForMethod() {
  const bool people = tracksPeople();
  if (!people) {
    bench_.action("actionPlacePerson")->setChecked(false);
  }
  if (!dock_->isHiddenByUser() == people || !bench_.session.isRunning()) {
    return;
  }
  dock_->setShownByUserChoice(people);
  for (ViewDock* other : others_) {
    other->setShownByUserChoice(!people);
  }
  if (people) {
    dock_->raise();
  }
}

void PeopleDock::placePeople(bool placing) {
  const bool can = placing && bench_.session.isRunning() && tracksPeople();
  addPersonTool_->setPersonPlacingMode(can, can ? bench_.document.project().parameters.at("floor_z")
                                                : 0.0);
  const QString hint = tr("Click a person in a camera image, or the floor in the bird's-eye view. "
                          "Press Esc to cancel.");
  if (can) {
    bench_.messages.showNotice(hint);
  } else if (bench_.messages.text() == hint) {
    bench_.messages.dismiss();
  }
}

void PeopleDock::requestExport() {
  if (!bench_.session.isRunning()) {
    return;
  }
  const int run = run_; // another one may be open by the time it is answered
  const QString folder = QFileDialog::getExistingDirectory(
      &bench_.window, tr("Folder for the 3D shapes of people"),
      QString::fromStdString(bench_.document.project().file.parent_path().string()));
  if (folder.isEmpty()) {
    return;
  }
  check_->start([this, folder, run](const auto&) {
    const bool occupied = QDir(folder).exists(QStringLiteral("volumes.csv")) ||
                          QDir(folder).exists(QStringLiteral("trajectory.csv"));
    return [this, folder, run, occupied] {
      if (occupied && run == run_) {
        bench_.messages.showQuestion(
            tr("%1 already contains files of an earlier export. Replace them?").arg(folder),
            {{tr("Replace"), [this, folder, run] { writeTables(folder, run); }}});
      } else {
        writeTables(folder, run);
      }
    };
  });
}

void PeopleDock::writeTables(const QString& folder, int run) {
  const Session* session = bench_.session.session();
  if (session == nullptr || run != run_) {
    bench_.messages.showError(tr("The run has ended, so the 3D shapes of people were not saved."));
    return;
  }
  const auto record = std::make_shared<const PeopleRecord>(session->peopleRecord());
  bench_.messages.showNotice(tr("Saving the 3D shapes of people…"));
  writing_->start([this, folder, record](const auto& progress) {
    auto saved = savePeople(*record, folder.toStdString(), progress);
    return std::function<void()>([this, folder, saved = std::move(saved)] {
      saved ? bench_.messages.showNotice(tr("Saved the positions, volumes, hulls and densities of "
                                            "the people in %1 (frames: %2).")
                                             .arg(folder)
                                             .arg(*saved))
            : bench_.messages.showError(errorText(saved.error()));
    });
  });
}

} // namespace dewpoint::ui
