// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/image_pick_tool.h"

#include "ui/cameraview/camera_view.h"
#include "ui/document/camera_list_model.h"
#include "ui/text/retranslation.h"

namespace dewpoint::ui {

ImagePickTool::ImagePickTool(const CameraListModel& cameras, QObject* parent)
    : QObject(parent), cameras_(cameras) {}

void ImagePickTool::attach(int camera, CameraView* view) {
  auto* layer = new ImagePickOverlay(view);
  const auto name = [this, layer, camera] {
    layer->setAccessibleName(tr("Image of %1: arrow keys move a cross, Enter clicks there")
                                 .arg(cameras_.nameOf(camera)));
  };
  onRetranslate(layer, name);
  connect(&cameras_, &CameraListModel::dataChanged, layer, name);
  layers_.emplace_back(camera, layer);
  connect(layer, &QObject::destroyed, this, [this, layer] {
    std::erase_if(layers_, [layer](const auto& one) { return one.second == layer; });
  });
  connect(layer, &ImagePickOverlay::viewChosen, this,
          [this, camera] { Q_EMIT cameraChosen(camera); });
  connect(layer, &ImagePickOverlay::imageClicked, this,
          [this, camera](const QPointF& pixel) { Q_EMIT imageClicked(camera, pixel); });
  connect(layer, &ImagePickOverlay::canceled, this, &ImagePickTool::canceled);
  connect(layer, &ImagePickOverlay::picked, this,
          [this, camera](const QRectF& region, Qt::KeyboardModifiers modifiers) {
            Q_EMIT picked(camera, region, modifiers);
          });
  Q_EMIT viewAttached();
}

void ImagePickTool::setPicking(bool picking, const QString& hint) {
  for (const auto& [camera, layer] : layers_) {
    layer->setPicking(picking);
    layer->setHint(hint);
  }
}

void ImagePickTool::pickAt(int camera, const QPointF& pixel, Qt::KeyboardModifiers modifiers) {
  Q_EMIT picked(camera, QRectF(pixel, QSizeF(0.0, 0.0)), modifiers);
}

void ImagePickTool::takeFocus() {
  if (!layers_.empty()) {
    layers_.front().second->setFocus(Qt::ShortcutFocusReason);
  }
}

void ImagePickTool::setRegions(int camera, const std::vector<ImagePickOverlay::Region>& regions) {
  for (const auto& [number, layer] : layers_) {
    if (number == camera) {
      layer->setRegions(regions);
    }
  }
}

void ImagePickTool::clearRegions() {
  for (const auto& [camera, layer] : layers_) {
    layer->setRegions({});
  }
}

} // namespace dewpoint::ui
