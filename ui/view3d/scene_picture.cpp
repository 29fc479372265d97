// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/scene_picture.h"

#include <QWidget>

#include <algorithm>

namespace dewpoint::ui {

namespace {
constexpr qint64 kIntervalMs = 66;
} // namespace

ScenePicture::ScenePicture(Scene3d& scene, QWidget& view) : scene_(scene), view_(view) {
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, [this] {
    if (view_.isVisible()) { // it may have been hidden since the request
      render();
    }
  });
}

ScenePicture::~ScenePicture() = default;

void ScenePicture::start() {
  if (started_) {
    return;
  }
  started_ = true;
  vtk_ = std::make_unique<OffscreenVtk>(scene_.renderer());
  if (!vtk_->start()) {
    failure_ = vtk_->startError();
    vtk_.reset();
    Q_EMIT unavailable();
    return;
  }
  vtk_->onCameraMoved = [this] {
    scene_.keepCurrentView();
    requestRendering();
  };
}

void ScenePicture::prepareFirstImage() {
  start();
  if (vtk_) {
    constexpr QSize kSmall(64, 64);
    scene_.prepareRendering(kSmall.width(), kSmall.height());
    vtk_->render(kSmall);
  }
}

void ScenePicture::requestRendering() {
  stale_ = true;
  if (!view_.isVisible() || timer_.isActive()) {
    return; // hidden: drawn when shown
  }
  const qint64 interval = std::max(kIntervalMs, 2 * renderMs_);
  const qint64 elapsed = sinceDrawn_.isValid() ? sinceDrawn_.elapsed() : interval;
  timer_.start(static_cast<int>(std::max<qint64>(0, interval - elapsed)));
}

void ScenePicture::render() {
  start();
  stale_ = false;
  if (vtk_) {
    QElapsedTimer clock;
    clock.start();
    Q_EMIT aboutToRender();
    const QSize pixels = size();
    scene_.setPixelRatio(view_.devicePixelRatioF());
    scene_.prepareRendering(pixels.width(), pixels.height());
    image_ = vtk_->render(pixels);
    image_.setDevicePixelRatio(view_.devicePixelRatioF());
    Q_EMIT rendered();
    renderMs_ = clock.elapsed();
    sinceDrawn_.start();
  }
  view_.update();
}

QSize ScenePicture::size() const {
  return (QSizeF(view_.size()) * view_.devicePixelRatioF()).toSize().expandedTo(QSize(1, 1));
}

bool ScenePicture::hasSizeOfView() const {
  return image_.size() == size() &&
         qFuzzyCompare(image_.devicePixelRatio(), view_.devicePixelRatioF());
}

void ScenePicture::passPointerEvent(OffscreenVtk::PointerEvent what, QPointF position, bool shift) {
  if (vtk_) {
    vtk_->sendPointerEvent(what, (position * view_.devicePixelRatioF()).toPoint(), shift, false);
  }
}

} // namespace dewpoint::ui
