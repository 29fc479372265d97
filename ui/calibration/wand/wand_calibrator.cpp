// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/wand/wand_calibrator.h"

#include "core/base/text_file.h"
#include "core/setup/calibration/calibrated_project.h"
#include "ui/calibration/manual_calibration.h"
#include "ui/document/document.h"
#include "ui/jobs/background_job.h"
#include "ui/text/error_sentence.h"

#include <algorithm>
#include <thread>

namespace dewpoint::ui {
namespace {

constexpr int kTickMs = 200;
constexpr double kLookingPart = 0.8; ///< of the time that a refinement takes, roughly

/// How far the whole is.
double partOf(const WandCalibrationProgress& work) {
  if (work.totalStepCount <= 0) {
    return -1.0;
  }
  const double part =
      static_cast<double>(work.doneStepCount) / static_cast<double>(work.totalStepCount);
  return work.isSearching ? kLookingPart * part : kLookingPart + (1.0 - kLookingPart) * part;
}

/// Everything that was collected, also what still waits to be looked at.
std::vector<std::vector<MarkerObservation>> allViews(const WandCollector& collector,
                                                     const BackgroundJob::Progress& progress) {
  while (collector.state().waitingFrameSetCount > 0 && progress(-1.0)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return collector.views();
}

} // namespace

WandCalibrator::WandCalibrator(Dependencies around, QObject* parent)
    : QObject(parent), dependencies_(std::move(around)), job_(new BackgroundJob(this)) {
  tick_.setInterval(kTickMs);
  connect(&tick_, &QTimer::timeout, this, &WandCalibrator::collectorStateChanged);
  connect(job_, &BackgroundJob::started, this, &WandCalibrator::changed);
  connect(job_, &BackgroundJob::progressChanged, this, &WandCalibrator::progressChanged);
  connect(job_, &BackgroundJob::ended, this, &WandCalibrator::changed);
  connect(&dependencies_.document, &Document::projectReplaced, this,
          &WandCalibrator::discardResults);
  connect(&dependencies_.document, &Document::targetsChanged, this, &WandCalibrator::changed);
  connect(&dependencies_.selection, &Selection::selectedRangeChanged, this,
          &WandCalibrator::changed);
  connect(&dependencies_.document, &Document::calibrationChanged, this, [this] {
    if (refinement_ && applied_) {
      Q_EMIT changed();
    }
  });
}

WandCalibrator::~WandCalibrator() {
  stopCollectingViews();
}

bool WandCalibrator::isStale() const {
  return refinement_ && applied_ &&
         !std::ranges::equal(project().cameras, refinement_->result.cameras, {},
                             &ProjectCamera::camera);
}

const Project& WandCalibrator::project() const {
  return dependencies_.document.project();
}

void WandCalibrator::setSettings(const WandSettings& settings) {
  if (!(settings == settings_)) {
    settings_ = settings;
    Q_EMIT changed();
  }
}

void WandCalibrator::markInstant(WandEvent role) {
  if (!canMarkInstant()) {
    return;
  }
  const MarkedInstant taken{shownFrame_, shownSeconds_, role};
  addInstant(markedInstants_, taken);
  Q_EMIT changed();
}

void WandCalibrator::removeMarkedInstant(std::size_t index) {
  if (index < markedInstants_.size()) {
    markedInstants_.erase(markedInstants_.begin() + static_cast<std::ptrdiff_t>(index));
    Q_EMIT changed();
  }
}

void WandCalibrator::showMarkedInstant(std::size_t index) {
  if (index < markedInstants_.size()) {
    dependencies_.selection.requestFrame(markedInstants_[index].frame);
  }
}

void WandCalibrator::setSnapshot(const TrackSnapshotPtr& snapshot) {
  const bool shown = snapshot && snapshot->frames;
  const bool live = shown && !snapshot->frameCount;
  // Another session opens its cameras anew, and has no tap.
  if (waving_ != nullptr && (dependencies_.session() != waving_ || collector_.use_count() == 1)) {
    detachFromSession();
  }
  const bool news = live != live_ || shown != canMarkInstant();
  live_ = live;
  shownFrame_ = shown ? snapshot->frames->index : -1;
  shownSeconds_ = shown ? seconds(snapshot->frames->time) : 0.0;
  if (news) {
    Q_EMIT changed();
  }
}

void WandCalibrator::startCollectingViews() {
  Session* session = dependencies_.session();
  const auto colors =
      wandColorClassifiers(project(), toWandOptions(settings_, markedInstants_, project()));
  if (session == nullptr) {
    return;
  }
  if (!colors) {
    Q_EMIT failed(errorText(colors.error()));
    return;
  }
  stopCollectingViews();
  markedInstants_.clear(); // they belong to what was collected before
  collector_.reset(new WandCollector(project().cameras.size(), *colors), DetachedDeleter());
  waving_ = session;
  session->setFrameTap(
      [collector = collector_](const FrameSetPtr& frames) { collector->offer(frames); });
  session->returnToNewestFrame();
  session->play();
  tick_.start();
  Q_EMIT changed();
}

void WandCalibrator::stopCollectingViews() {
  if (waving_ != nullptr && dependencies_.session() == waving_) {
    waving_->setFrameTap({});
  }
  detachFromSession();
}

void WandCalibrator::detachFromSession() {
  if (waving_ != nullptr) {
    waving_ = nullptr;
    tick_.stop();
    Q_EMIT collectorStateChanged();
    Q_EMIT changed();
  }
}

std::optional<WandCollector::State> WandCalibrator::collectorState() const {
  return collector_ ? std::optional(collector_->state()) : std::nullopt;
}

QString WandCalibrator::reasonNotToRefine() const {
  const QString missing = validationMessage(settings_, markedInstants_, project());
  if (!missing.isEmpty()) {
    return missing;
  }
  if (live_ && collector_ == nullptr) {
    return tr("Press “Start waving”, then wave for half a minute in the volume in which you want "
              "to track.");
  }
  return {};
}

bool WandCalibrator::isRefining() const {
  return job_->isRunning();
}

void WandCalibrator::refine() {
  if (isRefining() || !reasonNotToRefine().isEmpty()) {
    return;
  }
  stopCollectingViews();
  const auto collector = live_ ? collector_ : nullptr;
  const auto selectedRange = live_ ? std::nullopt : dependencies_.selection.selectedRange();
  const auto selected = selectedRange
                            ? std::optional(FrameSpan{selectedRange->first, selectedRange->last})
                            : std::nullopt;
  const WandOptions options = toWandOptions(settings_, markedInstants_, project(), selected);
  refinement_.reset();
  failure_.clear();
  applied_ = false;
  job_->start([this, collector, options, wanted = project(),
               open = dependencies_.open](const BackgroundJob::Progress& progress) {
    const auto callback = [&](const WandCalibrationProgress& work) {
      return progress(partOf(work));
    };
    auto outcome = std::make_shared<Result<WandRefinement>>();
    if (collector) {
      *outcome = refineFromViews(wanted, allViews(*collector, progress), options, callback);
    } else if (auto inputs = open(SessionRequest(wanted))) {
      *outcome = refineFromRecording(inputs->project, *inputs->source, options, callback);
    } else {
      *outcome = tl::make_unexpected(inputs.error());
    }
    return [this, outcome] { applyResult(std::move(*outcome)); };
  });
}

void WandCalibrator::cancel() {
  job_->cancel();
}

void WandCalibrator::applyResult(Result<WandRefinement> outcome) {
  if (!outcome) {
    failure_ = errorText(outcome.error());
  } else {
    refinement_ = std::make_shared<const WandRefinement>(std::move(*outcome));
    if (!isDoubtful(*refinement_)) {
      apply();
    }
  }
  Q_EMIT refinementEnded();
}

void WandCalibrator::apply() {
  if (!refinement_ || applied_ || refinement_->camerasBefore.size() != project().cameras.size()) {
    return;
  }
  dependencies_.manual.storeEarlierCameras(EarlierCameras::WandRefinement);
  const auto edited = dependencies_.document.edit(
      settings_.usesStick ? tr("Refine cameras with a wand") : tr("Refine cameras with a ball"),
      [this](Project& project) { project = withRefinement(std::move(project), *refinement_); });
  applied_ = edited.has_value();
  failure_ = edited ? QString() : errorText(edited.error());
  Q_EMIT changed();
}

void WandCalibrator::setBeforeRefinementShown(bool shown) {
  dependencies_.manual.showEarlierCameras(shown ? std::optional(EarlierCameras::WandRefinement)
                                                : std::nullopt);
}

void WandCalibrator::saveReport(const QString& file) {
  if (!refinement_) {
    return;
  }
  job_->start([this, file, refinement = refinement_](const BackgroundJob::Progress&) {
    const auto written = writeTextFile(file.toStdString(), htmlText(*refinement));
    return [this, file, written] {
      written ? Q_EMIT saved(file) : Q_EMIT failed(errorText(written.error()));
    };
  });
}

void WandCalibrator::discardResults() {
  job_->cancel();
  stopCollectingViews();
  collector_.reset();
  markedInstants_.clear();
  settings_ = {};
  refinement_.reset();
  failure_.clear();
  applied_ = false;
  shownFrame_ = -1;
  Q_EMIT changed();
}

} // namespace dewpoint::ui
