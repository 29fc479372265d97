// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/color/color_panel.h"

#include "core/project/project.h"
#include "core/setup/clicks/target_color.h"
#include "core/tracking/catalog/method_catalog.h"
#include "ui/cameraview/image_pick_tool.h"
#include "ui/color/assessed_regions.h"
#include "ui/color/box_picker.h"
#include "ui/color/color_choice.h"
#include "ui/color/color_picker.h"
#include "ui/color/color_sample_list.h"
#include "ui/color/follow_all_button.h"
#include "ui/color/image_histogram_job.h"
#include "ui/color/learn_modes.h"
#include "ui/document/document.h"
#include "ui/document/method_presentation.h"
#include "ui/style/type_scale.h"
#include "ui/text/camera_names.h"
#include "ui/text/click_radius_text.h"
#include "ui/text/color_assessment_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/retranslation.h"

#include <QLabel>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::ui {

namespace {

constexpr int kAssessMs = 200;               ///< after the last change
constexpr std::int64_t kOutlinedFrames = 10; ///< an outline stays so long over a running video

} // namespace

ColorPanel::ColorPanel(Document& document, ImagePickTool& pick, QWidget* parent)
    : QWidget(parent), document_(document), pick_(pick), learner_(new ColorLearner(document, this)),
      boxes_(new BoxPicker(document, this)), name_(new QLabel(this)), modes_(new LearnModes(this)),
      choice_(new ColorChoice(this)), picker_(new ColorPicker(this)),
      assessmentText_(new QLabel(this)), followAll_(new FollowAllButton(document, this)),
      samples_(new ColorSampleList(this)), assessSoon_(new QTimer(this)),
      survey_(new ImageHistogramJob(this)) {
  setObjectName(QStringLiteral("colorPanel"));
  assessmentText_->setObjectName(QStringLiteral("colorAssessment"));
  assessmentText_->setWordWrap(true);
  assessmentText_->setTextFormat(Qt::PlainText);
  assessmentText_->setAlignment(Qt::AlignTop);
  assessmentText_->setMinimumHeight(4 * fontMetrics().lineSpacing()); // the ring stays where it is
  name_->setFont(mediumFont(name_->font()));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 8);
  column->setSpacing(8);
  column->addWidget(name_);
  column->addWidget(modes_);
  column->addWidget(assessmentText_);
  column->addWidget(followAll_, 0, Qt::AlignLeft);
  column->addWidget(choice_);
  column->addWidget(picker_, 1);
  column->addWidget(samples_);
  connect(modes_, &LearnModes::modeChosen, this, [this](LearnModes::Mode mode) {
    mode_ = mode.value_or(ColorLearner::SampleAction::Replace);
    setPicking(mode.has_value());
  });
  connect(choice_, &ColorChoice::selectedColorChanged, this, &ColorPanel::refresh);
  connect(choice_, &ColorChoice::removeRequested, this, &ColorPanel::removeColor);
  connect(picker_, &ColorPicker::rangeEdited, this, &ColorPanel::editRange);
  connect(picker_, &ColorPicker::editingFinished, this, [this] {
    document_.endStepMerging();
    learner_->assessLearnedColor();
  });
  connect(survey_, &ImageHistogramJob::finished, picker_, &ColorPicker::setHistogram);
  connect(samples_, &ColorSampleList::removeRequested, this, &ColorPanel::removeSample);
  connect(&pick_, &ImagePickTool::viewAttached, this, [this] { setPicking(picking_); });
  connect(&pick_, &ImagePickTool::canceled, this, [this] { setPicking(false); });
  connect(&pick_, &ImagePickTool::picked, this, &ColorPanel::handlePick);
  connect(&document_, &Document::projectReplaced, this, [this] {
    setTarget(0);
    retranslateUi(); // its method may be of another kind
  });
  connect(&document_, &Document::targetsChanged, this, &ColorPanel::refresh);
  connect(&document_, &Document::methodChanged, this, &ColorPanel::retranslateUi);
  connectLearner();
  onRetranslate(this, [this] { retranslateUi(); });
}

void ColorPanel::connectLearner() {
  const auto showLearned = [this](int target, bool isNew) {
    target_ = target;
    if (mode_ == ColorLearner::SampleAction::Replace) { // samples come in numbers
      setPicking(false);
    }
    refresh();
    Q_EMIT colorLearned(target, isNew);
  };
  connect(learner_, &ColorLearner::colorLearned, this, showLearned);
  connect(boxes_, &BoxPicker::boxDefined, this, showLearned);
  connect(boxes_, &BoxPicker::failed, this, &ColorPanel::failed);
  connect(learner_, &ColorLearner::learningResultReady, this,
          [this](const setup::ClickLearningResult& result) {
            found_ = result.outlines;
            shownRadius_ = result.radius;
            isPart_ = result.part.has_value();
          });
  connect(learner_, &ColorLearner::colorAssessed, this, &ColorPanel::showAssessment);
  assessSoon_->setSingleShot(true);
  assessSoon_->setInterval(kAssessMs);
  connect(assessSoon_, &QTimer::timeout, this, &ColorPanel::assessNow);
  connect(learner_, &ColorLearner::failed, this, &ColorPanel::failed);
  connect(learner_, &ColorLearner::busyChanged, this, [this](bool busy) {
    if (busy && !assessed_) {
      assessmentText_->setText(tr("Analyzing images…"));
    }
  });
}

