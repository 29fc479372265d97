// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/system_colors.h"

#include "ui/style/theme.h"

#include <QApplication>
#include <QEvent>

namespace dewpoint::ui {

namespace {

/// What the platform, or another part of the application, has for colors.
bool isSystemDark() {
  if (!isThemeApplied()) {
    return isDarkPalette(QApplication::palette());
  }
  // A palette that is set hides the platform's, and Qt 6.4 has no other public way to ask for that.
  const QPalette ours = QApplication::palette();
  QApplication::setPalette({});
  const bool dark = isDarkPalette(QApplication::palette());
  QApplication::setPalette(ours);
  return dark;
}

} // namespace

SystemColors::SystemColors(QObject* parent) : QObject(parent), dark_(isSystemDark()) {
  qApp->installEventFilter(this);
}

bool SystemColors::eventFilter(QObject* watched, QEvent* event) {
  const bool platform = event->type() == QEvent::ThemeChange;
  const bool outside = event->type() == QEvent::ApplicationPaletteChange && watched == qApp;
  if ((platform || outside) && !refreshing_ && (platform || !isThemeApplied())) {
    // What handles the event sets the palette, which sends such events again.
    QMetaObject::invokeMethod(this, &SystemColors::readColors, Qt::QueuedConnection);
  }
  return QObject::eventFilter(watched, event);
}

void SystemColors::readColors() {
  const bool foreign = !isThemeApplied();
  refreshing_ = true;
  const bool dark = isSystemDark();
  refreshing_ = false;
  if (dark != dark_) {
    dark_ = dark;
    Q_EMIT darkModeChanged(dark);
  }
  if (foreign) {
    Q_EMIT colorsReplaced();
  }
}

} // namespace dewpoint::ui
