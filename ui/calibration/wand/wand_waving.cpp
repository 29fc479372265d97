// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/wand/wand_waving.h"

#include "core/project/project.h"
#include "ui/calibration/wand/coverage_map.h"
#include "ui/calibration/wand/wand_calibrator.h"
#include "ui/text/camera_names.h"
#include "ui/text/quantity_text.h"
#include "ui/text/retranslation.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace dewpoint::ui {
namespace {
constexpr int kColumns = 3;
}

WandWaving::WandWaving(WandCalibrator& calibrator, QWidget* parent)
    : QWidget(parent), calibrator_(calibrator), wave_(new QPushButton(this)),
      state_(new QLabel(this)), grid_(new QGridLayout) {
  setObjectName(QStringLiteral("wandWaving"));
  wave_->setObjectName(QStringLiteral("wandWave"));
  state_->setObjectName(QStringLiteral("wandWaveState"));
  state_->setWordWrap(true);
  grid_->setSpacing(6);
  for (int column = 0; column < kColumns; ++column) {
    grid_->setColumnStretch(column, 1);
  }
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  column->addWidget(wave_);
  column->addWidget(state_);
  column->addLayout(grid_);
  connect(wave_, &QPushButton::clicked, this, [this] {
    calibrator_.isCollectingViews() ? calibrator_.stopCollectingViews()
                                    : calibrator_.startCollectingViews();
  });
  connect(&calibrator_, &WandCalibrator::changed, this, &WandWaving::refresh);
  connect(&calibrator_, &WandCalibrator::collectorStateChanged, this, &WandWaving::showCameras);
  onRetranslate(this, [this] { retranslateUi(); });
}

void WandWaving::retranslateUi() {
  wave_->setToolTip(tr("Collect positions of the ball from all camera images. If you start again, "
                       "the positions collected before are discarded"));
  refresh();
}

void WandWaving::refresh() {
  const bool waving = calibrator_.isCollectingViews();
  wave_->setText(waving ? tr("■ Stop waving") : tr("● Start waving"));
  wave_->setAccessibleName(waving ? tr("Stop waving") : tr("Start waving"));
  wave_->setEnabled(!calibrator_.isRefining());
  showCameras();
}

void WandWaving::makeCameraRows(std::size_t count) {
  while (cameras_.size() > count) {
    delete cameras_.back().map;
    delete cameras_.back().text;
    cameras_.pop_back();
  }
  while (cameras_.size() < count) {
    const int k = static_cast<int>(cameras_.size());
    CameraPart part{new CoverageMap(this), new QLabel(this)};
    part.map->setObjectName(QStringLiteral("wandMap%1").arg(k));
    part.text->setObjectName(QStringLiteral("wandSeen%1").arg(k));
    part.text->setAlignment(Qt::AlignHCenter);
    grid_->addWidget(part.map, 2 * (k / kColumns), k % kColumns);
    grid_->addWidget(part.text, 2 * (k / kColumns) + 1, k % kColumns);
    cameras_.push_back(part);
  }
}

void WandWaving::showCameras() {
  const auto collected = calibrator_.collectorState();
  makeCameraRows(collected ? collected->cameras.size() : 0);
  if (!collected) {
    state_->setText(tr("No ball positions collected yet."));
    return;
  }
  CameraRig rig;
  for (const ProjectCamera& camera : calibrator_.project().cameras) {
    rig.push_back(camera.camera);
  }
  bool enough = true;
  for (std::size_t k = 0; k < cameras_.size(); ++k) {
    const CameraSightings& seen = collected->cameras[k];
    const bool good = hasEnoughDetections(seen);
    enough = enough && good;
    const Intrinsics image = k < rig.size() ? rig[k].intrinsics : Intrinsics();
    cameras_[k].map->setCamera(cameraName(rig, k), seen,
                               image.height > 0 ? double(image.width) / image.height : 4.0 / 3.0);
    cameras_[k].text->setText(
        QStringLiteral("%1 %2 %3")
            .arg(good ? QStringLiteral("✓") : QStringLiteral("…"), cameraName(rig, k))
            .arg(static_cast<qulonglong>(seen.detectionCount)));
  }
  QString text = tr("The positions of the ball have been recorded for %1 so far.")
                     .arg(secondsText(collected->durationSeconds, 1));
  text += QLatin1Char(' ') +
          (enough ? tr("Every camera has seen the ball often enough: stop waving, or press Refine "
                       "cameras.")
                  : tr("Keep waving: each camera should see the ball at least 150 times, spread "
                       "over at least half of its image."));
  if (collected->droppedFrameSetCount > 0) {
    text += QLatin1Char(' ') + tr("Frames skipped because they arrived too fast: %1.")
                                   .arg(collected->droppedFrameSetCount);
  }
  state_->setText(text);
}

} // namespace dewpoint::ui
