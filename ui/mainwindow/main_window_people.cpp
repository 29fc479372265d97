// SPDX-License-Identifier: GPL-3.0-or-later
// Methods for people: who is there, who stands where, and what is exported of them.
#include "core/project/project.h"
#include "core/session/session.h"
#include "ui/actions/action_registry.h"
#include "ui/cameraview/camera_view.h"
#include "ui/cameraview/people_painter.h"
#include "ui/color/color_panel.h"
#include "ui/document/document.h"
#include "ui/jobs/long_job.h"
#include "ui/mainwindow/main_window.h"
#include "ui/people/add_person_tool.h"
#include "ui/people/people_panel.h"
#include "ui/selection/selection.h"
#include "ui/session/session_bridge.h"
#include "ui/text/error_sentence.h"
#include "ui/view3d/birds_eye_view.h"
#include "ui/widgets/message_bar.h"

#include <QAction>
#include <QDir>
#include <QDockWidget>
#include <QFileDialog>

#include <memory>

namespace dewpoint::ui {

namespace {

bool isOfPeople(const Project& project) {
  return methodFamily(project.method) == MethodFamily::People;
}

} // namespace

void MainWindow::makePeople() {
  people_ =
      new PeoplePanel(*selection_, action("actionPlacePerson"), action("actionRemovePerson"), this);
  peopleDock_ = makeDock(
      QStringLiteral("peopleDock"), [] { return tr("People"); }, people_);
  peopleDock_->setMinimumWidth(384);                // room for all columns
  peopleDock_->setProperty("closedByChoice", true); // until a method for people is chosen
  placer_ = new AddPersonTool(birdsEye_, this);
  peopleJob_ = new LongJob(this);
}

void MainWindow::connectPeople() {
  connect(placer_, &AddPersonTool::seen, this, [this](int camera, const Eigen::Vector2d& pixel) {
    if (bridge_ != nullptr) {
      bridge_->session().addPersonSeen(camera, pixel);
    }
    action("actionPlacePerson")->setChecked(false);
  });
  connect(placer_, &AddPersonTool::placed, this, [this](const Eigen::Vector2d& place) {
    if (bridge_ != nullptr) {
      bridge_->session().addPerson(place);
    }
    action("actionPlacePerson")->setChecked(false);
  });
  connect(placer_, &AddPersonTool::cancelled, action("actionPlacePerson"),
          [this] { action("actionPlacePerson")->setChecked(false); });
  connect(action("actionPlacePerson"), &QAction::toggled, this, &MainWindow::placePeople);
  connect(action("actionRemovePerson"), &QAction::triggered, this, [this] {
    if (bridge_ != nullptr && people_->chosen() > 0) {
      bridge_->session().removePerson(people_->chosen());
    }
  });
  connect(action("actionShowVolumes"), &QAction::toggled, this, [this](bool shown) {
    if (bridge_ != nullptr) {
      bridge_->session().setShapesWanted(shown);
    }
  });
  connect(color_, &ColorPanel::pointed, this, [this](int camera, const QPointF& pixel) {
    const int person = shown_ ? personSeenAt(*shown_, camera, pixel) : -1;
    if (person >= 0) {
      selection_->selectTarget(person);
    }
  });
  connect(birdsEye_, &BirdsEyeView::personClicked, selection_, &Selection::selectTarget);
  connect(action("actionExportPeople"), &QAction::triggered, this, &MainWindow::exportPeople);
  connect(selection_, &Selection::targetSelected, this, [this](int target) {
    for (CameraView* view : cameraViews_) {
      view->setChosenTarget(target);
    }
    birdsEye_->setChosenTarget(target);
  });
  connect(document_, &Document::replaced, this, &MainWindow::suitMethod);
  connect(document_, &Document::methodChanged, this, &MainWindow::suitMethod);
}

void MainWindow::suitMethod() {
  const bool people = isOfPeople(document_->project());
  const bool running = bridge_ != nullptr;
  for (const char* id : {"actionPlacePerson", "actionRemovePerson", "actionExportPeople"}) {
    action(id)->setEnabled(running && people);
  }
  action("actionShowVolumes")->setEnabled(running && people);
  if (!people) {
    action("actionPlacePerson")->setChecked(false);
  }
  const bool before = !peopleDock_->property("closedByChoice").toBool();
  if (before == people || !running) {
    return;
  }
  // What the other methods' targets are made of means nothing to people, and the other way round.
  for (QDockWidget* dock : {targetDock_, colorDock_, peopleDock_}) {
    const bool shown = (dock == peopleDock_) == people;
    dock->setProperty("closedByChoice", !shown);
    dock->setVisible(shown);
  }
  if (people) {
    peopleDock_->raise();
  }
}

void MainWindow::placePeople(bool placing) {
  const Project& project = document_->project();
  const bool can = placing && bridge_ != nullptr && isOfPeople(project);
  placer_->setPlacing(can, can ? project.parameters.at("floor_z") : 0.0);
  const QString hint =
      tr("Click somebody in a camera image, or the floor in the bird's-eye view. Esc ends it.");
  if (can) {
    messages_->showNotice(hint);
  } else if (messages_->text() == hint) {
    messages_->close();
  }
}

void MainWindow::exportPeople() {
  if (bridge_ == nullptr) {
    return;
  }
  const QString folder = QFileDialog::getExistingDirectory(
      this, tr("Folder for the tables of people"),
      QString::fromStdString(document_->project().file.parent_path().string()));
  if (folder.isEmpty()) {
    return;
  }
  if (QDir(folder).exists(QStringLiteral("volumes.csv")) ||
      QDir(folder).exists(QStringLiteral("trajectory.csv"))) {
    messages_->ask(tr("There are tables of another run in %1. Replace them?").arg(folder),
                   {{tr("Replace"), [this, folder] { writePeople(folder); }}});
  } else {
    writePeople(folder);
  }
}

void MainWindow::writePeople(const QString& folder) {
  if (bridge_ == nullptr) { // closed meanwhile
    return;
  }
  const auto record = std::make_shared<const PeopleRecord>(bridge_->session().peopleRecord());
  const bool begun = peopleJob_->start([this, folder, record](const auto& progress) {
    auto saved = savePeople(*record, folder.toStdString(), progress);
    return std::function<void()>([this, folder, saved = std::move(saved)] {
      saved ? messages_->showNotice(
                  tr("Places, volumes, hulls and densities of people are in %1 (frames: %2).")
                      .arg(folder)
                      .arg(*saved))
            : messages_->showError(errorSentence(saved.error()));
    });
  });
  if (begun) {
    messages_->showNotice(tr("Writing the tables of people…"));
  }
}

} // namespace dewpoint::ui
