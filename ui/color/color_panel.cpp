// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/color/color_panel.h"

#include "core/color/color_histogram.h"
#include "core/project/project.h"
#include "ui/cameraview/camera_view.h"
#include "ui/cameraview/image_pick_overlay.h"
#include "ui/color/box_picker.h"
#include "ui/color/color_learner.h"
#include "ui/color/color_picker.h"
#include "ui/document/document.h"
#include "ui/style/theme.h"
#include "ui/text/retranslation.h"
#include "ui/text/verdict_text.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace dewpoint::ui {

namespace {

constexpr qint64 kSurveyMs = 1000;
constexpr int kJudgeMs = 200;                ///< after the last change
constexpr std::int64_t kOutlinedFrames = 10; ///< an outline stays so long over a running video

} // namespace

ColorPanel::ColorPanel(Document& document, QWidget* parent)
    : QWidget(parent), document_(document), teacher_(new ColorLearner(document, this)),
      boxes_(new BoxPicker(document, this)), name_(new QLabel(this)), learn_(new QToolButton(this)),
      picker_(new ColorPicker(this)), verdict_(new QLabel(this)), samplesTitle_(new QLabel(this)),
      samples_(new QListWidget(this)), remove_(new QPushButton(this)),
      judgeSoon_(new QTimer(this)) {
  setObjectName(QStringLiteral("colorPanel"));
  learn_->setObjectName(QStringLiteral("colorLearn"));
  learn_->setCheckable(true);
  learn_->setFocusPolicy(Qt::StrongFocus);
  verdict_->setObjectName(QStringLiteral("colorVerdict"));
  verdict_->setWordWrap(true);
  verdict_->setTextFormat(Qt::PlainText);
  verdict_->setAlignment(Qt::AlignTop);
  verdict_->setMinimumHeight(4 * fontMetrics().lineSpacing()); // the ring stays where it is
  samples_->setObjectName(QStringLiteral("colorSamples"));
  samples_->setMaximumHeight(96);
  remove_->setObjectName(QStringLiteral("colorRemoveSample"));
  QFont bold = name_->font();
  bold.setWeight(QFont::DemiBold);
  name_->setFont(bold);
  auto* head = new QHBoxLayout;
  head->setSpacing(8);
  head->addWidget(name_, 1);
  head->addWidget(learn_);
  auto* sampleHead = new QHBoxLayout;
  sampleHead->addWidget(samplesTitle_, 1);
  sampleHead->addWidget(remove_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 8);
  column->setSpacing(8);
  column->addLayout(head);
  column->addWidget(verdict_);
  column->addWidget(picker_, 1);
  column->addLayout(sampleHead);
  column->addWidget(samples_);
  connect(learn_, &QToolButton::toggled, this, &ColorPanel::setPicking);
  connect(picker_, &ColorPicker::rangeEdited, this, &ColorPanel::editRange);
  connect(picker_, &ColorPicker::editingFinished, this, [this] {
    document_.endMerging();
    teacher_->judge();
  });
  connect(remove_, &QPushButton::clicked, this, &ColorPanel::removeSample);
  connect(samples_, &QListWidget::currentRowChanged, this,
          [this](int row) { remove_->setEnabled(row >= 0); });
  auto* del = new QShortcut(QKeySequence::Delete, samples_);
  del->setContext(Qt::WidgetShortcut);
  connect(del, &QShortcut::activated, this, &ColorPanel::removeSample);
  connect(&document_, &Document::replaced, this, [this] {
    setTarget(0);
    say(); // its method may be of another kind
  });
  connect(&document_, &Document::targetsChanged, this, &ColorPanel::refresh);
  connect(&document_, &Document::methodChanged, this, &ColorPanel::say);
  connectTeacher();
  onRetranslate(this, [this] { say(); });
}

void ColorPanel::connectTeacher() {
  const auto adopt = [this](int target, bool isNew) {
    target_ = target;
    setPicking(false);
    refresh();
    Q_EMIT learned(target, isNew);
  };
  connect(teacher_, &ColorLearner::learned, this, adopt);
  connect(boxes_, &BoxPicker::learned, this, adopt);
  connect(boxes_, &BoxPicker::failed, this, &ColorPanel::failed);
  connect(teacher_, &ColorLearner::judged, this, &ColorPanel::showVerdict);
  judgeSoon_->setSingleShot(true);
  judgeSoon_->setInterval(kJudgeMs);
  connect(judgeSoon_, &QTimer::timeout, this, &ColorPanel::judgeNow);
  connect(teacher_, &ColorLearner::failed, this, &ColorPanel::failed);
  connect(teacher_, &ColorLearner::busyChanged, this, [this](bool busy) {
    if (busy && !judged_) {
      verdict_->setText(tr("Looking at the images…"));
    }
  });
}

