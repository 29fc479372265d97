// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/video_scene.h"

#include "ui/view3d/birds_eye_view.h"

#include <QElapsedTimer>

#include <algorithm>
#include <cmath>

namespace dewpoint::ui {

namespace {

// Chosen: small enough to be quick by software OpenGL, and far enough apart to tell what is due to
// the number of pixels.
constexpr QSize kSmallProbe(96, 54);
constexpr QSize kLargeProbe(384, 216);
constexpr double kLeastShare = 0.25; ///< of width and height

double areaInPixels(const QSize& size) {
  return static_cast<double>(size.width()) * size.height();
}

} // namespace

QSize largestSizeWithinTime(const QSize& wanted, double smallPixels, double smallMs,
                            double largePixels, double largeMs, double maxMs) {
  const double perPixel = std::max(0.0, (largeMs - smallMs) / (largePixels - smallPixels));
  const double fixed = std::max(0.0, smallMs - perPixel * smallPixels);
  const double whole = fixed + perPixel * areaInPixels(wanted);
  if (whole <= maxMs) {
    return wanted;
  }
  const double pixels = perPixel > 0.0 ? std::max(0.0, maxMs - fixed) / perPixel : 0.0;
  const double share = std::clamp(std::sqrt(pixels / areaInPixels(wanted)), kLeastShare, 1.0);
  return {std::max(1, qRound(wanted.width() * share)),
          std::max(1, qRound(wanted.height() * share))};
}

VideoScene::VideoScene() = default;
VideoScene::~VideoScene() = default;

void VideoScene::copyAppearance(const BirdsEyeView& shown, const std::optional<WorldBox>& volume,
                                const QSize& size) {
  if (!view_) {
    view_ = std::make_unique<BirdsEyeView>();
    view_->prepareFirstImage();
  }
  wanted_ = size;
  drawn_ = measured_ == wanted_ ? drawn_ : wanted_;
  view_->setPalette(shown.palette());
  view_->resize(wanted_);
  view_->copyAppearance(shown);
  view_->showVolume(volume);
}

QImage VideoScene::render(const QSize& size) {
  QElapsedTimer clock;
  clock.start();
  // In device pixels, of which a screen has more.
  const QSizeF widget = QSizeF(size) / view_->devicePixelRatioF();
  view_->resize({std::max(1, qRound(widget.width())), std::max(1, qRound(widget.height()))});
  QImage image = view_->currentImage();
  image.setDevicePixelRatio(1.0);
  lastMs_ = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
  return image;
}

void VideoScene::measure() {
  measured_ = wanted_;
  render(kSmallProbe); // what is new in the scene takes longer the first time
  render(kSmallProbe);
  const double small = lastMs_;
  render(kLargeProbe);
  drawn_ = largestSizeWithinTime(wanted_, areaInPixels(kSmallProbe), small,
                                 areaInPixels(kLargeProbe), lastMs_, kMaxDrawingMs);
}

QImage VideoScene::draw(const TrackSnapshotPtr& snapshot) {
  if (!view_) {
    return {};
  }
  view_->setSnapshot(snapshot);
  if (measured_ != wanted_) {
    measure();
  }
  return render(drawn_);
}

} // namespace dewpoint::ui
