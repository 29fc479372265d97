// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProxyStyle>

namespace dewpoint::ui {

/// Qt's Fusion style with flat buttons, drop-down boxes and table heads in place of gradients, and
/// with an edge around boxes and circles to be marked and around buttons that are on: Fusion's own
/// edges are darker than the ground, which in dark colors is no edge at all.
class DewpointStyle : public QProxyStyle {
public:
  DewpointStyle();

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                   const QWidget* widget) const override;
};

} // namespace dewpoint::ui