void ColorPanel::say() {
  learn_->setText(takesBoxes() ? tr("Box") : tr("Learn"));
  learn_->setToolTip(
      takesBoxes()
          ? tr("Then click the thing in any camera image, or drag a box around it. Shift does the "
               "same without this button.")
          : tr("Then click the target in any camera image, or drag a box on it. "
               "Shift-click adds a sample, Alt-click or Ctrl+Shift-click excludes what is "
               "not the target."));
  samplesTitle_->setText(tr("Learned from"));
  samples_->setAccessibleName(tr("Samples the color was learned from"));
  samples_->setToolTip(
      tr("Shift-click in an image adds one, Alt-click or Ctrl+Shift-click excludes one"));
  remove_->setText(tr("Remove"));
  remove_->setToolTip(tr("Forget the chosen sample and learn from the rest (Del)"));
  refresh();
}

void ColorPanel::attach(int camera, CameraView* view) {
  auto* layer = new ImagePickOverlay(view);
  onRetranslate(layer, [layer, camera] {
    layer->setAccessibleName(
        tr("Image of camera %1: arrow keys move a cross, Enter points there").arg(camera + 1));
  });
  layers_.emplace_back(camera, layer);
  connect(layer, &QObject::destroyed, this, [this, layer] {
    std::erase_if(layers_, [layer](const auto& one) { return one.second == layer; });
  });
  connect(layer, &ImagePickOverlay::chosen, this, [this, camera] { Q_EMIT cameraChosen(camera); });
  connect(layer, &ImagePickOverlay::pointed, this,
          [this, camera](const QPointF& pixel) { Q_EMIT pointed(camera, pixel); });
  connect(layer, &ImagePickOverlay::cancelled, this, [this] { setPicking(false); });
  connect(layer, &ImagePickOverlay::picked, this,
          [this, camera](const QRectF& region, Qt::KeyboardModifiers modifiers) {
            pickedIn(camera, region, modifiers);
          });
  setPicking(picking_);
}

void ColorPanel::pickedIn(int camera, const QRectF& region, Qt::KeyboardModifiers modifiers) {
  if (takesBoxes()) {
    boxes_->setTarget(target_);
    boxes_->point(snapshot_, camera, region);
    return;
  }
  teacher_->setSnapshot(snapshot_);
  teacher_->setTarget(target_);
  // Many desktops keep Alt with the mouse for themselves: Ctrl+Shift does the same.
  const bool shift = modifiers.testFlag(Qt::ShiftModifier);
  const bool excludes =
      modifiers.testFlag(Qt::AltModifier) || (shift && modifiers.testFlag(Qt::ControlModifier));
  // Samples have whole pixels: a box that reaches to the edge begins with the first of them.
  const bool isBox = region.width() > 0.0 && region.height() > 0.0;
  const QRectF place =
      isBox ? QRectF(QPointF(std::max(0.0, region.left()), std::max(0.0, region.top())),
                     region.bottomRight())
            : region;
  teacher_->point(camera, place,
                  excludes ? ColorLearner::SampleAction::Exclude
                  : shift  ? ColorLearner::SampleAction::Add
                           : ColorLearner::SampleAction::Replace);
}

void ColorPanel::setPicking(bool picking) {
  if (picking_ != picking) {
    picking_ = picking;
    Q_EMIT pickingChanged(picking);
  }
  const QSignalBlocker quiet(learn_);
  learn_->setChecked(picking);
  const bool must = mustPoint();
  const QString hint = takesBoxes() ? tr("Click the thing or drag a box around it")
                       : must       ? tr("Click the thing to follow")
                                    : tr("Click the target");
  for (const auto& [camera, layer] : layers_) {
    layer->setPicking(picking || must);
    layer->setHint(hint);
  }
  if (picking && !layers_.empty()) {
    layers_.front().second->setFocus(Qt::ShortcutFocusReason); // the keys move its cross
  }
}

void ColorPanel::setTarget(int target) {
  target_ = target;
  judged_ = false;
  refresh();
}

void ColorPanel::refresh() {
  const auto& targets = document_.project().targets;
  const bool any = target_ >= 0 && target_ < static_cast<int>(targets.size());
  name_->setText(any               ? QString::fromStdString(targets[std::size_t(target_)].name)
                 : targets.empty() ? tr("No target yet")
                                   : tr("A new target"));
  picker_->setVisible(!takesBoxes());
  if (takesBoxes()) {
    showBox();
    return;
  }
  picker_->setEnabled(any);
  if (!any) {
    judged_ = false; // it was of a target that is no more
  } else {
    const Target& target = targets[static_cast<std::size_t>(target_)];
    if (!(target.color == picker_->range())) {
      judged_ = false;
    }
    picker_->setRange(target.color);
  }
  refreshSamples();
  if (judged_) {
    sayVerdict();
  } else {
    verdict_->setText(any ? tr("Drag ring and bars, or press Learn and click the target.")
                          : tr("Click the thing to follow in any camera image."));
    clearRegions();
    if (any) {
      judgeSoon_->start();
    }
  }
  setPicking(picking_);
}

void ColorPanel::clearRegions() {
  outlined_ = false;
  for (const auto& [camera, layer] : layers_) {
    layer->setRegions({});
  }
}

