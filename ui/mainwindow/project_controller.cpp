// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/project_controller.h"

#include "core/project/project.h"
#include "core/setup/new_project/new_project.h"
#include "ui/document/document.h"
#include "ui/document/method_presentation.h"
#include "ui/mainwindow/changes_guard.h"
#include "ui/mainwindow/missing_files_offer.h"
#include "ui/mainwindow/project_endings.h"
#include "ui/mainwindow/recent_menu.h"
#include "ui/mainwindow/recovery_offer.h"
#include "ui/mainwindow/thumbnail_writer.h"
#include "ui/session/open_request.h"
#include "ui/start/new_project_page.h"
#include "ui/start/recent_projects.h"
#include "ui/start/start_page.h"
#include "ui/widgets/file_choice.h"
#include "ui/widgets/message_bar.h"
#include "ui/workbench/dock_manager.h"

#include <QAction>
#include <QMainWindow>
#include <QMimeData>
#include <QStackedWidget>
#include <QUrl>

#include <utility>

namespace dewpoint::ui {

namespace {

std::filesystem::path toPath(const QString& file) {
  return file.toStdString();
}

QStringList filesOf(const QMimeData& data) {
  QStringList files;
  for (const QUrl& url : data.urls()) {
    if (url.isLocalFile()) {
      files.append(url.toLocalFile());
    }
  }
  return files;
}

} // namespace

ProjectController::ProjectController(const Workbench& bench)
    : QObject(&bench.window), bench_(bench), recent_(new RecentProjects(this)),
      recentMenu_(new RecentMenu(*recent_, this)), thumbnails_(new ThumbnailWriter(bench, this)),
      changes_(new ChangesGuard(bench, this)) {
  makePages();
  connectPages();
  connectActions();
  connectRun();
  connectOpening();
  bench_.window.setAcceptDrops(true);
}

void ProjectController::makePages() {
  pages_ = new QStackedWidget(&bench_.window);
  pages_->setObjectName(QStringLiteral("start"));
  startPage_ = new StartPage(*recent_, pages_);
  newProject_ = new NewProjectPage(pages_);
  pages_->addWidget(startPage_);
  pages_->addWidget(newProject_);
  bench_.window.setCentralWidget(pages_);
}

void ProjectController::connectPages() {
  connect(startPage_, &StartPage::builtInSceneRequested, this, &ProjectController::openScene);
  connect(startPage_, &StartPage::startWithVideosRequested, this, [this] {
    showNewProjectPage({});
    newProject_->chooseVideos();
  });
  connect(startPage_, &StartPage::startWithCamerasRequested, this, [this] {
    showNewProjectPage({});
    newProject_->addConnectedCameras();
  });
  connect(startPage_, &StartPage::calibrationRequested, this, [this] {
    showNewProjectPage({}, false); // the cameras are about to be calibrated
    guideNewProject_ = true;
    newProject_->chooseVideos();
  });
  connect(startPage_, &StartPage::projectRequested, this,
          [this](const QString& file) { file.isEmpty() ? chooseProject() : open(toPath(file)); });
  connect(newProject_, &NewProjectPage::canceled, this, [this] {
    if (bench_.session.isRunning()) {
      bench_.docks.showViews(true);
    } else {
      showStartPage();
    }
  });
  connect(newProject_, &NewProjectPage::failed, &bench_.messages, &MessageBar::showError);
  connect(newProject_, &NewProjectPage::created, this, &ProjectController::openCreated);
}

void ProjectController::connectActions() {
  const auto unlessUnsaved = [this](const std::function<void()>& run) {
    return [this, run] { changes_->runAfterSaveOrDiscard(run); };
  };
  connect(recentMenu_, &RecentMenu::openRequested, this, [this](const QString& file) {
    changes_->runAfterSaveOrDiscard([this, file] { open(toPath(file)); });
  });
  bench_.onTriggered("actionNew", this, unlessUnsaved([this] { showNewProjectPage({}); }));
  bench_.onTriggered("actionOpen", this, [this] { chooseProject(); });
  bench_.onTriggered("actionOpenDemo", this, unlessUnsaved([this] { open({}); }));
  bench_.onTriggered("actionCloseProject", this, unlessUnsaved([this] { close(); }));
  bench_.requireRun({"actionCloseProject"});
}

void ProjectController::connectOpening() {
  connect(&bench_.session, &SessionController::openingChanged, this, [this](bool opening) {
    bench_.action("actionOpen")->setEnabled(!opening);
    bench_.action("actionOpenDemo")->setEnabled(!opening);
    startPage_->setOpening(opening);
    if (opening) { // at once: what is opened may take a second
      bench_.window.setCursor(Qt::BusyCursor);
    } else {
      bench_.window.unsetCursor();
    }
  });
  connect(&bench_.session, &SessionController::opened, this, [this](const OpenRequest& request) {
    if (request.opensCalibrationPage) {
      bench_.action("actionCalibrateByHand")->setChecked(true);
    }
    if (request.opensCalibrationGuide) { // the action is enabled once the page that covers the run
                                         // is gone
      QMetaObject::invokeMethod(bench_.action("actionCalibrate"), &QAction::trigger,
                                Qt::QueuedConnection);
    }
  });
  connect(changes_, &ChangesGuard::saved, this, [this](const QString& file) {
    recent_->add(file);
    thumbnails_->saveThumbnail();
  });
  connect(thumbnails_, &ThumbnailWriter::saved, recent_, &RecentProjects::checkFiles);
}

void ProjectController::openScene(const QString& name, bool calibrate) {
  bench_.session.open({.sessionRequest = toPath(name), .opensCalibrationPage = calibrate});
}

void ProjectController::connectRun() {
  const SessionController* run = &bench_.session;
  connect(run, &SessionController::runStarted, this, [this] { bench_.docks.showViews(true); });
  connect(run, &SessionController::runEnded, &bench_.docks, &DockManager::forgetLayoutBehindPages);
  connect(run, &SessionController::documentAboutToBeReplaced, this,
          [this](const OpenRequest& request) {
            bench_.messages.removeOldMessages(!request.keepsHistory);
          });
  connect(run, &SessionController::documentReplaced, this, [this](const OpenRequest& request) {
    const auto& file = bench_.document.project().file;
    if (!request.keepsHistory && !file.empty()) {
      recent_->add(QString::fromStdString(file.string()));
    }
    if (request.recovered && recovery_ != nullptr) {
      recovery_->adoptBackup(*request.recovered);
    }
  });
  connect(run, &SessionController::opened, this, [this](const OpenRequest& request) {
    if (!request.message.isEmpty()) {
      bench_.messages.showNotice(request.message);
    }
  });
  connect(run, &SessionController::openFailed, &bench_.messages, &MessageBar::showError);
  connect(run, &SessionController::openFailed, recent_, &RecentProjects::checkFiles);
  new MissingFilesOffer(bench_);
}

void ProjectController::open(const std::filesystem::path& file) {
  bench_.session.open({.sessionRequest = file});
}

void ProjectController::showStartPage() {
  startPage_->refresh();
  pages_->setCurrentWidget(startPage_);
  bench_.docks.showViews(false);
}

void ProjectController::showNewProjectPage(const QStringList& files, bool findsCalibration) {
  guideNewProject_ = false;
  newProject_->startNewProject(files, findsCalibration);
  pages_->setCurrentWidget(newProject_);
  bench_.docks.showViews(false);
}

void ProjectController::openCreated(const Project& project, const QString& note) {
  const bool boxes = presentationOf(project).targetsAreBoxes;
  const bool isCalibrated = !hasGuessedPose(project); // else the guide asks for it
  const QString hint =
      boxes ? tr("Click the object or drag a box around it in any camera view.")
      : note.isEmpty() && isCalibrated
          ? tr("Click the object to track in any image. Its color is learned and tracking starts.")
          : note;
  bench_.session.open({.sessionRequest = project,
                       .isUnsaved = true,
                       .opensCalibrationGuide = std::exchange(guideNewProject_, false),
                       .message = hint});
}

void ProjectController::chooseProject() {
  changes_->runAfterSaveOrDiscard([this] {
    const QString file =
        askForFile(&bench_.window, tr("Open a project"),
                   withAllProjectSuffixes(tr("Dewpoint projects (*.toml);;All files (*)")));
    if (!file.isEmpty()) {
      open(toPath(file));
    }
  });
}

void ProjectController::close() {
  bench_.session.close();
  if (MessageBar& bar = bench_.messages; !bar.isQuestionOpen(bar.text())) {
    bar.dismiss(); // it was about what is closed
  }
  showStartPage();
}

ProjectSaver& ProjectController::saver() {
  return changes_->saver();
}

bool ProjectController::confirmClose() {
  if (!changes_->confirmDiscard([this] { bench_.window.close(); })) {
    return false;
  }
  thumbnails_->saveThumbnail();
  if (recovery_ != nullptr) {
    recovery_->removeBackup(); // saved, or given up on purpose
  }
  return true;
}

void ProjectController::fillRecentMenu(QMenu* menu) {
  recentMenu_->fill(menu);
}

bool ProjectController::canDrop(const QMimeData& data) {
  return !filesOf(data).isEmpty();
}

void ProjectController::drop(const QMimeData& data) {
  const QStringList files = filesOf(data);
  if (pages_->isVisible() && pages_->currentWidget() == newProject_) {
    newProject_->addFiles(files);
    return;
  }
  changes_->runAfterSaveOrDiscard([this, files] {
    if (files.size() == 1 && isProjectFile(files.front())) {
      open(toPath(files.front()));
    } else {
      showNewProjectPage(files);
    }
  });
}

void ProjectController::enableRecovery(const std::filesystem::path& folder, TextWriter write) {
  recovery_ = new RecoveryOffer(bench_, folder, std::move(write));
  connect(recovery_, &RecoveryOffer::recoveryRequested, this, [this](const RecoverableWork& work) {
    const auto read = [this, work] { recovery_->recover(work); };
    if (changes_->confirmDiscard(read)) {
      read();
    } else {
      recovery_->offerRecovery(); // the question came late, and there is other work by now
    }
  });
  connect(recovery_, &RecoveryOffer::recovered, this,
          [this](const Project& project, const RecoverableWork& work) {
            bench_.session.open(
                {.sessionRequest = project,
                 .isUnsaved = true,
                 .message = tr("The changes were recovered. Save the project to keep them."),
                 .recovered = work});
          });
}

} // namespace dewpoint::ui
