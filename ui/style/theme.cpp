// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/theme.h"

#include "core/session/people/people_overlay.h"
#include "core/session/snapshot/display_colors.h"
#include "ui/style/dewpoint_style.h"
#include "ui/style/identity_badge.h"
#include "ui/style/to_color.h"

#include <QApplication>

#include <vector>

namespace dewpoint::ui {

bool isDarkPalette(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() < 128;
}

QPalette themePalette(bool dark) {
  const QColor window(dark ? "#202326" : "#f3f4f5");
  const QColor base(dark ? "#17191b" : "#ffffff");
  const QColor text(dark ? "#e4e6e8" : "#1d2124");
  const QColor faint(dark ? "#767d84" : "#8b9298"); // of what is disabled: need not be legible
  const QColor quiet(dark ? "#8f969d" : "#5f666c"); // contrast of at least 4.5 on all grounds
  const QColor button(dark ? "#2b2f33" : "#e9ebed");
  const QColor accent(dark ? "#4c9fe0" : "#1f6fb5");
  QPalette palette;
  palette.setColor(QPalette::Window, window);
  palette.setColor(QPalette::WindowText, text);
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, window);
  palette.setColor(QPalette::Text, text);
  palette.setColor(QPalette::PlaceholderText, quiet);
  palette.setColor(QPalette::Button, button);
  palette.setColor(QPalette::ButtonText, text);
  palette.setColor(QPalette::BrightText, QColor("#d55e00"));
  palette.setColor(QPalette::ToolTipBase, base);
  palette.setColor(QPalette::ToolTipText, text);
  palette.setColor(QPalette::Highlight, accent);
  palette.setColor(QPalette::HighlightedText, dark ? QColor("#101214") : QColor("#ffffff"));
  palette.setColor(QPalette::Link, accent);
  palette.setColor(QPalette::Light, dark ? QColor("#3a3f44") : QColor("#ffffff"));
  palette.setColor(QPalette::Midlight, dark ? QColor("#33383c") : QColor("#f8f9fa"));
  palette.setColor(QPalette::Mid, dark ? QColor("#3a3f44") : QColor("#c9ced2"));
  palette.setColor(QPalette::Dark, dark ? QColor("#131516") : QColor("#a4abb1"));
  palette.setColor(QPalette::Shadow, dark ? QColor("#0b0c0d") : QColor("#7c848b"));
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, faint);
  }
  palette.setColor(QPalette::Disabled, QPalette::Highlight, faint);
  return palette;
}

void applyTheme(bool dark) {
  if (dynamic_cast<DewpointStyle*>(QApplication::style()) == nullptr) {
    QApplication::setStyle(new DewpointStyle); // the application owns it
  }
  QApplication::setPalette(themePalette(dark));
}

bool isThemeApplied() {
  const QPalette now = QApplication::palette();
  const QPalette ours = themePalette(isDarkPalette(now));
  return now.color(QPalette::Window) == ours.color(QPalette::Window) &&
         now.color(QPalette::Highlight) == ours.color(QPalette::Highlight);
}

QColor trackingStateColor(TrackingState state, const QPalette& palette) {
  const bool dark = isDarkPalette(palette);
  switch (state) {
  case TrackingState::Held:
    return QColor(dark ? "#2fc79a" : "#00734f");
  case TrackingState::Ambiguous:
  case TrackingState::Hidden:
  case TrackingState::Searching:
  case TrackingState::Learning:
    return QColor(dark ? "#e6a100" : "#8f5f00");
  case TrackingState::Lost:
  case TrackingState::Missing:
    return QColor(dark ? "#ff7f3f" : "#b34a00");
  case TrackingState::NotTracked:
  case TrackingState::NoBox:
  case TrackingState::NoTarget:
  case TrackingState::NoImages:
  case TrackingState::Nobody:
  case TrackingState::Gone:
    break;
  }
  return palette.color(QPalette::PlaceholderText);
}

QColor targetColor(int target) {
  const std::vector<DisplayColor>& palette = displayPalette(DisplayBackground::Image);
  return toQColor(palette[static_cast<std::size_t>(target) % palette.size()]);
}

QColor targetColor(const std::string& name, int target) {
  if (const auto identity = identityFromName(name)) {
    return personColor(*identity);
  }
  return targetColor(target);
}

} // namespace dewpoint::ui
