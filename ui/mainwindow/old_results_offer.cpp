// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/old_results_offer.h"

#include "ui/session/result_refresher.h"
#include "ui/widgets/message_bar.h"

#include <QAction>
#include <QMainWindow>

namespace dewpoint::ui {

OldResultsOffer::OldResultsOffer(const Workbench& bench) : QObject(&bench.window), bench_(bench) {
  ResultRefresher* results = &bench_.session.results();
  connect(results, &ResultRefresher::offered, this, &OldResultsOffer::offer);
  const auto update = [this, results] {
    bench_.action("actionTrackAgain")->setEnabled(!results->oldResults().frames.empty());
  };
  connect(results, &ResultRefresher::oldResultsChanged, this, update);
  bench_.onTriggered("actionTrackAgain", results, [results] { results->trackAgain(); });
  update();
}

void OldResultsOffer::offer(bool offers) {
  if (offers) {
    shown_ = tr("Some frames were tracked with earlier settings.");
    ResultRefresher* results = &bench_.session.results();
    bench_.messages.ask(shown_, {{tr("Track again"), [results] { results->trackAgain(); }}});
  } else if (!shown_.isEmpty() && bench_.messages.text() == shown_) {
    bench_.messages.dismiss();
  }
}

} // namespace dewpoint::ui
