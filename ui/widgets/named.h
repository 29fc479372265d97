// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLatin1String>
#include <QObject>

namespace dewpoint::ui {

/// Gives a new widget the name by which style sheets and tests find it, and returns it.
template <class Widget> Widget* named(Widget* widget, const char* name) {
  widget->setObjectName(QLatin1String(name));
  return widget;
}

} // namespace dewpoint::ui
