// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/held_heights.h"

#include <QDockWidget>
#include <QLayout>
#include <QMainWindow>

namespace dewpoint::ui {

namespace {

constexpr int kMessageHeight = 64; ///< pixels, at most: two lines of text

void freeHeight(QDockWidget& dock) {
  dock.setMinimumHeight(0);
  dock.setMaximumHeight(QWIDGETSIZE_MAX);
}

} // namespace

HeldHeights::HeldHeights(QMainWindow& window, QObject* parent) : QObject(parent), window_(window) {}

void HeldHeights::holdHeights() {
  if (heights_.empty()) {
    for (QDockWidget* dock : window_.findChildren<QDockWidget*>()) {
      if (window_.dockWidgetArea(dock) == Qt::BottomDockWidgetArea && !dock->isFloating() &&
          !dock->isHidden() && !dock->visibleRegion().isEmpty()) { // not behind a tab
        heights_.emplace_back(dock, dock->height());
      }
    }
  }
  for (const auto& [dock, height] : heights_) {
    if (dock != nullptr) {
      dock->setFixedHeight(height);
    }
  }
  // A window that cannot shrink its views any further would grow, even beyond the screen.
  if (window_.minimumSizeHint().height() + kMessageHeight > window_.height()) {
    for (const auto& [dock, height] : heights_) {
      if (dock != nullptr) {
        freeHeight(*dock);
      }
    }
    heights_.clear();
  }
}

void HeldHeights::releaseHeights() {
  window_.layout()->activate();
  for (const auto& [dock, height] : heights_) {
    if (dock != nullptr) {
      freeHeight(*dock);
    }
  }
}

} // namespace dewpoint::ui
