// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_axis_strip.h"

#include "ui/style/tabular_font.h"

#include <QCoreApplication>
#include <QPainter>
#include <qcustomplot.h>

#include <algorithm>

namespace dewpoint::ui {

namespace {

constexpr int kTickLength = 3;
constexpr int kNameGap = 8; ///< between the end of the axis and its name

struct NumberedTicks {
  QVector<double> places;
  QVector<QString> texts;
};

NumberedTicks ticksOf(const QCPAxis& axis, const QLocale& locale) {
  NumberedTicks ticks;
  axis.ticker()->generate(axis.range(), locale, u'g', 5, ticks.places, nullptr, &ticks.texts);
  return ticks;
}

} // namespace

PlotAxisStrip::PlotAxisStrip(QCustomPlot& plot, QWidget* parent) : QWidget(parent), plot_(plot) {
  setObjectName(QStringLiteral("plotAxis"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  connect(&plot, &QCustomPlot::afterReplot, this, qOverload<>(&QWidget::update));
}

void PlotAxisStrip::setAxis(QCPAxis* axis, PlotAxis kind) {
  axis_ = axis;
  kind_ = kind;
  update();
}

QStringList PlotAxisStrip::tickLabels() const {
  if (axis_ == nullptr) {
    return {};
  }
  const NumberedTicks ticks = ticksOf(*axis_, plot_.locale());
  return {ticks.texts.begin(), ticks.texts.end()};
}

QFont PlotAxisStrip::numberFont() const {
  QFont small = font();
  small.setPointSizeF(small.pointSizeF() * 0.9);
  return tabularFont(small);
}

QSize PlotAxisStrip::sizeHint() const {
  return {100, QFontMetrics(numberFont()).height() + kTickLength + 2};
}

void PlotAxisStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  if (axis_ == nullptr) {
    return;
  }
  const int shift = plot_.mapTo(window(), QPoint()).x() - mapTo(window(), QPoint()).x();
  const int left = axis_->axisRect()->left() + shift;
  const int right = axis_->axisRect()->right() + shift;
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawLine(left, 0, right, 0);
  painter.setFont(numberFont());
  const QFontMetrics metrics(painter.font());
  const int base = kTickLength + 1 + metrics.ascent();
  const NumberedTicks ticks = ticksOf(*axis_, plot_.locale());
  int free = left - metrics.averageCharWidth() * 2;
  int end = right;
  for (qsizetype k = 0; k < ticks.places.size() && k < ticks.texts.size(); ++k) {
    const int x = static_cast<int>(axis_->coordToPixel(ticks.places[k])) + shift;
    if (x < left - 1 || x > right + 1) {
      continue;
    }
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawLine(x, 0, x, kTickLength);
    const int width = metrics.horizontalAdvance(ticks.texts[k]);
    if (x - width / 2 >= free && x + width / 2 <= this->width()) { // numbers never touch
      painter.setPen(palette().color(QPalette::WindowText));
      painter.drawText(x - width / 2, base, ticks.texts[k]);
      free = x + width / 2 + metrics.averageCharWidth();
      end = std::max(end, x + width / 2);
    }
  }
  if (nameShown_) {
    const QString name = kind_ == PlotAxis::Time
                             ? QCoreApplication::translate("PlotAxisStrip", "seconds")
                             : QCoreApplication::translate("PlotAxisStrip", "iteration");
    const int room = width() - end - kNameGap;
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(end + kNameGap, base, metrics.elidedText(name, Qt::ElideRight, room));
  }
}

} // namespace dewpoint::ui
