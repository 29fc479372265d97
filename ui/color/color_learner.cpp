// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/color/color_learner.h"

#include "core/color/color_learning.h"
#include "core/project/project.h"
#include "core/setup/clicks/click_learning.h"
#include "ui/color/fresh_target.h"
#include "ui/document/document.h"
#include "ui/text/error_sentence.h"

#include <algorithm>
#include <utility>

namespace dewpoint::ui {

ColorLearner::ColorLearner(Document& document, QObject* parent)
    : QObject(parent), document_(document) {
  connect(&learning_, &LatestJob::becameIdle, this, [this] { Q_EMIT busyChanged(false); });
}

std::vector<cv::Mat> ColorLearner::backgroundImages() const {
  return snapshot_ ? snapshot_->backgroundImages : std::vector<cv::Mat>{};
}

std::vector<cv::Mat> ColorLearner::images() const {
  std::vector<cv::Mat> images;
  if (snapshot_ && snapshot_->frames) {
    for (const FramePtr& frame : snapshot_->frames->frames) {
      images.push_back(frame ? frame->image : cv::Mat());
    }
  }
  return images;
}

void ColorLearner::start(Work work) {
  learning_.start([work = std::move(work)](const BackgroundJob::Progress&) { return work(); });
  Q_EMIT busyChanged(true);
}

/// A project and the images shown, by which clicks are explained.
struct ColorLearner::Scene {
  Project project;
  int target = -1;
  setup::ClickedImages shown;

  Result<setup::ClickLearningResult> learn(const std::vector<ColorSample>& samples) const {
    return setup::learnFromClicks(project, target, shown, samples);
  }
};

ColorLearner::Scene ColorLearner::scene() const {
  return {document_.project(),
          target_,
          {images(), backgroundImages(), snapshot_ ? snapshot_->frame : 0}};
}

void ColorLearner::learnFrom(int camera, const QRectF& region, SampleAction action) {
  const auto shown = images();
  const auto index = static_cast<std::size_t>(camera);
  if (index >= shown.size() || shown[index].empty()) {
    Q_EMIT failed(tr("No color can be learned here, because this camera shows no image."));
    return;
  }
  const Project& project = document_.project();
  const bool isNew = target_ < 0 || target_ >= static_cast<int>(project.targets.size());
  std::vector<ColorSample> samples;
  if (!isNew && action != SampleAction::Replace) {
    samples = project.targets[static_cast<std::size_t>(target_)].samples;
  }
  if (action == SampleAction::Exclude && samples.empty()) {
    Q_EMIT failed(tr("Click the target first. Then exclude colors of other objects."));
    return;
  }
  const int target = isNew ? -1 : target_;
  const std::int64_t frame = snapshot_->frame;
  const QString step = action == SampleAction::Exclude ? tr("Exclude color")
                       : action == SampleAction::Add   ? tr("Add color sample")
                                                       : tr("Learn color");
  start([this, scene = scene(), camera, frame, region, action, samples, target, step,
         index]() mutable -> std::function<void()> {
    ColorSample place;
    place.isExcluded = action == SampleAction::Exclude;
    place.camera = camera;
    place.frame = frame;
    place.x = region.x();
    place.y = region.y();
    place.width = region.width();
    place.height = region.height();
    auto sample = takeSample(scene.shown.images[index], place);
    if (!sample) {
      return [this, error = sample.error()] { Q_EMIT failed(errorText(error)); };
    }
    samples.push_back(std::move(*sample));
    const auto result = scene.learn(samples);
    if (!result) {
      return [this, error = result.error()] { Q_EMIT failed(errorText(error)); };
    }
    return [this, target, result = *result, step] { applyResult(target, result, step); };
  });
}

void ColorLearner::removeSample(int index) {
  const Project& project = document_.project();
  if (target_ < 0 || target_ >= static_cast<int>(project.targets.size())) {
    return;
  }
  const auto& all = project.targets[static_cast<std::size_t>(target_)].samples;
  if (index < 0 || index >= static_cast<int>(all.size())) {
    return;
  }
  const auto samples = setup::withoutSample(all, static_cast<std::size_t>(index));
  const int target = target_;
  const QString step = tr("Remove color sample");
  if (!setup::hasClickedSample(samples)) {
    setup::ClickLearningResult same;
    const Target& taught = project.targets[static_cast<std::size_t>(target)];
    same.color.range = taught.color;
    same.color.otherRanges = taught.otherColors;
    same.color.assessment.isTargetKnown = false;
    applyResult(target, same, step);
    return;
  }
  start([this, samples, target, step, scene = scene()]() -> std::function<void()> {
    const auto result = scene.learn(samples);
    if (!result) {
      return [this, error = result.error()] { Q_EMIT failed(errorText(error)); };
    }
    return [this, target, result = *result, step] { applyResult(target, result, step); };
  });
}

void ColorLearner::applyResult(int target, const setup::ClickLearningResult& result,
                               const QString& step) {
  int learnedTarget = target;
  const auto edited = document_.edit(step, [&](Project& project) {
    if (target < 0 || target >= static_cast<int>(project.targets.size())) {
      Target added;
      added.name = newTargetName(project);
      project.targets.push_back(added);
      learnedTarget = static_cast<int>(project.targets.size()) - 1;
    }
    setup::applyLearningResult(result, static_cast<std::size_t>(learnedTarget), project);
  });
  if (!edited) {
    Q_EMIT failed(errorText(edited.error()));
    return;
  }
  setTarget(learnedTarget);
  Q_EMIT colorLearned(learnedTarget, learnedTarget != target);
  Q_EMIT learningResultReady(result);
  if (result.color.assessment.isTargetKnown) {
    Q_EMIT colorAssessed(result.color.assessment);
  } else {
    assessLearnedColor();
  }
}

void ColorLearner::assessLearnedColor() {
  const Project& project = document_.project();
  if (target_ < 0 || target_ >= static_cast<int>(project.targets.size())) {
    return;
  }
  const Target target = project.targets[static_cast<std::size_t>(target_)];
  start([this, target, shown = images(), rooms = backgroundImages()]() -> std::function<void()> {
    const ColorAssessment assessment =
        assessColorWithBackground(target.colors(), target.samples, shown, rooms);
    return [this, assessment] { Q_EMIT colorAssessed(assessment); };
  });
}

} // namespace dewpoint::ui
