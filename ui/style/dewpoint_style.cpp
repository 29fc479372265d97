// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/dewpoint_style.h"

#include "ui/style/mixed_color.h"
#include "ui/style/theme.h"

#include <QPainter>
#include <QStyleOption>

#include <algorithm>

namespace dewpoint::ui {
namespace {

constexpr double kButtonRadius = 4.0; ///< of its corners, pixels; as that of the cards

/// The face of a button: how it is told apart are shares of the text's color in it, chosen by eye
/// in light and dark.
QColor buttonFace(const QStyleOption& option) {
  constexpr double kHovered = 0.05;
  constexpr double kPressed = 0.14;
  constexpr double kOn = 0.22; ///< of the accent
  const QPalette& palette = option.palette;
  const QColor face = palette.color(QPalette::Button);
  if (!option.state.testFlag(QStyle::State_Enabled)) {
    return palette.color(QPalette::Window);
  }
  if (option.state.testFlag(QStyle::State_Sunken)) {
    return mixedColor(face, palette.color(QPalette::ButtonText), kPressed);
  }
  if (option.state.testFlag(QStyle::State_On)) {
    return mixedColor(face, palette.color(QPalette::Highlight), kOn);
  }
  return option.state.testFlag(QStyle::State_MouseOver)
             ? mixedColor(face, palette.color(QPalette::ButtonText), kHovered)
             : face;
}

QColor buttonEdge(const QStyleOption& option) {
  constexpr double kQuiet = 0.22; ///< of the text's color; by eye, as those of the face
  constexpr double kGray = 0.1;   ///< of it, where the button is disabled
  const QPalette& palette = option.palette;
  const QColor ground = palette.color(QPalette::Window);
  if (!option.state.testFlag(QStyle::State_Enabled)) {
    return mixedColor(ground, palette.color(QPalette::Active, QPalette::WindowText), kGray);
  }
  const auto* button = qstyleoption_cast<const QStyleOptionButton*>(&option);
  const bool isDefault =
      button != nullptr && button->features.testFlag(QStyleOptionButton::DefaultButton);
  const bool isFocused = option.state.testFlag(QStyle::State_HasFocus) &&
                         option.state.testFlag(QStyle::State_KeyboardFocusChange);
  if (isDefault || isFocused || option.state.testFlag(QStyle::State_On)) {
    return palette.color(QPalette::Highlight);
  }
  return mixedColor(ground, palette.color(QPalette::WindowText), kQuiet);
}

void drawButton(const QStyleOption& option, QPainter* painter) {
  const auto* button = qstyleoption_cast<const QStyleOptionButton*>(&option);
  const bool isBare = button != nullptr && button->features.testFlag(QStyleOptionButton::Flat) &&
                      (option.state & (QStyle::State_Sunken | QStyle::State_On)) == 0 &&
                      !option.state.testFlag(QStyle::State_MouseOver);
  if (isBare) {
    return;
  }
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(buttonEdge(option));
  painter->setBrush(buttonFace(option));
  painter->drawRoundedRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5), kButtonRadius,
                           kButtonRadius);
  painter->restore();
}

void drawHeaderSection(const QStyleOption& option, QPainter* painter) {
  const QColor line = option.palette.color(QPalette::Mid);
  painter->save();
  painter->fillRect(option.rect, option.palette.color(QPalette::Window));
  painter->setPen(line);
  painter->drawLine(option.rect.bottomLeft(), option.rect.bottomRight());
  const auto* header = qstyleoption_cast<const QStyleOptionHeader*>(&option);
  const bool isLast = header == nullptr || header->position == QStyleOptionHeader::End ||
                      header->position == QStyleOptionHeader::OnlyOneSection;
  if (!isLast) {
    constexpr int kInset = 4; // pixels: a divider, not a fence
    painter->drawLine(option.rect.topRight() + QPoint(0, kInset),
                      option.rect.bottomRight() - QPoint(0, kInset));
  }
  painter->restore();
}

/// The done part of a bar of known length that lies flat.
void drawProgress(const QStyleOptionProgressBar& bar, QPainter* painter) {
  const double steps = std::max(1.0, double(bar.maximum) - bar.minimum);
  const double share = std::clamp((double(bar.progress) - bar.minimum) / steps, 0.0, 1.0);
  const QRectF whole = QRectF(bar.rect).adjusted(0.5, 0.5, -0.5, -0.5);
  QRectF done = whole;
  done.setWidth(share * whole.width());
  if ((bar.direction == Qt::RightToLeft) != bar.invertedAppearance) {
    done.moveRight(whole.right());
  }
  if (share > 0.0) {
    painter->save();
    painter->setPen(
        bar.palette.color(QPalette::Highlight)); // a pale bar alone is easily overlooked
    painter->setBrush(progressColor(bar.palette));
    painter->drawRect(done);
    painter->restore();
  }
}

/// Text that is legible on both parts of a bar, so that it needs only one color.
void drawProgressText(const DewpointStyle& style, const QStyleOptionProgressBar& bar,
                      QPainter* painter) {
  if (bar.textVisible) {
    style.drawItemText(painter, bar.rect, Qt::AlignCenter | Qt::TextSingleLine, bar.palette, true,
                       bar.fontMetrics.elidedText(bar.text, Qt::ElideRight, bar.rect.width()),
                       QPalette::Text);
  }
}

} // namespace

QColor progressColor(const QPalette& palette) {
  constexpr double kShare = 0.4; // of the accent: text has a contrast of 6.9 in dark, 9.0 in light
  return mixedColor(palette.color(QPalette::Base), palette.color(QPalette::Highlight), kShare);
}

DewpointStyle::DewpointStyle() : QProxyStyle(QStringLiteral("fusion")) {}

void DewpointStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                                  QPainter* painter, const QWidget* widget) const {
  if (element == PE_PanelButtonCommand) {
    drawButton(*option, painter);
    return;
  }
  QProxyStyle::drawPrimitive(element, option, painter, widget);
  const bool isRound = element == PE_IndicatorRadioButton;
  const bool isMarked =
      isRound || element == PE_IndicatorCheckBox || element == PE_IndicatorItemViewItemCheck;
  const bool isOn = option->state.testFlag(State_On) && element == PE_PanelButtonTool;
  if ((!isMarked && !isOn) || !isDarkPalette(option->palette)) {
    return;
  }
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing, isRound);
  painter->setBrush(Qt::NoBrush);
  painter->setPen(option->palette.color(isOn ? QPalette::Highlight : QPalette::PlaceholderText));
  const QRectF edge = QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5);
  isRound ? painter->drawEllipse(edge) : painter->drawRect(edge);
  painter->restore();
}

void DewpointStyle::drawControl(ControlElement element, const QStyleOption* option,
                                QPainter* painter, const QWidget* widget) const {
  if (element == CE_HeaderSection || element == CE_HeaderEmptyArea) {
    drawHeaderSection(*option, painter);
    return;
  }
  if (const auto* bar = qstyleoption_cast<const QStyleOptionProgressBar*>(option);
      bar != nullptr && bar->maximum > bar->minimum && bar->state.testFlag(State_Horizontal)) {
    if (element == CE_ProgressBarContents) {
      drawProgress(*bar, painter);
      return;
    }
    if (element == CE_ProgressBarLabel) {
      drawProgressText(*this, *bar, painter);
      return;
    }
  }
  QProxyStyle::drawControl(element, option, painter, widget);
}

} // namespace dewpoint::ui
