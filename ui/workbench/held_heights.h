// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QObject>
#include <QPointer>

#include <utility>
#include <vector>

class QDockWidget;
class QMainWindow;

namespace dewpoint::ui {

/// Keeps the heights of the docks at the bottom of a window while the height above the views
/// changes, so that only the views in between shrink and grow. The stored heights are used until
/// forgetHeights() is called, so that rounding in the window layout does not accumulate.
class HeldHeights : public QObject {
  Q_OBJECT
public:
  explicit HeldHeights(QMainWindow& window, QObject* parent = nullptr);

  /// Forgets the heights after the docks were rearranged.
  void forgetHeights() { heights_.clear(); }
  /// Fixes the heights of the docks at the bottom until `releaseHeights()`, unless the views in
  /// between have no room to shrink.
  void holdHeights();
  /// Updates the window layout, and allows the heights of the docks to change again.
  void releaseHeights();

private:
  QMainWindow& window_;
  std::vector<std::pair<QPointer<QDockWidget>, int>> heights_;
};

} // namespace dewpoint::ui
