// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QObject>

namespace dewpoint::ui {

/// Watches whether the system colors are dark. The user can change them while the program runs.
class SystemColors : public QObject {
  Q_OBJECT
public:
  explicit SystemColors(QObject* parent = nullptr);

  bool isDark() const { return dark_; }

Q_SIGNALS:
  void darkModeChanged(bool dark);
  /// Emitted when the system has replaced the application's colors. The theme must then be applied
  /// again.
  void colorsReplaced();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void readColors();

  bool dark_;
  bool refreshing_ = false;
};

} // namespace dewpoint::ui
