// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/selection/selection.h"
#include "ui/style/target_colors.h"
#include "ui/style/theme.h"
#include "ui/timeline/timeline_painter.h"

#include <QImage>
#include <QPainter>
#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

constexpr QSize kTimelineSize(400, 120);

TEST(TimelineColors, BesideEachNameIsTheColorOfTheTarget) {
  TimelineModel model;
  model.targets = {QStringLiteral("green ball"), QStringLiteral("box")};
  model.colors = {{.learned = ColorRange{108.0, 132.0, 0.4, 0.6, 0.4, 0.6}}, {}};
  TimelineScale scale;
  scale.setExtent(0, 49);
  scale.setPixels(100.0, 300.0);
  const TimelineRows rows(kTimelineSize, 2, 0, 16.0, 100.0);
  for (const bool dark : {false, true}) {
    const QPalette palette = themePalette(dark);
    QImage picture(kTimelineSize, QImage::Format_RGB32);
    picture.fill(palette.color(QPalette::Window));
    QPainter painter(&picture);
    paintTimeline(painter, model, scale, rows, Selection(), -1, palette);
    painter.end();
    const auto colors = targetColors(model.colors, displayGround(palette));
    for (int k = 0; k < 2; ++k) {
      const QPoint chip(3, qRound(rows.ribbon(k).center().y()));
      EXPECT_EQ(picture.pixelColor(chip).rgb(), colors[static_cast<std::size_t>(k)].rgb()) << k;
    }
    EXPECT_GT(colors[0].green(), colors[0].red()); // as it was learned
  }
}

} // namespace
} // namespace dewpoint::tests
