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

/// One entry of the menu of an image.
struct ImageMenuEntry {
  QString name; ///< objectName of its action
  QString text;
  QString hint; ///< one sentence
  bool enabled = true;
  std::function<void()> run;
};

/// The menu that a right click on a camera image opens, and the Menu key: what features add about
/// the pixel there, then the zoom.
class ImageMenu : public QObject {
  Q_OBJECT
public:
  explicit ImageMenu(const Workbench& bench);

  /// What a feature offers at a pixel of the image of a camera; nothing: no entries.
  using Section = std::function<std::vector<ImageMenuEntry>(int camera, const QPointF& pixel)>;
  /// Sections stand in the order they are added.
  void addSection(Section section) { sections_.push_back(std::move(section)); }
  /// Opens the menu at a position of a view, which may lie beside its image.
  void open(int camera, CameraView* view, const QPointF& position);

private:
  Workbench bench_;
  std::vector<Section> sections_;
};

} // namespace dewpoint::ui
