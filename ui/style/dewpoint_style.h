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

/// Returns the color of the done part of a progress bar: so much of the accent that the bar is
/// seen, and so little that text in the color of the palette is legible on it.
QColor progressColor(const QPalette& palette);

} // namespace dewpoint::ui
