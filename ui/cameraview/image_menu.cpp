// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/image_menu.h"

#include "ui/actions/action_registry.h"
#include "ui/cameraview/camera_view.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>

namespace dewpoint::ui {

namespace {

constexpr double kMenuZoom = 2.0; ///< more than a step: the menu opens again for each

void addEntries(QMenu* menu, const std::vector<ImageMenuEntry>& entries) {
  for (const ImageMenuEntry& entry : entries) {
    QAction* action = menu->addAction(entry.text);
    action->setObjectName(entry.name);
    action->setToolTip(entry.hint);
    action->setStatusTip(entry.hint);
    action->setEnabled(entry.isEnabled);
    QObject::connect(action, &QAction::triggered, menu, entry.run);
  }
  if (!entries.empty()) {
    menu->addSeparator();
  }
}

} // namespace

ImageMenu::ImageMenu(const Workbench& bench) : QObject(&bench.window), bench_(bench) {}

void ImageMenu::open(int camera, CameraView* view, const QPointF& position) {
  auto* menu = new QMenu(view); // it goes with the view
  menu->setObjectName(QStringLiteral("menuImage"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->setToolTipsVisible(true);
  if (const auto pixel = view->pixelAt(position)) {
    for (const Section& section : sections_) {
      addEntries(menu, section(camera, *pixel));
    }
  }
  const auto hintOf = [this](ActionId id) { return bench_.actions.hintOf(bench_.action(id)); };
  addEntries(menu, {{QStringLiteral("imageZoomIn"), bench_.action("actionZoomIn")->text(),
                     hintOf("actionZoomIn"), !view->imageSize().isEmpty(),
                     [view, position] { view->zoomBy(kMenuZoom, position); }},
                    {QStringLiteral("imageFit"), bench_.action("actionFitImage")->text(),
                     hintOf("actionFitImage"), view->isZoomed(), [view] { view->fitImage(); }}});
  menu->popup(view->mapToGlobal(position.toPoint()));
}

} // namespace dewpoint::ui
