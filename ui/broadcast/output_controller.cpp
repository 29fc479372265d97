// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/broadcast/output_controller.h"

#include "core/project/project.h"
#include "ui/broadcast/outlet_text.h"
#include "ui/broadcast/output_dialog.h"
#include "ui/broadcast/page_text.h"
#include "ui/document/document.h"
#include "ui/jobs/job_thread.h"
#include "ui/text/error_sentence.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/message_bar.h"

#include <QAction>
#include <QLabel>
#include <QMainWindow>
#include <QPointer>
#include <QStatusBar>
#include <QStringList>

#include <chrono>
#include <utility>

namespace dewpoint::ui {

namespace {
constexpr std::chrono::seconds kOutputUpdate(1);
} // namespace

OutputController::OutputController(const Workbench& bench)
    : QObject(&bench.window), bench_(bench), action_(bench.action("actionSendResults")),
      label_(new QLabel(&bench.window)), job_(new BackgroundJob(this)) {
  label_->setObjectName(QStringLiteral("outputLabel"));
  label_->hide();
  bench_.window.statusBar()->addPermanentWidget(label_);
  connect(action_, &QAction::triggered, this, &OutputController::toggle);
  connect(&timer_, &QTimer::timeout, this, &OutputController::showStatus);
  bench_.onTriggered("actionOutputs", this, [this] {
    auto* dialog = bench_.window.findChild<OutputDialog*>();
    if (dialog == nullptr) {
      dialog = new OutputDialog(bench_.document, &bench_.window);
      dialog->setAttribute(Qt::WA_DeleteOnClose);
    }
    Workbench::presentDialog(dialog);
  });
  bench_.requireRun({"actionOutputs"});
  connect(&bench_.session, &SessionController::snapshotChanged, this,
          [this](const TrackSnapshotPtr& snapshot) {
            if (broadcaster_ != nullptr && snapshot != nullptr) {
              broadcaster_->enqueue(snapshot);
            }
          });
  connect(&bench_.session, &SessionController::runStarted, this, &OutputController::updateAction);
  connect(&bench_.session, &SessionController::closed, this, [this] {
    wanted_ = false;
    close();
  });
  connect(&bench_.document, &Document::projectReplaced, this, [this] {
    wanted_ = false; // another project has outputs that nobody has switched on
    close();
  });
  connect(&bench_.document, &Document::changed, this, [this] {
    if (bench_.document.project().output != opened_ && wanted_) {
      close();
      open();
    }
    updateAction();
  });
  onRetranslate(label_, [this] {
    if (broadcaster_ != nullptr) {
      broadcaster_->setPageTexts(pageTexts());
    }
  });
  connect(job_, &BackgroundJob::ended, this, &OutputController::updateAction);
  updateAction();
}

std::vector<broadcast::OutletReport> OutputController::outletReports() const {
  return broadcaster_ != nullptr ? broadcaster_->reports() : std::vector<broadcast::OutletReport>();
}

void OutputController::toggle(bool send) {
  wanted_ = send;
  if (!send) {
    close();
  } else if (bench_.document.project().output.isAnyOn()) {
    open();
  } else {
    wanted_ = false;
    bench_.action("actionOutputs")->trigger(); // there is nothing to send to yet
  }
  updateAction();
}

void OutputController::open() {
  const Project& project = bench_.document.project();
  opened_ = project.output;
  if (!opened_.isAnyOn()) {
    return;
  }
  broadcast::BroadcastInputs inputs;
  inputs.settings = project.output;
  inputs.folder = project.file.parent_path();
  inputs.volume = project.volumeOfInterest;
  inputs.texts = pageTexts();
  const QPointer<OutputController> self(this);
  inputs.receiver = [self](const broadcast::RemoteCommand& command) -> Status {
    // Called by a thread of the outputs, which must not wait for the window.
    QMetaObject::invokeMethod(
        self, [self, command] { self->receive(command); }, Qt::QueuedConnection);
    return {};
  };
  // Ports and files are free again when the outputs before have ended, which may wait for a disk.
  const std::shared_future<void> before = ended_;
  const auto end = std::make_shared<std::promise<void>>();
  ended_ = end->get_future().share();
  // Names of other computers are looked up, which takes time.
  job_->start([this, inputs, before, end,
               opener = opener_](const BackgroundJob::Progress& isNeeded) -> std::function<void()> {
    if (before.valid()) {
      before.wait();
    }
    if (!isNeeded(-1.0)) {
      end->set_value();
      return {};
    }
    auto opened = opener(inputs);
    if (!opened) {
      end->set_value();
      return [this, error = opened.error()] {
        wanted_ = false;
        bench_.messages.showError(errorText(error));
        updateAction();
        Q_EMIT changed();
      };
    }
    // Its destructor waits for its threads. Whoever releases it last does not.
    const std::shared_ptr<broadcast::Broadcaster> broadcaster(
        opened->release(), [end](broadcast::Broadcaster* sending) {
          runDetached([sending, end] {
            delete sending;
            end->set_value();
          });
        });
    return [this, broadcaster] { startSending(broadcaster); };
  });
}

void OutputController::startSending(std::shared_ptr<broadcast::Broadcaster> broadcaster) {
  if (wanted_) {
    broadcaster_ = std::move(broadcaster);
    broadcaster_->setPageTexts(pageTexts()); // the language may have changed meanwhile
    broadcaster_->enqueue(bench_.session.shownSnapshot());
    timer_.start(kOutputUpdate);
    showStatus();
  }
  updateAction();
  Q_EMIT changed();
}

void OutputController::close() {
  job_->abandon();
  const bool wasSending = std::exchange(broadcaster_, nullptr) != nullptr;
  timer_.stop();
  label_->hide();
  opened_ = {};
  updateAction();
  if (wasSending) {
    Q_EMIT changed();
  }
}

void OutputController::receive(const broadcast::RemoteCommand& command) {
  switch (command.action) {
  case broadcast::RemoteAction::Start:
    bench_.session.play();
    break;
  case broadcast::RemoteAction::Stop:
    if (bench_.session.isPlaying()) {
      bench_.session.togglePlay();
    }
    break;
  case broadcast::RemoteAction::StartRecording:
    Q_EMIT recordingRequested(QString::fromStdString(command.name));
    break;
  case broadcast::RemoteAction::StopRecording:
    if (QAction* record = bench_.action("actionRecord");
        record->isEnabled() && record->isChecked()) {
      record->trigger();
    }
    break;
  }
}

void OutputController::showStatus() {
  QStringList lines;
  int clients = 0;
  bool troubled = false;
  for (const broadcast::OutletReport& report : outletReports()) {
    clients += report.clientCount;
    const QString problem = outletProblem(report);
    troubled = troubled || !problem.isEmpty();
    lines += tr("%1: %2 sent, %3 dropped")
                 .arg(outletAddress(report))
                 .arg(report.sentPieceCount)
                 .arg(report.droppedPieceCount);
    if (!problem.isEmpty()) {
      lines += QStringLiteral("  ") + problem;
    }
  }
  label_->setText(
      (troubled ? QStringLiteral("▲ ") : QStringLiteral("◉ ")) +
      (clients > 0 ? tr("Sending, %n program(s) connected", nullptr, clients) : tr("Sending")));
  label_->setToolTip(lines.join(QLatin1Char('\n')));
  label_->show();
}

void OutputController::updateAction() {
  action_->setEnabled(bench_.session.isRunning() && !job_->isRunning());
  action_->setChecked(isSending());
}

} // namespace dewpoint::ui
