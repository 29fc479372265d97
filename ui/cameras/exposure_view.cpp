// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameras/exposure_view.h"

#include "ui/cameras/exposure_bars.h"
#include "ui/document/camera_list_model.h"
#include "ui/style/spacing.h"
#include "ui/text/quantity_text.h"
#include "ui/text/retranslation.h"

#include <QLabel>
#include <QVBoxLayout>

#include <memory>
#include <utility>

namespace dewpoint::ui {

namespace {

/// How long a measurement stays while the camera has no image in the frames shown. Chosen: cameras
/// that are not synchronized miss some of them.
constexpr qint64 kStaysMs = 1000;

bool hasMeasurableTargets(const TrackSnapshotPtr& snapshot) {
  return snapshot && snapshot->frames && !snapshot->targets.empty() &&
         !snapshot->family.findsTargets();
}

} // namespace

ExposureView::ExposureView(const CameraListModel& cameras, QWidget* parent)
    : QWidget(parent), cameras_(cameras), title_(new QLabel(this)), bars_(new ExposureBars(this)),
      shares_(new QLabel(this)), sentences_(new QLabel(this)) {
  setObjectName(QStringLiteral("exposureView"));
  title_->setObjectName(QStringLiteral("exposureTitle"));
  shares_->setObjectName(QStringLiteral("exposureShares"));
  sentences_->setObjectName(QStringLiteral("exposureSentences"));
  sentences_->setWordWrap(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kSpacing / 2);
  column->addWidget(title_);
  column->addWidget(bars_);
  column->addWidget(shares_);
  column->addWidget(sentences_);
  onRetranslate(this, [this] { refresh(); });
  hide();
}

void ExposureView::setCamera(int camera) {
  if (camera != camera_) {
    camera_ = camera;
    refresh();
  }
}

void ExposureView::setSnapshot(const TrackSnapshotPtr& snapshot) {
  if (!hasMeasurableTargets(snapshot)) {
    job_.cancel();
    measured_.clear();
    refresh();
    hide();
    return;
  }
  setVisible(true);
  job_.start([this, snapshot](const BackgroundJob::Progress&) {
    auto measured = std::make_shared<std::vector<std::vector<ExposureInView>>>();
    for (std::size_t k = 0; k < snapshot->frames->frames.size(); ++k) {
      measured->push_back(exposuresInView(*snapshot, static_cast<int>(k)));
    }
    return [this, snapshot, measured] { take(std::move(*measured), *snapshot->frames); };
  });
}

void ExposureView::take(std::vector<std::vector<ExposureInView>> measured, const FrameSet& frames) {
  measured_.resize(measured.size());
  for (std::size_t k = 0; k < measured.size(); ++k) {
    Measured& kept = measured_[k];
    const bool isStale = !kept.age.isValid() || kept.age.elapsed() > kStaysMs;
    if (frames.frames[k] || isStale) {
      kept.exposures = std::move(measured[k]);
      kept.age.start();
    }
  }
  refresh();
}

void ExposureView::refresh() {
  const auto index = static_cast<std::size_t>(camera_);
  const ExposureInView* worst = camera_ >= 0 && index < measured_.size()
                                    ? worstExposure(measured_[index].exposures)
                                    : nullptr;
  title_->setText(worst == nullptr ? tr("Exposure: no target is visible in this camera")
                                   : tr("Exposure of %1").arg(QString::fromStdString(worst->name)));
  const TargetExposure exposure = worst != nullptr ? worst->exposure : TargetExposure();
  bars_->setExposure(exposure);
  shares_->setText(worst == nullptr ? QString()
                                    : tr("%1 % overexposed · %2 % too dark")
                                          .arg(percentNumber(exposure.clippedShare()),
                                               percentNumber(exposure.darkShare())));
  QStringList sentences;
  for (std::size_t k = 0; k < measured_.size(); ++k) {
    const ExposureInView* one = worstExposure(measured_[k].exposures);
    if (one != nullptr && one->exposure.fault() != ExposureFault::None) {
      sentences << QStringLiteral("▲ ") + sentenceFor(static_cast<int>(k), one->exposure);
    }
  }
  sentences_->setText(sentences.join(QLatin1Char('\n')));
  sentences_->setVisible(!sentences.isEmpty());
}

QString ExposureView::sentenceFor(int camera, const TargetExposure& exposure) const {
  const QString name = cameras_.nameOf(camera);
  return exposure.fault() == ExposureFault::Overexposed
             ? tr("%1: %2 % of the target's pixels are overexposed. Lower the exposure.")
                   .arg(name, percentNumber(exposure.clippedShare()))
             : tr("%1: %2 % of the target's pixels are too dark. Raise the exposure, or add light.")
                   .arg(name, percentNumber(exposure.darkShare()));
}

} // namespace dewpoint::ui
