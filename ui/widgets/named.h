// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLatin1String>
#include <QObject>

namespace dewpoint::ui {

/// Sets the object name of a new widget and returns the widget. Style sheets and tests find the
/// widget by this name.
template <class Widget> Widget* named(Widget* widget, const char* name) {
  widget->setObjectName(QLatin1String(name));
  return widget;
}

} // namespace dewpoint::ui