void ColorPanel::retranslateUi() {
  modes_->setTargetsAreBoxes(targetsAreBoxes());
  samples_->retranslateUi();
  choice_->retranslateUi();
  refresh();
}

ColorLearner::SampleAction ColorPanel::actionOf(Qt::KeyboardModifiers modifiers) const {
  // Many desktops keep Alt with the mouse for themselves: Ctrl+Shift does the same.
  const bool shift = modifiers.testFlag(Qt::ShiftModifier);
  if (modifiers.testFlag(Qt::AltModifier) || (shift && modifiers.testFlag(Qt::ControlModifier))) {
    return ColorLearner::SampleAction::Exclude;
  }
  return shift ? ColorLearner::SampleAction::Add : mode_;
}

void ColorPanel::handlePick(int camera, const QRectF& region, Qt::KeyboardModifiers modifiers) {
  if (targetsAreBoxes()) {
    boxes_->setTarget(target_);
    boxes_->pick(snapshot_, camera, region);
    return;
  }
  learner_->setSnapshot(snapshot_);
  learner_->setTarget(target_);
  // Samples have whole pixels: a box that reaches to the edge begins with the first of them.
  const bool isBox = region.width() > 0.0 && region.height() > 0.0;
  const QRectF place =
      isBox ? QRectF(QPointF(std::max(0.0, region.left()), std::max(0.0, region.top())),
                     region.bottomRight())
            : region;
  learner_->learnFrom(camera, place, actionOf(modifiers));
}

void ColorPanel::setPicking(bool picking) {
  const bool isOther = std::exchange(picking_, picking) != picking;
  const bool isAdding = clickAddsTarget();
  if (std::exchange(wasAdding_, isAdding) != isAdding || isOther) {
    Q_EMIT pickingChanged();
  }
  if (!picking || !modes_->offersMode(mode_)) {
    mode_ = ColorLearner::SampleAction::Replace;
  }
  modes_->setMode(picking ? LearnModes::Mode(mode_) : LearnModes::Mode());
  pick_.setPicking(picking || (expectsClick() && !clicksTaken_), hint());
  if (picking) {
    pick_.takeFocus();
  }
}

void ColorPanel::setClicksUsedElsewhere(bool taken) {
  if (clicksTaken_ != taken) {
    clicksTaken_ = taken;
    setPicking(picking_);
  }
}

QString ColorPanel::hint() const {
  if (targetsAreBoxes()) {
    return tr("Click the object or drag a box around it");
  }
  return picking_ && !expectsClick() ? modes_->hintOf(mode_) : tr("Click the object to track");
}

void ColorPanel::setTarget(int target) {
  target_ = target;
  shownRadius_.reset();
  isPart_ = false;
  assessed_ = false;
  refresh();
}

bool ColorPanel::hasTarget() const {
  return target_ >= 0 && target_ < static_cast<int>(document_.project().targets.size());
}

bool ColorPanel::clickAddsTarget() const {
  return target_ < 0 && !document_.project().targets.empty();
}

void ColorPanel::refresh() {
  const auto& targets = document_.project().targets;
  const bool any = hasTarget();
  name_->setText(any               ? QString::fromStdString(targets[std::size_t(target_)].name)
                 : targets.empty() ? tr("No target yet")
                                   : tr("A new target"));
  picker_->setVisible(!targetsAreBoxes());
  if (targetsAreBoxes()) {
    choice_->setColors({});
    showBox();
    return;
  }
  picker_->setEnabled(any);
  if (!any) {
    assessed_ = false; // it was of a target that is no more
    choice_->setColors({});
  } else {
    const Target& target = targets[static_cast<std::size_t>(target_)];
    if (!(target.colors() == colors_)) {
      colors_ = target.colors();
      assessed_ = false;
    }
    choice_->setColors(colors_);
    picker_->setRange(colors_[static_cast<std::size_t>(choice_->selectedColor())]);
  }
  samples_->setSamples(document_.project(), target_);
  modes_->setRefinementEnabled(any,
                               any && !targets[static_cast<std::size_t>(target_)].samples.empty());
  followAll_->offer(assessed_ ? &assessment_ : nullptr, target_);
  if (assessed_) {
    updateAssessment();
  } else {
    assessmentText_->setText(any ? tr("To set the target's color, drag the ring and the bars, or "
                                      "press Learn and click the target.")
                                 : tr("Click the object to track in any camera image."));
    clearRegions();
    if (any) {
      assessSoon_->start();
    }
  }
  setPicking(picking_);
}

void ColorPanel::clearRegions() {
  outlined_ = false;
  found_.clear();
  pick_.clearRegions();
}

