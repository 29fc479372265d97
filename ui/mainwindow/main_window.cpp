// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/main_window.h"

#include "core/session/session.h"
#include "ui/birdseye/birds_eye_view.h"
#include "ui/bridge/error_sentence.h"
#include "ui/bridge/session_bridge.h"
#include "ui/camera/camera_view.h"
#include "ui/document/document.h"
#include "ui/mainwindow/message_bar.h"
#include "ui/mainwindow/status_figures.h"
#include "ui/plots/convergence_plot.h"
#include "ui/settings/parameter_panel.h"
#include "ui/transport/transport_actions.h"

#include <QAction>
#include <QDockWidget>
#include <QRandomGenerator>
#include <QUndoStack>

#include <algorithm>

namespace dewpoint {

MainWindow::MainWindow(ProjectOpener opener, QWidget* parent)
    : QMainWindow(parent), loader_(new ProjectLoader(std::move(opener), this)),
      document_(new Document(this)), actions_(new TransportActions(this)) {
  setObjectName(QStringLiteral("mainWindow"));
  setDockNestingEnabled(true);
  makeDocks();
  makeToolBar();
  makeMenus();
  connectActions();
  connectRun();
  setTheme(theme_);
  updateTitle();
  updateEnabled();
  resize(1400, 900);
  arrange();
}

MainWindow::~MainWindow() {
  if (bridge_ != nullptr) {
    disconnect(bridge_, nullptr, this, nullptr);
  }
  document_->disconnect(this);
  document_->undoStack()->disconnect(this);
}

void MainWindow::connectRun() {
  connect(
      loader_, &ProjectLoader::opened, this,
      [this](const std::shared_ptr<SessionInputs>& inputs) { adoptInputs(std::move(*inputs)); });
  connect(loader_, &ProjectLoader::failed, this, [this](const QString& sentence) {
    messages_->showError(sentence);
    Q_EMIT openFailed(sentence);
  });
  connect(loader_, &ProjectLoader::openingChanged, this, &MainWindow::updateEnabled);
  connect(document_, &Document::parameterChanged, this, [this] {
    if (bridge_ != nullptr) {
      bridge_->session().setParameters(document_->project().parameters);
    }
  });
  connect(document_, &Document::methodChanged, this, [this] {
    if (bridge_ != nullptr) {
      bridge_->session().setMethod(document_->project().method, document_->project().parameters);
    }
  });
  connect(document_, &Document::replaced, this, &MainWindow::updateTitle);
  connect(document_, &Document::fileChanged, this, &MainWindow::updateTitle);
  connect(document_->undoStack(), &QUndoStack::cleanChanged, this,
          [this](bool clean) { setWindowModified(!clean); });
}

void MainWindow::openProject(const std::filesystem::path& file) {
  loader_->open(file);
}

void MainWindow::adoptInputs(SessionInputs inputs) {
  if (bridge_ != nullptr) {
    loader_->retire(bridge_->release());
    delete bridge_;
  }
  shown_.reset();
  logGeneration_ = 0;
  logPosition_ = 0;
  noticesShown_ = 0;
  figures_->clear();
  plot_->clear();
  birdsEye_->show(TrackSnapshotPtr());
  document_->replace(inputs.project);
  bridge_ = new SessionBridge(std::move(inputs), this);
  connect(bridge_, &SessionBridge::snapshotChanged, this, &MainWindow::showSnapshot);
  makeCameraDocks();
  bridge_->session().setMasksWanted(actions_->showMask->isChecked());
  updateEnabled();
  showSnapshot(bridge_->session().newest());
  if (playOnOpen_) {
    bridge_->session().play();
  } else {
    bridge_->session().stepFrame(); // something to look at
  }
  Q_EMIT projectOpened();
}

void MainWindow::showSnapshot(const TrackSnapshotPtr& snapshot) {
  shown_ = snapshot;
  for (CameraView* view : cameraViews_) {
    view->show(snapshot);
  }
  birdsEye_->show(snapshot);
  figures_->show(*snapshot);
  actions_->setPlaying(snapshot->state == PlayState::Playing);
  pullLog();
  showNotices(*snapshot);
  Q_EMIT snapshotShown(snapshot);
}

void MainWindow::pullLog() {
  const Session::LogPiece piece = bridge_->session().logSince(logGeneration_, logPosition_);
  if (piece.restarted) {
    plot_->clear();
  }
  plot_->append(piece.records);
}

void MainWindow::showNotices(const TrackSnapshot& snapshot) {
  if (snapshot.notices.size() > noticesShown_) {
    messages_->showNotice(errorSentence(snapshot.notices.back()));
  }
  noticesShown_ = snapshot.notices.size();
}

void MainWindow::togglePlay() {
  if (bridge_ == nullptr) {
    return;
  }
  Session& session = bridge_->session();
  const PlayState state = shown_ ? shown_->state : PlayState::Paused;
  if (state == PlayState::Playing) {
    session.pause();
    return;
  }
  if (state == PlayState::Ended) {
    session.restart();
  }
  session.play();
}

void MainWindow::restart(bool newSeed) {
  if (bridge_ == nullptr) {
    return;
  }
  if (newSeed) {
    // 31 bits: short enough to be read out and typed.
    bridge_->session().restart(QRandomGenerator::global()->generate() >> 1U);
  } else {
    bridge_->session().restart();
  }
}

void MainWindow::updateTitle() {
  const QString name = QString::fromStdString(document_->project().name);
  setWindowTitle(name.isEmpty() ? tr("Dewpoint") : tr("%1[*] – Dewpoint").arg(name));
}

void MainWindow::updateEnabled() {
  const bool running = bridge_ != nullptr;
  for (QAction* action : {actions_->play, actions_->nextFrame, actions_->nextIteration,
                          actions_->restart, actions_->restartNewSeed, actions_->showMask,
                          actions_->save, actions_->saveAs, actions_->exportTrajectory}) {
    action->setEnabled(running);
  }
  actions_->openProject->setEnabled(!loader_->isOpening());
  actions_->openDemo->setEnabled(!loader_->isOpening());
}

void MainWindow::setTheme(Theme theme) {
  theme_ = theme;
  applyTheme(theme);
  actions_->drawIcons(themePalette(isDark(theme)));
  QAction* chosen = theme == Theme::Light  ? actions_->themeLight
                    : theme == Theme::Dark ? actions_->themeDark
                                           : actions_->themeSystem;
  chosen->setChecked(true);
}

} // namespace dewpoint
