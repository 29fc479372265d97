// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_readout.h"

#include "ui/style/tabular_font.h"

#include <QCoreApplication>

#include <algorithm>
#include <limits>

namespace dewpoint::ui {

namespace {

constexpr double kFontShare = 0.92; ///< of the window's font
constexpr int kSwatch = 12;         ///< pixels, with the gap after it
constexpr int kColumnSpace = 12;    ///< between the columns of a readout
constexpr int kReadoutBorder = 8;
/// Entries of plots with short names (x, y, z) stand in so many columns, one below the other.
constexpr int kShortColumns = 3;
constexpr int kLongColumns = 2;
constexpr int kLongLines = 3; ///< more of them take another column instead
constexpr int kShortName = 2; ///< letters

QFont readoutFont(const QFont& font) {
  QFont small = font;
  small.setPointSizeF(font.pointSizeF() * kFontShare);
  return small;
}

bool hasTruth(const PlotDeclaration& plot) {
  return std::ranges::any_of(plot.curves,
                             [](const auto& curve) { return curve.truth.has_value(); });
}

int columnsOf(const PlotDeclaration& plot) {
  const auto count = static_cast<int>(plot.curves.size());
  const bool isShort = std::ranges::all_of(
      plot.curves, [](const auto& curve) { return curve.name.size() <= kShortName; });
  return count <= 1                          ? 1
         : isShort                           ? kShortColumns
         : count > kLongColumns * kLongLines ? kShortColumns
                                             : kLongColumns;
}

/// A title in two lines that are as short as they can be, divided at a space.
std::pair<QString, QString> inTwoLines(const QString& title, const QFontMetrics& metrics) {
  std::pair<QString, QString> best(title, {});
  int width = metrics.horizontalAdvance(title);
  for (qsizetype space = title.indexOf(u' '); space > 0; space = title.indexOf(u' ', space + 1)) {
    const QString first = title.left(space);
    const QString second = title.mid(space + 1);
    const int widest =
        std::max(metrics.horizontalAdvance(first), metrics.horizontalAdvance(second));
    if (widest < width) {
      width = widest;
      best = {first, second};
    }
  }
  return best;
}

int widthOfLines(const std::pair<QString, QString>& lines, const QFontMetrics& metrics) {
  return std::max(metrics.horizontalAdvance(lines.first), metrics.horizontalAdvance(lines.second));
}

void setFixedWidth(QCPLayoutElement& element, int width) {
  element.setMinimumSize(width, 0);
  element.setMaximumSize(width, QWIDGETSIZE_MAX);
}

} // namespace

PlotCaption::PlotCaption(QCustomPlot* plot, const PlotDeclaration& declaration)
    : QCPLayoutElement(plot), declaration_(declaration) {
  setLayer(QStringLiteral("axes"));
}

int PlotCaption::widthFor(const std::vector<const PlotDeclaration*>& plots, const QFont& font) {
  const QFontMetrics metrics(readoutFont(font));
  int width = 0;
  for (const PlotDeclaration* plot : plots) {
    width = std::max(width, widthOfLines(inTwoLines(titleWithUnit(*plot), metrics), metrics));
  }
  return width + kReadoutBorder + 2; // a rounded width is no reason for dots
}

void PlotCaption::setWidth(int width) {
  setFixedWidth(*this, width);
}

void PlotCaption::draw(QCPPainter* painter) {
  if (rect().width() <= kReadoutBorder) {
    return;
  }
  const QFont font = readoutFont(mParentPlot->font());
  const QFontMetrics metrics(font);
  const QRect area = rect().adjusted(kReadoutBorder, 0, 0, 0);
  const QString title = titleWithUnit(declaration_);
  const auto [first, second] = metrics.horizontalAdvance(title) <= area.width()
                                   ? std::pair(title, QString())
                                   : inTwoLines(title, metrics);
  painter->setFont(font);
  painter->setPen(mParentPlot->palette().color(QPalette::WindowText));
  int base = area.top() + metrics.ascent();
  for (const QString& line : {first, second}) {
    painter->drawText(area.left(), base, metrics.elidedText(line, Qt::ElideRight, area.width()));
    base += metrics.height();
  }
}

PlotReadout::PlotReadout(QCustomPlot* plot, const PlotDeclaration& declaration)
    : QCPLayoutElement(plot), declaration_(declaration) {
  setLayer(QStringLiteral("cursor"));
}

int PlotReadout::widthFor(const std::vector<const PlotDeclaration*>& plots, const QFont& font) {
  const QFontMetrics metrics(tabularFont(readoutFont(font)));
  const bool narrow =
      std::ranges::all_of(plots, [](const auto* plot) { return plot->curves.size() <= 1; });
  const int value = metrics.horizontalAdvance(QStringLiteral("−0000.0"));
  const int column = kSwatch + value + (narrow ? 0 : metrics.horizontalAdvance(u'x') + 6);
  return narrow ? kReadoutBorder + column + 4
                : kReadoutBorder + kShortColumns * column + (kShortColumns - 1) * kColumnSpace + 4;
}

int PlotReadout::lineCount(const PlotDeclaration& plot) {
  const int columns = columnsOf(plot);
  const int entries = static_cast<int>(plot.curves.size()) + (hasTruth(plot) ? 1 : 0);
  return (entries + columns - 1) / columns;
}

int PlotReadout::lineHeight(const QFont& font) {
  return QFontMetrics(tabularFont(readoutFont(font))).height();
}

void PlotReadout::setWidth(int width) {
  setFixedWidth(*this, width);
}

QString PlotReadout::textOf(const PlotDeclaration& plot, const std::vector<double>& values) {
  QStringList parts;
  for (std::size_t curve = 0; curve < plot.curves.size(); ++curve) {
    const double value =
        curve < values.size() ? values[curve] : std::numeric_limits<double>::quiet_NaN();
    parts << QStringLiteral("%1 %2").arg(plot.curves[curve].name,
                                         quantityText(plot.quantity, value));
  }
  return parts.join(QStringLiteral(", "));
}

void PlotReadout::draw(QCPPainter* painter) {
  const QRect area = rect().adjusted(kReadoutBorder, 0, -4, 0);
  if (area.width() <= 0) {
    return;
  }
  const QColor text = mParentPlot->palette().color(QPalette::WindowText);
  const QFont font = tabularFont(readoutFont(mParentPlot->font()));
  const QFontMetrics metrics(font);
  const int line = metrics.height();
  painter->setFont(font);
  const int columns = columnsOf(declaration_);
  const int width = (area.width() - kColumnSpace * (columns - 1)) / columns;
  const auto boxOf = [&](int entry) {
    return QRect(area.left() + entry % columns * (width + kColumnSpace),
                 area.top() + entry / columns * line, width, line);
  };
  const auto count = static_cast<int>(declaration_.curves.size());
  for (int entry = 0; entry < count; ++entry) {
    const auto index = static_cast<std::size_t>(entry);
    const CurveDeclaration& curve = declaration_.curves[index];
    const double value =
        index < values_.size() ? values_[index] : std::numeric_limits<double>::quiet_NaN();
    const QRect box = boxOf(entry);
    painter->fillRect(QRect(box.left(), box.center().y(), 8, 2),
                      curveColor(curve.colorIndex, text));
    painter->setPen(text);
    const QString number = axisNumberText(declaration_.quantity, value);
    const int room = width - kSwatch - metrics.horizontalAdvance(number) - 6;
    if (room > 0 && (count > 1 || room > metrics.horizontalAdvance(curve.name))) {
      painter->drawText(box.adjusted(kSwatch, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                        metrics.elidedText(curve.name, Qt::ElideRight, room));
    } // else the title says what it is
    painter->drawText(box, Qt::AlignRight | Qt::AlignVCenter, number);
  }
  if (truthKnown_ && hasTruth(declaration_)) {
    const QRect box = boxOf(count);
    painter->setPen(QPen(text, 1.0, Qt::DashLine));
    painter->drawLine(QLineF(box.left(), box.center().y(), box.left() + 8, box.center().y()));
    painter->setPen(text);
    painter->drawText(box.adjusted(kSwatch, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                      metrics.elidedText(QCoreApplication::translate("PlotReadout", "truth"),
                                         Qt::ElideRight, width - kSwatch));
  }
}

} // namespace dewpoint::ui
