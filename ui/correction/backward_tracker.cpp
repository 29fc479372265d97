// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/correction/backward_tracker.h"

#include "core/base/thread_count.h"
#include "core/session/run/backward_track.h"
#include "core/session/session_inputs.h"
#include "core/session/snapshot/snapshot.h"
#include "ui/document/document.h"
#include "ui/preferences/preferences.h"
#include "ui/text/error_sentence.h"
#include "ui/text/quantity_text.h"
#include "ui/widgets/message_bar.h"

#include <algorithm>
#include <memory>

namespace dewpoint::ui {

namespace {

// Chosen.

constexpr qint64 kSilentMs = 1000; ///< until it is said that something is going on
constexpr qint64 kBetweenTextsMs = 500;

} // namespace

BackwardTracker::BackwardTracker(const Workbench& bench, QObject* parent)
    : QObject(parent), bench_(bench) {
  connect(&job_, &LatestJob::progressChanged, this, &BackwardTracker::showProgress);
  connect(&job_, &LatestJob::becameIdle, this, &BackwardTracker::clearProgress);
  connect(&bench_.session, &SessionController::runEnded, this, &BackwardTracker::cancel);
}

void BackwardTracker::cancel() {
  job_.cancel();
  clearProgress();
}

void BackwardTracker::start(const PositionCorrection& correction,
                            std::vector<TrajectorySample> believed, const std::string& mergeKey) {
  const TrackSnapshotPtr& shown = bench_.session.shownSnapshot();
  if (!shown || !shown->frameCount) {
    return; // live: what is past is not there to be read again
  }
  frame_ = correction.frame;
  sinceStart_.start();
  sinceShown_.invalidate();
  std::erase_if(believed, [&](const TrajectorySample& one) { return one.frame > frame_; });
  job_.start([this, open = bench_.session.opener(), project = bench_.document.project(), correction,
              mergeKey, believed = std::move(believed),
              threads = threadCountForFilter(Preferences().filterThreadCount())](
                 const BackgroundJob::Progress& progress) -> std::function<void()> {
    auto found = open(project).and_then([&](const SessionInputs& inputs) {
      return trackBackwards(*inputs.source,
                            {RunDefinition::fromProject(inputs.project, inputs.backgroundImages),
                             correction, believed},
                            threads, progress);
    });
    if (!found) {
      return [this, error = found.error()] { bench_.messages.showError(errorText(error)); };
    }
    return [this, correction, mergeKey, corrections = std::move(*found)] {
      storeCorrections(correction, corrections, mergeKey);
    };
  });
}

void BackwardTracker::storeCorrections(const PositionCorrection& from,
                                       const std::vector<PositionCorrection>& found,
                                       const std::string& mergeKey) {
  const auto& corrections = bench_.document.project().corrections;
  if (found.empty() || std::ranges::find(corrections, from) == corrections.end()) {
    return; // nothing was wrong, or it was taken back meanwhile
  }
  const auto edited = bench_.document.edit(
      tr("Correct position"),
      [&](Project& project) {
        for (const PositionCorrection& one : found) {
          addCorrection(project, one);
        }
      },
      mergeKey);
  if (!edited) {
    bench_.messages.showError(errorText(edited.error()));
    return;
  }
  clearProgress();
  bench_.messages.showNotice(tr("The target was tracked backward to frame %1. It is now being "
                                "tracked forward again from this frame.")
                                 .arg(frameNumberText(found.front().frame)));
}

void BackwardTracker::showProgress(double part) {
  const bool isDue = !sinceShown_.isValid() || sinceShown_.elapsed() > kBetweenTextsMs;
  if (sinceStart_.elapsed() < kSilentMs || !isDue || !job_.isRunning()) {
    return;
  }
  sinceShown_.start();
  const auto reached = static_cast<qint64>((1.0 - part) * static_cast<double>(frame_));
  shown_ = tr("Tracking the target backward: frame %1.").arg(frameNumberText(reached));
  bench_.messages.showQuestion(shown_, {{tr("Stop"), [this] { cancel(); }}});
}

void BackwardTracker::clearProgress() {
  if (!shown_.isEmpty() && bench_.messages.text() == shown_) {
    bench_.messages.dismiss();
  }
  shown_.clear();
}

} // namespace dewpoint::ui