void ColorPanel::judgeNow() {
  if (inFront_ && snapshot_ && snapshot_->frames && !teacher_->isBusy() && !takesBoxes()) {
    teacher_->setTarget(target_);
    teacher_->judge();
  }
}

/// A verdict is about one moment: its outlines go when another one is shown, and it is made anew
/// where a person stays.
void ColorPanel::keepVerdictCurrent() {
  if (!snapshot_->frames || teacher_->isBusy() || takesBoxes()) {
    return;
  }
  const bool moved = std::abs(snapshot_->frame - judgedFrame_) > kOutlinedFrames;
  if (outlined_ && moved) {
    clearRegions();
  }
  const bool stays = snapshot_->state != PlayState::Playing && !snapshot_->preview &&
                     snapshot_->frame != judgedFrame_;
  if ((!judged_ || stays) && !judgeSoon_->isActive() && picker_->isEnabled()) {
    judgeSoon_->start();
  }
}

void ColorPanel::refreshSamples() {
  const auto& project = document_.project();
  const int row = samples_->currentRow();
  const QSignalBlocker quiet(samples_);
  samples_->clear();
  if (target_ >= 0 && target_ < static_cast<int>(project.targets.size())) {
    for (const ColorSample& sample : project.targets[static_cast<std::size_t>(target_)].samples) {
      const auto camera = static_cast<std::size_t>(sample.camera);
      const QString name = camera < project.cameras.size()
                               ? QString::fromStdString(project.cameras[camera].camera.name)
                               : QString::number(sample.camera + 1);
      const QString text =
          sample.excluded ? tr("not this: %1, frame %2, at %3, %4") : tr("%1, frame %2, at %3, %4");
      samples_->addItem(text.arg(name)
                            .arg(sample.frame + 1)
                            .arg(std::lround(sample.x + sample.width / 2.0))
                            .arg(std::lround(sample.y + sample.height / 2.0)));
    }
  }
  samples_->setCurrentRow(std::min(row, samples_->count() - 1));
  remove_->setEnabled(samples_->currentRow() >= 0);
  const bool some = samples_->count() > 0;
  samples_->setVisible(some);
  samplesTitle_->setVisible(some);
  remove_->setVisible(some);
}

void ColorPanel::removeSample() {
  teacher_->setSnapshot(snapshot_);
  teacher_->setTarget(target_);
  teacher_->removeSample(samples_->currentRow());
}

void ColorPanel::editRange(const ColorRange& range) {
  const auto index = static_cast<std::size_t>(target_);
  (void)document_.edit(
      tr("Change color range"), [&](Project& project) { project.targets.at(index).color = range; },
      "color of target " + std::to_string(target_));
}

void ColorPanel::setInFront(bool inFront) {
  inFront_ = inFront;
  if (!inFront) {
    clearRegions();
    judgedFrame_ = -1;
  } else if (snapshot_) {
    keepVerdictCurrent();
  }
}

void ColorPanel::sayVerdict() {
  std::vector<QString> cameras;
  for (const auto& camera : document_.project().cameras) {
    cameras.push_back(QString::fromStdString(camera.camera.name));
  }
  verdict_->setText(verdictText(said_, cameras));
}

void ColorPanel::showVerdict(const ColorVerdict& verdict) {
  if (!picker_->isEnabled()) {
    return; // its target has gone meanwhile
  }
  judged_ = true;
  judgedFrame_ = snapshot_ ? snapshot_->frame : -1;
  outlined_ = true;
  said_ = verdict;
  sayVerdict();
  for (const auto& [camera, layer] : layers_) {
    std::vector<ImagePickOverlay::Region> regions;
    for (const LookAlikeRegion& region : verdict.lookAlikes) {
      if (region.camera == camera) {
        QPolygonF outline;
        for (const cv::Point& point : region.outline) {
          outline << QPointF(point.x, point.y);
        }
        regions.push_back({outline, tr("matches too")});
      }
    }
    layer->setRegions(std::move(regions));
  }
}

void ColorPanel::setSnapshot(const TrackSnapshotPtr& snapshot) {
  snapshot_ = snapshot;
  teacher_->setSnapshot(snapshot);
  if (inFront_ && snapshot_) {
    keepVerdictCurrent();
  }
  if (isVisible() && (!sinceSurvey_.isValid() || sinceSurvey_.elapsed() > kSurveyMs)) {
    sinceSurvey_.start();
    surveyImages();
  }
}

void ColorPanel::surveyImages() {
  if (!snapshot_ || !snapshot_->frames) {
    return;
  }
  survey_.start([this, frames = snapshot_->frames](const BackgroundJob::Progress&) {
    std::vector<cv::Mat> images;
    for (const FramePtr& frame : frames->frames) {
      if (frame) {
        images.push_back(frame->image);
      }
    }
    auto histogram = std::make_shared<const ColorHistogram>(histogramOf(images));
    return [this, histogram] { picker_->setHistogram(*histogram); };
  });
}

} // namespace dewpoint::ui
