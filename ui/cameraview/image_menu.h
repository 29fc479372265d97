// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

#include <QObject>
#include <QPoint>
#include <QPointF>
#include <QString>

#include <functional>
#include <utility>
#include <vector>

namespace dewpoint::ui {

class CameraView;

/// One entry of the context menu of an image.
struct ImageMenuEntry {
  QString name; ///< objectName of the action
  QString text;
  QString hint; ///< one sentence for the tooltip
  bool isEnabled = true;
  std::function<void()> run;
};

/// Context menu of the camera images, opened by a right click or the Menu key. Lists the entries
/// that features offer for the clicked pixel, followed by the zoom actions.
class ImageMenu : public QObject {
  Q_OBJECT
public:
  explicit ImageMenu(const Workbench& bench);

  /// Function of a feature that returns the entries to offer at a pixel of a camera image; may
  /// return none.
  using Section = std::function<std::vector<ImageMenuEntry>(int camera, const QPointF& pixel)>;
  /// Adds a section of entries below the existing sections.
  void addSection(Section section) { sections_.push_back(std::move(section)); }
  /// Opens the menu at a position in a view. The position may lie outside the image.
  void open(int camera, CameraView* view, const QPointF& position);

private:
  Workbench bench_;
  std::vector<Section> sections_;
};

} // namespace dewpoint::ui
