// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/histogram_view.h"

#include "ui/text/retranslation.h"

#include <QPainter>

#include <algorithm>

namespace dewpoint::ui {

namespace {

constexpr std::size_t kMostBars = 16; ///< pairs that can be told apart in a panel's width
constexpr double kPairGap = 0.2;      ///< between two pairs, of a pair's width
constexpr double kBarMargin = 2.0;    ///< pixels above and below

} // namespace

HistogramView::HistogramView(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("targetHistograms"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  onRetranslate(this, [this] {
    setAccessibleName(tr("Colors of the box"));
    setToolTip(
        tr("Color histograms of the bounding box: outlined bars for the reference, filled bars for "
           "the current frame. The largest of the 512 bins are shown, each in its own color."));
  });
}

void HistogramView::setHistograms(const std::shared_ptr<const ColorHistograms>& histograms) {
  bars_ = histograms ? largestBars(*histograms, kMostBars) : std::vector<ColorBar>();
  update();
}

void HistogramView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  double highest = 0.0;
  for (const ColorBar& bar : bars_) {
    highest = std::max({highest, bar.referenceShare, bar.candidateShare});
  }
  if (highest <= 0.0) {
    return;
  }
  const double pair = width() / static_cast<double>(bars_.size());
  const double one = 0.5 * (1.0 - kPairGap) * pair;
  const double room = height() - 2.0 * kBarMargin;
  const auto place = [&](std::size_t index, int side, double share) {
    const double tall = room * share / highest;
    return QRectF(pair * static_cast<double>(index) + 0.5 * kPairGap * pair + one * side,
                  kBarMargin + room - tall, one, tall);
  };
  for (std::size_t k = 0; k < bars_.size(); ++k) {
    const ColorBar& bar = bars_[k];
    const QColor color(bar.rgb[0], bar.rgb[1], bar.rgb[2]);
    painter.setPen(QPen(palette().color(QPalette::WindowText), 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(place(k, 0, bar.referenceShare));
    painter.setBrush(color);
    painter.drawRect(place(k, 1, bar.candidateShare));
    painter.fillRect(place(k, 0, bar.referenceShare)
                         .adjusted(2.0, 2.0, -2.0, 0.0)
                         .intersected(QRectF(0.0, height() - kBarMargin - 3.0, width(), 3.0)),
                     color); // which color the hollow bar stands for
  }
}

} // namespace dewpoint::ui
