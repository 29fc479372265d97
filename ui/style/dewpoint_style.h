// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProxyStyle>

namespace dewpoint::ui {

/// Qt's Fusion style with flat buttons, drop-down boxes and table headers instead of gradients.
/// Adds an edge around check boxes, radio buttons and checked buttons. Fusion's own edges are
/// darker than the background and therefore invisible in dark colors.
class DewpointStyle : public QProxyStyle {
public:
  DewpointStyle();

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                   const QWidget* widget) const override;
};

} // namespace dewpoint::ui
