// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/recording/take_controller.h"

#include "core/project/project.h"
#include "core/session/session.h"
#include "ui/document/document.h"
#include "ui/preferences/preferences.h"
#include "ui/recording/take_comparison.h"
#include "ui/recording/take_text.h"
#include "ui/text/error_sentence.h"
#include "ui/text/quantity_text.h"
#include "ui/widgets/message_bar.h"

#include <QAction>
#include <QDesktopServices>
#include <QLabel>
#include <QMainWindow>
#include <QStandardPaths>
#include <QStatusBar>
#include <QUrl>

#include <chrono>
#include <utility>

namespace dewpoint::ui {

namespace {
/// How often the label is updated. Chosen: seconds are seen to count.
constexpr std::chrono::milliseconds kTakeUpdate(250);
} // namespace

TakeController::TakeController(const Workbench& bench)
    : QObject(&bench.window), bench_(bench), action_(bench.action("actionRecord")),
      label_(new QLabel(&bench.window)), job_(new BackgroundJob(this)),
      notesJobs_(new JobQueue(this)) {
  label_->setObjectName(QStringLiteral("takeLabel"));
  label_->hide();
  bench_.window.statusBar()->addPermanentWidget(label_);
  connect(action_, &QAction::triggered, this, &TakeController::toggle);
  bench_.onTriggered("actionTakeNotes", this, [this] { editDetails(recorder_); });
  connect(&timer_, &QTimer::timeout, this, &TakeController::showStatus);
  connect(&bench_.session, &SessionController::runStarted, this, [this] {
    keepPreRoll();
    updateAction();
  });
  connect(&bench_.session, &SessionController::runAboutToEnd, this,
          [this] { stop(tr("The recording ended, because its cameras were closed.")); });
  connect(&bench_.session, &SessionController::runEnded, this, &TakeController::updateAction);
  connect(job_, &BackgroundJob::ended, this, &TakeController::updateAction);
  updateAction();
  new TakeComparison(bench_);
}

std::filesystem::path TakeController::folderForTakes() const {
  const auto& file = bench_.document.project().file;
  if (!file.empty()) {
    return file.parent_path() / (file.stem().string() + "-takes");
  }
  const QString videos = QStandardPaths::writableLocation(QStandardPaths::MoviesLocation);
  return std::filesystem::path(videos.toStdString()) / "Dewpoint";
}

TakeStatus TakeController::status() const {
  return recorder_ != nullptr ? recorder_->status() : TakeStatus();
}

void TakeController::toggle(bool record) {
  if (record) {
    start();
  } else {
    stop({});
  }
}

void TakeController::startTakeNamed(const QString& name) {
  if (action_->isEnabled() && !action_->isChecked()) {
    name_ = name;
    action_->trigger();
  }
}

void TakeController::start() {
  using Started = Result<std::unique_ptr<TakeRecorder>>;
  const bool starts =
      job_->start([this, project = bench_.document.project(), feeds = bench_.session.encodedFeeds(),
                   folder = folderForTakes(), options = nextOptions()](
                      const BackgroundJob::Progress&) -> std::function<void()> {
        auto take = std::make_shared<Started>(TakeRecorder::start(project, feeds, folder, options));
        return [this, take] {
          if (!*take) {
            name_.clear();
            bench_.messages.showError(errorText(take->error()));
            return;
          }
          recorder_ = std::move(**take);
          next_ = {}; // the one after it counts up by itself
          shownProblem_.clear();
          timer_.start(kTakeUpdate);
          showStatus();
          Q_EMIT started();
          name_.clear();
        };
      });
  action_->setEnabled(!starts);
}

void TakeController::stop(const QString& reason) {
  const auto recorder = std::exchange(recorder_, nullptr);
  if (recorder == nullptr) {
    return;
  }
  timer_.stop();
  label_->hide();
  action_->setEnabled(false);
  // Completing the files takes up to a second.
  job_->start([this, recorder, reason,
               live = liveRun()](const BackgroundJob::Progress&) -> std::function<void()> {
    (void)recorder->stop(); // its problem is in the status
    const Status added = recorder->addLiveRun(*live);
    return [this, recorder, reason, added] {
      finish(recorder, reason);
      if (!added) {
        bench_.messages.showWarning(errorText(added.error()));
      }
    };
  });
}

std::shared_ptr<const LiveRun> TakeController::liveRun() const {
  auto live = std::make_shared<LiveRun>();
  if (const Session* session = bench_.session.session()) {
    RunRecord record = session->record();
    live->report = runReport(record.project, record.statistics);
    live->project = std::move(record.project);
    live->trajectory = std::move(record.people.trajectory);
    live->frameRecords = session->liveFrameRecords();
    live->framesWithOtherSettings = session->oldResults().frameRanges;
  }
  return live;
}

void TakeController::finish(const std::shared_ptr<TakeRecorder>& recorder, const QString& reason) {
  const TakeStatus take = recorder->status();
  const QString folder = QString::fromStdString(take.folder.string());
  QString text = tr("Take %1 (%2) was saved in %3.")
                     .arg(take.takeNumber)
                     .arg(minutesAndSecondsText(take.durationSeconds), folder);
  if (!reason.isEmpty()) {
    text.prepend(reason + QLatin1Char(' '));
  }
  if (const QString before = preRollText(take); !before.isEmpty()) {
    text += QLatin1Char(' ') + before;
  }
  if (const QString problem = takeProblemText(take); !problem.isEmpty()) {
    text += QLatin1Char(' ') + tr("Problem: %1").arg(problem);
  }
  bench_.messages.showQuestion(
      text,
      {{tr("Open take"), [this, take] { Q_EMIT openRequested(take.folder / "project.toml"); }},
       {tr("Show folder"), [folder] { QDesktopServices::openUrl(QUrl::fromLocalFile(folder)); }},
       {tr("Notes…"), [this, recorder] { editDetails(recorder); }}});
  Q_EMIT stopped(take);
}

void TakeController::keepPreRoll() {
  TakeRecorder::setPreRoll(bench_.session.encodedFeeds(), Preferences().preRollSeconds());
}

TakeOptions TakeController::nextOptions() const {
  TakeOptions options;
  options.notes = (next_.notes.isEmpty() ? name_ : next_.notes).toStdString();
  if (next_.takeNumber > 0) {
    options.number = next_.takeNumber;
  }
  return options;
}

void TakeController::editDetails(const std::shared_ptr<TakeRecorder>& take) {
  TakeDetails details = next_;
  if (take != nullptr) {
    const TakeStatus status = take->status();
    details = {status.takeNumber, QString::fromStdString(status.notes)};
  } else {
    details.preRollSeconds = Preferences().preRollSeconds();
  }
  auto* dialog = new TakeDialog(details, take != nullptr, &bench_.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog, take] {
    if (take != nullptr) {
      saveNotes(take, dialog->details().notes);
    } else {
      next_ = dialog->details();
      if (next_.preRollSeconds != Preferences().preRollSeconds()) {
        Preferences().setPreRollSeconds(next_.preRollSeconds);
        keepPreRoll();
      }
    }
  });
  // The next take has become this one: its number is fixed.
  connect(this, &TakeController::started, dialog, [this, dialog, take] {
    if (take == nullptr) {
      const QString notes = dialog->details().notes;
      saveNotes(recorder_, notes.isEmpty() ? name_ : notes);
      dialog->reject();
    }
  });
  Workbench::presentDialog(dialog);
}

void TakeController::saveNotes(const std::shared_ptr<TakeRecorder>& take, const QString& notes) {
  notesJobs_->add([this, take, notes]() -> std::function<void()> {
    const Status saved = take->setNotes(notes.toStdString());
    if (saved) {
      return {};
    }
    return [this, text = errorText(saved.error())] { bench_.messages.showError(text); };
  });
}

void TakeController::showStatus() {
  const TakeStatus take = status();
  label_->setText(QStringLiteral("● ") + takeSummaryText(take));
  label_->setToolTip(takeDetailsText(take));
  label_->show();
  const QString problem = takeProblemText(take);
  if (!problem.isEmpty() && problem != shownProblem_) {
    bench_.messages.showWarning(problem);
  }
  shownProblem_ = problem;
}

void TakeController::updateAction() {
  const bool isLive = !bench_.session.encodedFeeds().empty();
  action_->setEnabled(isLive && !job_->isRunning());
  bench_.action("actionTakeNotes")->setEnabled(isLive);
  action_->setChecked(isRecording());
}

} // namespace dewpoint::ui