void ColorPanel::assessNow() {
  if (inFront_ && snapshot_ && snapshot_->frames && !learner_->isBusy() && !targetsAreBoxes()) {
    learner_->setTarget(target_);
    learner_->assessLearnedColor();
  }
}

/// An assessment is about one frame: its outlines go when another one is shown, and where playback
/// stops, the color is assessed again.
void ColorPanel::keepAssessmentCurrent() {
  if (!snapshot_->frames || learner_->isBusy() || targetsAreBoxes()) {
    return;
  }
  const bool moved = std::abs(snapshot_->frame - assessedFrame_) > kOutlinedFrames;
  if (outlined_ && moved) {
    clearRegions();
  }
  const bool stays = snapshot_->state != PlayState::Playing && !snapshot_->isPreview &&
                     snapshot_->frame != assessedFrame_;
  if ((!assessed_ || stays) && !assessSoon_->isActive() && picker_->isEnabled()) {
    assessSoon_->start();
  }
}

void ColorPanel::removeSample(int sample) {
  learner_->setSnapshot(snapshot_);
  learner_->setTarget(target_);
  learner_->removeSample(sample);
}

void ColorPanel::editRange(const ColorRange& range) {
  const auto index = static_cast<std::size_t>(target_);
  const auto color = static_cast<std::size_t>(choice_->selectedColor());
  (void)document_.edit(
      tr("Change color range"),
      [&](Project& project) { setup::setColor(color, range, project.targets.at(index)); },
      "color " + std::to_string(color) + " of target " + std::to_string(target_));
}

void ColorPanel::removeColor(int color) {
  (void)document_.edit(tr("Remove color"), [&](Project& project) {
    setup::removeColor(static_cast<std::size_t>(color),
                       project.targets.at(static_cast<std::size_t>(target_)));
  });
}

void ColorPanel::setPanelVisible(bool visible) {
  inFront_ = visible;
  if (!visible) {
    clearRegions();
    assessedFrame_ = -1;
  } else if (snapshot_) {
    keepAssessmentCurrent();
  }
}

void ColorPanel::updateAssessment() {
  std::vector<QString> cameras;
  for (const auto& camera : document_.project().cameras) {
    cameras.push_back(cameraName(camera.camera.name, cameras.size()));
  }
  ColorAssessment shown = assessment_;
  if (shown.suggestion == ColorSuggestion::FollowAll && !followAll_->isOffering()) {
    shown.suggestion = ColorSuggestion::None; // each has its target
  }
  QString text = colorAssessmentText(shown, cameras);
  if (hasTarget()) {
    const double given = document_.project().targets[static_cast<std::size_t>(target_)].radius;
    const QString radius = isPart_ ? markedPartText(given) : clickRadiusText(given, shownRadius_);
    text += radius.isEmpty() ? QString() : QLatin1Char('\n') + radius;
  }
  assessmentText_->setText(text);
}

void ColorPanel::showAssessment(const ColorAssessment& assessment) {
  if (!picker_->isEnabled()) {
    return; // its target has gone meanwhile
  }
  assessed_ = true;
  assessedFrame_ = snapshot_ ? snapshot_->frame : -1;
  outlined_ = true;
  assessment_ = assessment;
  followAll_->offer(&assessment_, target_);
  updateAssessment();
  pick_.clearRegions();
  for (const auto& [camera, all] : assessedRegions(assessment, found_)) {
    pick_.setRegions(camera, all);
  }
}

void ColorPanel::setSnapshot(const TrackSnapshotPtr& snapshot) {
  snapshot_ = snapshot;
  learner_->setSnapshot(snapshot);
  if (inFront_ && snapshot_) {
    keepAssessmentCurrent();
  }
  if (isVisible()) {
    survey_->start(snapshot_);
  }
}

bool ColorPanel::targetsAreBoxes() const {
  return document_.methodPresentation().targetsAreBoxes;
}

bool ColorPanel::expectsClick() const {
  return document_.methodFamily().lacksTargets(document_.project().targets);
}

/// Methods for boxes learn all they need from one.
void ColorPanel::showBox() {
  const Project& project = document_.project();
  const auto index = static_cast<std::size_t>(std::max(0, target_));
  const bool has = target_ >= 0 && index < project.targets.size() && project.targets[index].box;
  assessed_ = false;
  picker_->setEnabled(false);
  samples_->hide();
  clearRegions();
  if (has) {
    const TargetBox& box = *project.targets[index].box;
    const auto camera = static_cast<std::size_t>(box.camera);
    assessmentText_->setText(
        tr("The target is tracked from its box in frame %2 of %1 (%3 × %4 pixels). This method "
           "needs no color. To set another box, press Box and click the object.")
            .arg(cameraName(camera < project.cameras.size() ? project.cameras[camera].camera.name
                                                            : std::string(),
                            camera))
            .arg(frameNumberText(box.frame))
            .arg(numberText(box.box.width, 0))
            .arg(pixelText(box.box.height, 0)));
  } else {
    assessmentText_->setText(tr("Click the object or drag a box around it in any camera view."));
  }
  setPicking(picking_);
}

} // namespace dewpoint::ui
