// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameras/exposure_bars.h"

#include "ui/text/retranslation.h"

#include <QPainter>

#include <algorithm>

namespace dewpoint::ui {

namespace {

constexpr QSize kBarsSize(220, 44); ///< pixels; chosen: bars of 6 pixels, as tall as two lines
constexpr double kBarGap = 1.0;     ///< pixels
constexpr int kDarkBins = TargetExposure::kMinUsefulBrightness *
                          static_cast<int>(TargetExposure::kBinCount) / 256; ///< wholly too dark

} // namespace

ExposureBars::ExposureBars(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("exposureBars"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  onRetranslate(this, [this] {
    setAccessibleName(tr("Brightness of the target's pixels"));
    setToolTip(tr("Brightness of the target's pixels, from black on the left to white on the "
                  "right. The highlighted bars at the two ends count pixels that are too dark or "
                  "overexposed: these pixels have lost their color."));
  });
}

void ExposureBars::setExposure(const TargetExposure& exposure) {
  if (exposure != exposure_) {
    exposure_ = exposure;
    update();
  }
}

QSize ExposureBars::sizeHint() const {
  return kBarsSize;
}

void ExposureBars::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QColor plain = palette().color(QPalette::Mid);
  const QColor strong = palette().color(QPalette::WindowText);
  const double base = height() - 1.0;
  painter.fillRect(QRectF(0.0, base, width(), 1.0), plain);
  const auto most = std::ranges::max(exposure_.histogram);
  if (most <= 0) {
    return;
  }
  const double bar = width() / static_cast<double>(TargetExposure::kBinCount);
  const auto fill = [&](int bin, std::int64_t count, const QColor& color) {
    const double tall = (base - 1.0) * static_cast<double>(count) / static_cast<double>(most);
    painter.fillRect(QRectF(bar * bin, base - tall, bar - kBarGap, tall), color);
  };
  for (int bin = 0; bin < static_cast<int>(TargetExposure::kBinCount); ++bin) {
    const std::int64_t count = exposure_.histogram[static_cast<std::size_t>(bin)];
    fill(bin, count, bin < kDarkBins ? strong : plain);
  }
  fill(static_cast<int>(TargetExposure::kBinCount) - 1, exposure_.clippedCount, strong);
}

} // namespace dewpoint::ui
