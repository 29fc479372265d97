// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/track/run_notes.h"

#include "core/camera_motion/agreement/disagreement_sentence.h"
#include "core/session/run/tracking_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace dewpoint::app {

void RunNotes::print(std::string text) {
  fmt::print(stderr, "dewpoint-cli: note: {}.\n", text);
  printed_.push_back(std::move(text));
}

void RunNotes::printNotices() {
  for (const Error& notice : source_.notices()) {
    std::string text = errorSentence(notice);
    if (std::ranges::find(printed_, text) == printed_.end()) {
      print(std::move(text));
    }
  }
}

Status RunNotes::onFrameTracked(const TrackingRun& run) {
  const auto watched = motionObserver_.onFrameTracked(run).and_then(
      [&] { return agreementWatch_.onFrameTracked(run); });
  if (!watched) {
    return watched;
  }
  if (printedMotions_ != motionWatch_.reports().size()) {
    const auto notices = motionWatch_.notices();
    for (; printedMotions_ < notices.size(); ++printedMotions_) {
      print(errorSentence(notices[printedMotions_]));
    }
  }
  for (CameraDisagreement& found : agreementWatch_.disagreements(run.definition()->family())) {
    if (std::ranges::none_of(printedDisagreements_,
                             [&](const auto& one) { return one.isSameAs(found); })) {
      print(describeDisagreement(found, run.rig()));
      printedDisagreements_.push_back(std::move(found));
    }
  }
  return {};
}

} // namespace dewpoint::app
