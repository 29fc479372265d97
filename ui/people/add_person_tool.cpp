// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/people/add_person_tool.h"

#include "ui/cameraview/camera_view.h"
#include "ui/cameraview/image_pick_overlay.h"
#include "ui/document/camera_list_model.h"
#include "ui/text/retranslation.h"
#include "ui/view3d/birds_eye_view.h"

namespace dewpoint::ui {

AddPersonTool::AddPersonTool(BirdsEyeView* birdsEye, const CameraListModel& cameras,
                             QObject* parent)
    : QObject(parent), birdsEye_(birdsEye), cameras_(cameras) {
  connect(birdsEye_, &BirdsEyeView::floorClicked, this, &AddPersonTool::floorClicked);
}

void AddPersonTool::attachView(int camera, CameraView* view) {
  auto* layer = new ImagePickOverlay(view);
  layer->setObjectName(view->objectName() + QStringLiteral("Person"));
  layer->setMagnifying(false); // people are large
  layer->hide();
  layers_.push_back(layer);
  const auto name = [this, layer, camera] {
    layer->setHint(tr("Click the person"));
    layer->setAccessibleName(tr("Image of %1: arrow keys move a cross, Enter adds a person there")
                                 .arg(cameras_.nameOf(camera)));
  };
  onRetranslate(layer, name);
  connect(&cameras_, &CameraListModel::dataChanged, layer, name);
  connect(layer, &QObject::destroyed, this, [this, layer] { std::erase(layers_, layer); });
  connect(layer, &ImagePickOverlay::canceled, this, &AddPersonTool::canceled);
  connect(layer, &ImagePickOverlay::picked, this, [this, camera](const QRectF& region) {
    const QPointF middle = region.center();
    Q_EMIT personClicked(camera, Eigen::Vector2d(middle.x(), middle.y()));
  });
}

void AddPersonTool::setPersonPlacingMode(bool placing, double floor) {
  birdsEye_->setPersonPlacingMode(placing, floor);
  for (ImagePickOverlay* layer : layers_) {
    layer->setPicking(placing);
    layer->setVisible(placing);
    layer->raise();
  }
  if (placing && !layers_.empty()) {
    layers_.front()->setFocus(Qt::ShortcutFocusReason); // the keys move its cross
  }
}

} // namespace dewpoint::ui
