// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/world/world_mark_tool.h"

#include "core/session/snapshot/sight_lines.h"
#include "core/session/snapshot/snapshot_state.h"
#include "ui/calibration/snapped_click.h"
#include "ui/calibration/world/world_marks.h"
#include "ui/cameraview/camera_view.h"
#include "ui/cameraview/image_pick_overlay.h"
#include "ui/document/camera_list_model.h"
#include "ui/selection/selection.h"
#include "ui/text/retranslation.h"

#include <QPolygonF>

#include <optional>
#include <utility>

namespace dewpoint::ui {
namespace {

/// Half the size of the diamond around a mark, as a share of the width of the image. Chosen.
constexpr double kMarkShare = 0.008;

QPolygonF diamondAt(const Eigen::Vector2d& pixel, double half) {
  return {{{pixel.x() - half, pixel.y()},
           {pixel.x(), pixel.y() - half},
           {pixel.x() + half, pixel.y()},
           {pixel.x(), pixel.y() + half}}};
}

} // namespace

WorldMarkTool::WorldMarkTool(const Workbench& bench, WorldMarks& marks, QObject* parent)
    : QObject(parent), bench_(bench), marks_(marks) {
  connect(&marks_, &WorldMarks::changed, this, &WorldMarkTool::refresh);
}

void WorldMarkTool::attach(int camera, CameraView* view) {
  auto* overlay = new ImagePickOverlay(view);
  overlay->setObjectName(view->objectName() + QStringLiteral("WorldMarks"));
  overlay->setPointDragging(true);
  overlay->hide();
  const Layer layer{camera, overlay};
  layers_.push_back(layer);
  const auto name = [this, overlay, camera] {
    overlay->setHint(tr("Click point %1 in two images · Esc: stop")
                         .arg(WorldMarks::letterOf(marks_.selectedMark())));
    overlay->setAccessibleName(
        tr("Image of %1: arrow keys move a cross, Enter marks the point there")
            .arg(bench_.cameras.nameOf(camera)));
  };
  onRetranslate(overlay, name);
  connect(&bench_.cameras, &CameraListModel::dataChanged, overlay, name);
  connect(&marks_, &WorldMarks::changed, overlay, name);
  connect(overlay, &QObject::destroyed, this, [this, overlay] {
    std::erase_if(layers_, [overlay](const Layer& one) { return one.overlay == overlay; });
  });
  connect(overlay, &ImagePickOverlay::canceled, &marks_,
          [this] { marks_.setClicksPlacePoint(false); });
  connect(overlay, &ImagePickOverlay::picked, &marks_,
          [this, camera](const QRectF& region, Qt::KeyboardModifiers modifiers) {
            bench_.selection.selectCamera(camera);
            const Eigen::Vector2d pixel(region.left(), region.top());
            marks_.setClick(camera, snappedClick(snapshot_, camera, pixel,
                                                 modifiers.testFlag(Qt::AltModifier)));
          });
  refresh();
}

void WorldMarkTool::setSnapshot(const TrackSnapshotPtr& snapshot) {
  snapshot_ = snapshot;
  refresh();
}

void WorldMarkTool::refresh() {
  for (const Layer& layer : layers_) {
    const bool isShown = marks_.clicksPlacePoint();
    layer.overlay->setPicking(isShown);
    if (layer.overlay->isHidden() == isShown) {
      layer.overlay->setVisible(isShown);
      layer.overlay->raise();
    }
    if (isShown) {
      showMarks(layer);
    }
  }
}

void WorldMarkTool::showMarks(const Layer& layer) const {
  if (!snapshot_ || cameraOf(*snapshot_, layer.camera) == nullptr) {
    return;
  }
  const double half = kMarkShare * cameraOf(*snapshot_, layer.camera)->intrinsics.width;
  std::vector<ImagePickOverlay::Region> regions;
  for (int mark = 0; mark < WorldMarks::kMarkCount; ++mark) {
    for (const PointClick& click : marks_.clicks(mark)) {
      if (click.camera == layer.camera) {
        regions.push_back({diamondAt(click.pixel, half), WorldMarks::letterOf(mark)});
      }
    }
  }
  layer.overlay->setRegions(std::move(regions));
  std::vector<QPolygonF> rays;
  for (const PointClick& click : marks_.clicks(marks_.selectedMark())) {
    for (const ImageLine& line : clickedRayLines(*snapshot_, click, layer.camera)) {
      QPolygonF& drawn = rays.emplace_back();
      for (const Eigen::Vector2d& pixel : line) {
        drawn << QPointF(pixel.x(), pixel.y());
      }
    }
  }
  const auto position = marks_.positionOf(marks_.selectedMark());
  const auto seen = position ? pixelOf(*snapshot_, layer.camera, position->mean) : std::nullopt;
  layer.overlay->setGuides(std::move(rays),
                           seen ? std::optional(QPointF(seen->x(), seen->y())) : std::nullopt);
}

} // namespace dewpoint::ui
