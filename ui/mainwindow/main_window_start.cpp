// SPDX-License-Identifier: GPL-3.0-or-later
// How work begins and ends: start page, new projects, recent ones, dropped files, recovery.
#include "core/project/project.h"
#include "core/session/session.h"
#include "ui/actions/action_registry.h"
#include "ui/document/document.h"
#include "ui/document/recovery.h"
#include "ui/mainwindow/main_window.h"
#include "ui/mainwindow/status_bar_panel.h"
#include "ui/session/session_bridge.h"
#include "ui/start/new_project_page.h"
#include "ui/start/recent_projects.h"
#include "ui/start/start_page.h"
#include "ui/text/error_sentence.h"
#include "ui/widgets/message_bar.h"

#include <QAction>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QMenu>
#include <QMimeData>
#include <QStackedWidget>
#include <QTimer>

#include <utility>

namespace dewpoint::ui {

namespace {
constexpr int kUntilGoneMs = 8000;
}

namespace {

std::filesystem::path toPath(const QString& file) {
  return file.toStdString();
}

bool isProject(const QString& file) {
  return file.endsWith(QStringLiteral(".toml"), Qt::CaseInsensitive);
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

void MainWindow::makeStart() {
  start_ = new QStackedWidget(this);
  start_->setObjectName(QStringLiteral("start"));
  startPage_ = new StartPage(start_);
  newProject_ = new NewProjectPage(start_);
  start_->addWidget(startPage_);
  start_->addWidget(newProject_);
  setCentralWidget(start_);
  connect(startPage_, &StartPage::demoWanted, this, [this] { openProject({}); });
  connect(startPage_, &StartPage::videosWanted, this, [this] {
    beginNewProject({});
    newProject_->chooseVideos();
  });
  connect(startPage_, &StartPage::camerasWanted, this, [this] {
    beginNewProject({});
    newProject_->addConnectedCameras();
  });
  connect(startPage_, &StartPage::projectWanted, this,
          [this](const QString& file) { file.isEmpty() ? askOpen() : openProject(toPath(file)); });
  connect(newProject_, &NewProjectPage::cancelled, this, [this] { showStart(bridge_ == nullptr); });
  connect(newProject_, &NewProjectPage::failed, this,
          [this](const QString& sentence) { messages_->showError(sentence); });
  connect(newProject_, &NewProjectPage::made, this,
          [this](const Project& project, const QString& note) {
            const bool boxes = methodFamily(project.method) == MethodFamily::Boxes;
            openUnsaved(project,
                        boxes ? tr("Click the thing or drag a box around it in any camera view.")
                        : note.isEmpty() ? tr("Click the thing to follow in any image: its color "
                                              "is learned and tracking starts.")
                                         : note);
          });
  setAcceptDrops(true);
}

void MainWindow::showStart(bool shown) {
  if (shown) {
    startPage_->refresh();
    start_->setCurrentWidget(startPage_);
  }
  showViews(!shown);
}

void MainWindow::showViews(bool shown) {
  if (!shown && bridge_ != nullptr && !start_->isVisible()) {
    layoutBehindPages_ = saveState();
  }
  if (shown) {
    start_->hide(); // whichever goes goes first: there is no room for both
  }
  figures_->setVisible(shown); // there is nothing to measure yet
  for (QDockWidget* dock : findChildren<QDockWidget*>()) {
    if (!shown) {
      dock->hide();
    } else if (!dock->property("closedByChoice").toBool()) {
      dock->show();
    }
  }
  start_->setVisible(!shown);
  if (shown && !layoutBehindPages_.isEmpty()) {
    restoreState(std::exchange(layoutBehindPages_, {}));
  }
  messages_->raise();
}

void MainWindow::beginNewProject(const QStringList& files) {
  newProject_->begin(files);
  start_->setCurrentWidget(newProject_);
  showViews(false);
}

void MainWindow::openUnsaved(const Project& project, const QString& note,
                             const std::optional<RecoverableWork>& recovered) {
  opening_ = {false, true, note, recovered};
  loader_->open(project);
}

void MainWindow::loadCalibrationOf(const QString& file) {
  auto made = withCalibration(document_->project(), toPath(file));
  if (made) {
    const auto edited = document_->edit(
        tr("Load calibration"), [&](Project& project) { project.cameras = made->project.cameras; });
    if (edited) {
      messages_->showNotice(made->matchedByOrder
                                ? tr("The calibration names its cameras differently: they were "
                                     "taken in its order.")
                                : tr("The cameras have the calibration of %1 now.").arg(file));
      return;
    }
    made = tl::make_unexpected(edited.error());
  }
  messages_->showError(errorSentence(made.error()));
}

void MainWindow::closeProject() {
  if (!mayDiscard()) {
    return;
  }
  if (bridge_ != nullptr) {
    loader_->retire(bridge_->release());
    delete std::exchange(bridge_, nullptr);
  }
  clearViews();
  document_->replace({});
  makeCameraDocks();
  updateEnabled();
  showStart(true);
}

void MainWindow::fillRecentMenu(QMenu* menu) {
  menu->clear();
  for (const QString& file : recentProjects()) {
    QAction* entry = menu->addAction(QFileInfo(file).completeBaseName());
    entry->setObjectName(QStringLiteral("qt_recent")); // a person's word, in no language of ours
    entry->setToolTip(file);
    connect(entry, &QAction::triggered, this, [this, file] {
      if (mayDiscard()) {
        openProject(toPath(file));
      }
    });
  }
  if (menu->isEmpty()) {
    menu->addAction(tr("Nothing yet"))->setEnabled(false);
    return;
  }
  menu->addSeparator();
  connect(menu->addAction(tr("Forget these")), &QAction::triggered, this, [this] {
    clearRecentProjects();
    startPage_->refresh();
  });
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!filesOf(*event->mimeData()).isEmpty()) {
    event->setDropAction(Qt::CopyAction); // nobody's files are moved
    event->accept();
  }
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QStringList files = filesOf(*event->mimeData());
  event->setDropAction(Qt::CopyAction);
  event->accept();
  if (start_->isVisible() && start_->currentWidget() == newProject_) {
    newProject_->addFiles(files);
    return;
  }
  if (!mayDiscard()) {
    return;
  }
  if (files.size() == 1 && isProject(files.front())) {
    openProject(toPath(files.front()));
  } else {
    beginNewProject(files);
  }
}

void MainWindow::useRecovery(const std::filesystem::path& folder) {
  recovery_ = new Recovery(*document_, folder, this);
  connect(recovery_, &Recovery::failed, this,
          [this](const QString& sentence) { messages_->showError(sentence); });
  connect(recovery_, &Recovery::writing, this, &MainWindow::keepLayout);
  offerRecovery();
  // A window that was killed may take a while to be gone.
  QTimer::singleShot(kUntilGoneMs, this, [this] {
    if (!offered_) {
      offerRecovery();
    }
  });
}

void MainWindow::offerRecovery() {
  const auto left = recovery_->leftBehind();
  if (left.empty()) {
    return;
  }
  offered_ = true;
  const RecoverableWork work = left.front();
  // Meanwhile a project may be opened, and much be said: the question comes back after that.
  messages_->askUntilAnswered(tr("Dewpoint did not end properly. Unsaved work on “%1” is from %2.")
                                  .arg(work.name, work.time),
                              {{tr("Recover it"), [this, work] { recover(work); }},
                               {tr("Throw it away"), [this, work] { throwAway(work); }}});
}

void MainWindow::throwAway(const RecoverableWork& work) {
  recovery_->putAside(work);
  offerRecovery(); // of other work, once this is read
  messages_->ask(tr("Unsaved work on “%1” was thrown away.").arg(work.name),
                 {{tr("Take it back"), [this, work] {
                     recovery_->takeBack(work);
                     offerRecovery();
                   }}});
}

void MainWindow::recover(const RecoverableWork& work) {
  if (!mayDiscard()) { // the question came late, and there is other work by now
    offerRecovery();
    return;
  }
  const auto project = recovery_->recover(work);
  if (project) {
    openUnsaved(*project, tr("Recovered. Save the project to keep it."), work);
  } else {
    messages_->showError(errorSentence(project.error()));
  }
}

} // namespace dewpoint::ui
