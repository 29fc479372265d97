// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/track/run_notes.h"

#include "core/camera_motion/agreement/disagreement_sentence.h"
#include "core/session/run/tracking_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace dewpoint::app {

void RunNotes::say(std::string text) {
  fmt::print(stderr, "dewpoint-cli: note: {}.\n", text);
  said_.push_back(std::move(text));
}

void RunNotes::takeNotices() {
  for (const Error& notice : source_.notices()) {
    std::string text = sentence(notice);
    if (std::ranges::find(said_, text) == said_.end()) {
      say(std::move(text));
    }
  }
}

Status RunNotes::tracked(const TrackingRun& run) {
  const auto watched =
      motionObserver_.tracked(run).and_then([&] { return agreementWatch_.tracked(run); });
  if (!watched) {
    return watched;
  }
  if (motionsSaid_ != motionWatch_.reports().size()) {
    const auto notices = motionWatch_.notices();
    for (; motionsSaid_ < notices.size(); ++motionsSaid_) {
      say(sentence(notices[motionsSaid_]));
    }
  }
  for (CameraDisagreement& found : agreementWatch_.found(run.definition()->family())) {
    if (std::ranges::none_of(disagreementsSaid_,
                             [&](const auto& one) { return one.isSameAs(found); })) {
      say(disagreementSentence(found, run.rig()));
      disagreementsSaid_.push_back(std::move(found));
    }
  }
  return {};
}

} // namespace dewpoint::app
