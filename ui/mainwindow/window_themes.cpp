// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/window_themes.h"

#include "ui/actions/action_registry.h"
#include "ui/style/system_colors.h"
#include "ui/style/theme.h"

#include <QAction>
#include <QMainWindow>

namespace dewpoint::ui {

namespace {

ActionId actionOf(Theme theme) {
  return theme == Theme::Light  ? ActionId("actionThemeLight")
         : theme == Theme::Dark ? ActionId("actionThemeDark")
                                : ActionId("actionThemeSystem");
}

} // namespace

WindowThemes::WindowThemes(const Workbench& bench)
    : QObject(&bench.window), bench_(bench), systemColors_(new SystemColors(this)) {
  for (const Theme theme : {Theme::System, Theme::Light, Theme::Dark}) {
    bench_.onTriggered(actionOf(theme), this, [this, theme] {
      setTheme(theme);
      Preferences().setTheme(theme);
    });
  }
  const auto applyAgain = [this] { setTheme(theme_); };
  connect(systemColors_, &SystemColors::darkModeChanged, this, applyAgain);
  connect(systemColors_, &SystemColors::colorsReplaced, this, applyAgain);
}

void WindowThemes::setTheme(Theme theme) {
  theme_ = theme;
  const bool dark = theme == Theme::Dark || (theme == Theme::System && systemColors_->isDark());
  applyTheme(dark);
  bench_.actions.drawIcons(themePalette(dark));
  bench_.action(actionOf(theme))->setChecked(true);
}

} // namespace dewpoint::ui
