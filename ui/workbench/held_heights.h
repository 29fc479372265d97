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

/// Keeps the heights of the docks at the bottom of a window while room at its top comes or goes, so
/// that only what is between shrinks and grows. Always the same heights, until they are forgotten:
/// what the layout of a window rounds does not add up.
class HeldHeights : public QObject {
  Q_OBJECT
public:
  explicit HeldHeights(QMainWindow& window, QObject* parent = nullptr);

  /// Another arrangement counts from now on.
  void forget() { heights_.clear(); }
  /// The docks keep their heights, whatever comes, until release().
  void hold();
  /// Lays the window out and lets go of the docks.
  void release();

private:
  QMainWindow& window_;
  std::vector<std::pair<QPointer<QDockWidget>, int>> heights_;
};

} // namespace dewpoint::ui
