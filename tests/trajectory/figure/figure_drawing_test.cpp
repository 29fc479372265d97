// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/figure/figure_drawing.h"

#include <gtest/gtest.h>

#include <set>

namespace dewpoint::tests {
namespace {

/// One target from (0, 0, 1) to (2, 4, 1) within 1 s.
ExportTable tableOfOneTarget() {
  ExportTable table;
  table.targets = {"red & blue"};
  table.cells.resize(1);
  for (int row = 0; row < 3; ++row) {
    table.times.push_back(0.5 * row);
    ExportCell& cell = table.cells[0].emplace_back();
    cell.hasPosition = true;
    cell.position = Eigen::Vector3d(row, 2.0 * row, 1.0);
    cell.covariance = Eigen::Vector3d(0.01, 0.01, 0.01).asDiagonal();
  }
  return table;
}

template <class T> std::vector<T> itemsOf(const FigureDrawing& drawing) {
  std::vector<T> found;
  for (const FigureDrawing::Item& item : drawing.items) {
    if (const T* one = std::get_if<T>(&item)) {
      found.push_back(*one);
    }
  }
  return found;
}

TEST(FigureDrawing, HasFourPanelsAndALegendOnThePage) {
  const FigureDrawing drawing =
      layOutFigure(tableOfOneTarget(), {"title", "time (s)", "from above"});
  EXPECT_EQ(itemsOf<FigureDrawing::PlotFrame>(drawing).size(), 4U);
  EXPECT_EQ(itemsOf<FigureDrawing::LegendKey>(drawing).size(), 1U);
  const Eigen::AlignedBox2d page(Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(1000.0, 707.0));
  std::set<std::string> texts;
  for (const auto& label : itemsOf<FigureDrawing::Label>(drawing)) {
    EXPECT_TRUE(page.contains(label.box.center())) << label.text;
    texts.insert(label.text);
  }
  for (const char* text :
       {"title", "time (s)", "x (m)", "z (m)", "from above, y (m)", "0.5", "1", "red & blue"}) {
    EXPECT_TRUE(texts.contains(text)) << text;
  }
}

TEST(FigureDrawing, CurvesLieInTheirFrames) {
  const FigureDrawing drawing = layOutFigure(tableOfOneTarget(), {});
  const auto curves = itemsOf<FigureDrawing::Curve>(drawing);
  ASSERT_EQ(curves.size(), 4U);
  // Over time x goes from 0 to 2: up by 2 of 2.2, the range with its margins.
  const FigureDrawing::Curve& x = curves[0];
  ASSERT_EQ(x.path.size(), 3U);
  EXPECT_EQ(x.uncertaintyBand.size(), 6U);
  const Eigen::Vector2d moved = x.path.back() - x.path.front();
  EXPECT_NEAR(moved.x(), x.clipRectangle.sizes().x() / 1.1, 1e-9);
  EXPECT_NEAR(moved.y(), -x.clipRectangle.sizes().y() * 2.0 / 2.2, 1e-9);
  // From above a meter is as long along x as along y.
  const Eigen::Vector2d walked = curves[3].path.back() - curves[3].path.front();
  EXPECT_NEAR(-walked.y(), 2.0 * walked.x(), 1e-9);
  EXPECT_TRUE(curves[3].uncertaintyBand.empty());
}

TEST(FigureDrawing, IsWrittenAsSvg) {
  const FigureDrawing drawing =
      layOutFigure(tableOfOneTarget(), {"title", "time (s)", "from above"});
  const std::string svg = figureSvg(drawing, "title");
  EXPECT_TRUE(svg.starts_with("<?xml"));
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  EXPECT_NE(svg.find("viewBox=\"0 0 1000 707\""), std::string::npos);
  EXPECT_NE(svg.find("red &amp; blue"), std::string::npos);
  EXPECT_NE(svg.find("<title>title</title>"), std::string::npos);
  EXPECT_EQ(svg, figureSvg(drawing, "title"));
}

TEST(FigureDrawing, TitlesNameProjectAndMethod) {
  EXPECT_EQ(figureTitle({{"version", "1"}, {"project", "hall"}, {"method", "dewpoint"}}),
            "hall · dewpoint");
  EXPECT_EQ(figureTitle({{"project", ""}, {"method", "people"}}), "people");
  EXPECT_EQ(figureTitle({}), "");
}

} // namespace
} // namespace dewpoint::tests
