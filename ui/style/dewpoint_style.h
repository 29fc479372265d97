// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QProxyStyle>

class QPalette;

namespace dewpoint::ui {

/// Qt's Fusion style with flat buttons, drop-down boxes, table headers and progress bars instead of
/// gradients.
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

/// Returns the color of the completed part of a progress bar: strong enough to be seen, and faint
/// enough that text in the palette's color is legible on the bar.
QColor progressColor(const QPalette& palette);

} // namespace dewpoint::ui
