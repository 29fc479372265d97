// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/old_results_offer.h"

#include "core/project/project.h"
#include "ui/document/document.h"
#include "ui/session/logged_records.h"
#include "ui/session/result_refresher.h"
#include "ui/text/quantity_text.h"
#include "ui/widgets/message_bar.h"

#include <QAction>
#include <QMainWindow>

#include <algorithm>

namespace dewpoint::ui {

OldResultsOffer::OldResultsOffer(const Workbench& bench) : QObject(&bench.window), bench_(bench) {
  ResultRefresher* results = &bench_.session.resultRefresher();
  connect(results, &ResultRefresher::retrackOfferChanged, this, &OldResultsOffer::offer);
  const auto update = [this, results] {
    bench_.action("actionTrackAgain")->setEnabled(!results->oldResults().frameRanges.empty());
  };
  connect(results, &ResultRefresher::oldResultsChanged, this, update);
  bench_.onTriggered("actionTrackAgain", results, [results] { results->trackAgain(); });
  update();
  SessionController* session = &bench_.session;
  connect(session, &SessionController::startedAtLaterFrame, this,
          &OldResultsOffer::offerFirstFrame);
  connect(session, &SessionController::runAboutToRestart, this,
          &OldResultsOffer::withdrawFirstFrame);
  connect(session, &SessionController::runEnded, this, &OldResultsOffer::withdrawFirstFrame);
  connect(session, &SessionController::framesLogged, this, [this](const LoggedFrames& logged) {
    if (fills(logged)) {
      withdrawFirstFrame();
    }
  });
  connect(&bench_.document, &Document::targetsChanged, this, [this] {
    if (bench_.document.project().targets.empty()) {
      withdrawFirstFrame();
    }
  });
}

void OldResultsOffer::offerFirstFrame(qint64 started) {
  withdrawFirstFrame();
  started_ = started;
  late_ = tr("Tracking began at frame %1, where you clicked. The frames before it are not tracked.")
              .arg(frameNumberText(started));
  SessionController* session = &bench_.session;
  bench_.messages.showLastingQuestion(late_, {{tr("Track from the first frame"), [session] {
                                                 session->restart(false);
                                                 session->play();
                                               }}});
}

void OldResultsOffer::withdrawFirstFrame() {
  if (!late_.isEmpty()) {
    bench_.messages.withdrawQuestion(late_);
    late_.clear();
  }
}

bool OldResultsOffer::fills(const LoggedFrames& logged) const {
  return !late_.isEmpty() && std::ranges::any_of(logged.records, [this](const FrameRecord& record) {
    return record.frame < started_ && !record.targets.empty();
  });
}

void OldResultsOffer::offer(bool offers) {
  if (offers && !late_.isEmpty() && bench_.messages.isQuestionOpen(late_)) {
    return; // tracking from the first frame renews them, too
  }
  if (offers) {
    shown_ = tr("Some frames were tracked with earlier settings.");
    ResultRefresher* results = &bench_.session.resultRefresher();
    bench_.messages.showQuestion(shown_,
                                 {{tr("Track again"), [results] { results->trackAgain(); }}});
  } else if (!shown_.isEmpty() && bench_.messages.text() == shown_) {
    bench_.messages.dismiss();
  }
}

} // namespace dewpoint::ui
