// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/people/person_placer.h"

#include "ui/birdseye/birds_eye_view.h"
#include "ui/camera/camera_view.h"
#include "ui/camera/pick_layer.h"
#include "ui/settings/retranslation.h"

namespace dewpoint {

PersonPlacer::PersonPlacer(BirdsEyeView* birdsEye, QObject* parent)
    : QObject(parent), birdsEye_(birdsEye) {
  connect(birdsEye_, &BirdsEyeView::placeClicked, this, &PersonPlacer::placed);
}

void PersonPlacer::attach(int camera, CameraView* view) {
  auto* layer = new PickLayer(view);
  layer->setObjectName(view->objectName() + QStringLiteral("Person"));
  layer->hide();
  layers_.push_back(layer);
  inEveryLanguage(layer, [layer, camera] {
    layer->setHint(tr("Click the person"));
    layer->setAccessibleName(
        tr("Image of camera %1: arrow keys move a cross, Enter says that a person is there")
            .arg(camera + 1));
  });
  connect(layer, &QObject::destroyed, this, [this, layer] { std::erase(layers_, layer); });
  connect(layer, &PickLayer::cancelled, this, &PersonPlacer::cancelled);
  connect(layer, &PickLayer::picked, this, [this, camera](const QRectF& region) {
    const QPointF middle = region.center();
    Q_EMIT seen(camera, Eigen::Vector2d(middle.x(), middle.y()));
  });
}

void PersonPlacer::setPlacing(bool placing, double floor) {
  birdsEye_->setPlacing(placing, floor);
  for (PickLayer* layer : layers_) {
    layer->setPicking(placing);
    layer->setVisible(placing);
    layer->raise();
  }
  if (placing && !layers_.empty()) {
    layers_.front()->setFocus(Qt::ShortcutFocusReason); // the keys move its cross
  }
}

} // namespace dewpoint
