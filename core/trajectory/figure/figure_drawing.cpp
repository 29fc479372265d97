// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/figure/figure_drawing.h"

#include "core/base/markup.h"
#include "core/base/overloaded.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>

namespace dewpoint::trajectory {
namespace {

constexpr double kFigureMargin = 24.0;
constexpr double kAxisSpace = 58.0; ///< for the numbers beside an axis
constexpr double kPanelsTop = 44.0;

/// Of Okabe and Ito, with the brightness of print: those of the window's figures.
constexpr std::array<std::string_view, 6> kInks{"#de7538", "#4b9dcb", "#29ad86",
                                                "#c786ac", "#c88a00", "#d1c639"};

Eigen::AlignedBox2d boxAt(double left, double top, double width, double height) {
  return {Eigen::Vector2d(left, top), Eigen::Vector2d(left + width, top + height)};
}

std::string figureNumber(double value) {
  return fmt::format("{:.5g}", std::abs(value) < 1e-9 ? 0.0 : value);
}

std::string axisName(const ExportTable& table, int axis) {
  constexpr std::array<char, 3> kAxisNames{'x', 'y', 'z'};
  return fmt::format("{} ({})", kAxisNames[static_cast<std::size_t>(axis)], table.unitName());
}

/// Draws a panel into a frame of the page.
class PanelDrawer {
public:
  PanelDrawer(const FigurePanel& panel, const Eigen::AlignedBox2d& frame, FigureDrawing& drawing)
      : panel_(panel), frame_(frame), items_(drawing.items) {}

  void drawAxes(const std::string& horizontalName, const std::string& verticalName,
                bool hasNumbersBelow) {
    using Align = FigureDrawing::Align;
    for (const double x : gridLineValues(panel_.horizontalRange)) {
      const Eigen::Vector2d foot = at({x, panel_.verticalRange.low});
      items_.emplace_back(FigureDrawing::GridLine{foot, {foot.x(), frame_.min().y()}});
      if (hasNumbersBelow) {
        label(boxAt(foot.x() - 40.0, foot.y() + 3.0, 80.0, 16.0), Align::Center, figureNumber(x));
      }
    }
    for (const double y : gridLineValues(panel_.verticalRange)) {
      const Eigen::Vector2d foot = at({panel_.horizontalRange.low, y});
      items_.emplace_back(FigureDrawing::GridLine{foot, {frame_.max().x(), foot.y()}});
      items_.emplace_back(FigureDrawing::Label{boxAt(foot.x() - 56.0, foot.y() - 8.0, 50.0, 16.0),
                                               Align::Right, true, figureNumber(y)});
    }
    items_.emplace_back(FigureDrawing::PlotFrame{frame_});
    const double width = frame_.sizes().x();
    if (hasNumbersBelow) {
      label(boxAt(frame_.min().x(), frame_.max().y() + 18.0, width, 18.0), Align::Center,
            horizontalName);
    }
    label(boxAt(frame_.min().x() + 6.0, frame_.min().y() + 3.0, width, 18.0), Align::Left,
          verticalName);
  }

  void drawCurves() {
    for (const FigureCurve& curve : panel_.curves) {
      items_.emplace_back(FigureDrawing::Curve{curve.target, frame_, placed(curve.path),
                                               placed(curve.uncertaintyBand)});
    }
  }

private:
  Eigen::Vector2d at(const Eigen::Vector2d& value) const {
    const AxisRange& across = panel_.horizontalRange;
    const AxisRange& up = panel_.verticalRange;
    return {frame_.min().x() + (value.x() - across.low) / across.size() * frame_.sizes().x(),
            frame_.max().y() - (value.y() - up.low) / up.size() * frame_.sizes().y()};
  }
  std::vector<Eigen::Vector2d> placed(const std::vector<Eigen::Vector2d>& values) const {
    std::vector<Eigen::Vector2d> points;
    points.reserve(values.size());
    std::ranges::transform(values, std::back_inserter(points),
                           [this](const Eigen::Vector2d& value) { return at(value); });
    return points;
  }
  void label(const Eigen::AlignedBox2d& box, FigureDrawing::Align align, const std::string& text) {
    items_.emplace_back(FigureDrawing::Label{box, align, false, text});
  }

  const FigurePanel& panel_;
  Eigen::AlignedBox2d frame_;
  std::vector<FigureDrawing::Item>& items_;
};

void drawLegend(const ExportTable& table, const Eigen::AlignedBox2d& square,
                FigureDrawing& drawing) {
  const double left = square.min().x();
  double top = square.max().y() + 54.0;
  for (std::size_t target = 0; target < table.targets.size(); ++target) {
    drawing.items.emplace_back(FigureDrawing::LegendKey{target, boxAt(left, top + 5.0, 14.0, 4.0)});
    drawing.items.emplace_back(
        FigureDrawing::Label{boxAt(left + 20.0, top - 2.0, square.sizes().x() - 20.0, 18.0),
                             FigureDrawing::Align::Left, true, table.targets[target]});
    top += 18.0;
  }
}

std::string pointsText(const std::vector<Eigen::Vector2d>& points) {
  std::string text;
  for (const Eigen::Vector2d& point : points) {
    text += fmt::format("{}{:.2f},{:.2f}", text.empty() ? "" : " ", point.x(), point.y());
  }
  return text;
}

std::string boxText(const Eigen::AlignedBox2d& box) {
  return fmt::format("x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\"", box.min().x(),
                     box.min().y(), box.sizes().x(), box.sizes().y());
}

std::string labelText(const FigureDrawing::Label& label) {
  using Align = FigureDrawing::Align;
  // From the top or the middle of a line to its baseline, as parts of the size of the font.
  constexpr double kAscent = 0.93;
  constexpr double kRise = 0.35;
  const double x = label.alignment == Align::Left    ? label.box.min().x()
                   : label.alignment == Align::Right ? label.box.max().x()
                                                     : label.box.center().x();
  const double y = label.isCentered ? label.box.center().y() + kRise * FigureDrawing::kFontSize
                                    : label.box.min().y() + kAscent * FigureDrawing::kFontSize;
  const char* anchor = label.alignment == Align::Left    ? "start"
                       : label.alignment == Align::Right ? "end"
                                                         : "middle";
  return fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                     htmlEscaped(label.text));
}

/// An SVG of its own clips what lies outside of it.
std::string curveText(const FigureDrawing::Curve& curve) {
  const std::string_view ink = kInks[curve.target % kInks.size()];
  const Eigen::AlignedBox2d& box = curve.clipRectangle;
  std::string text = fmt::format("<svg {} viewBox=\"{:.2f} {:.2f} {:.2f} {:.2f}\">\n", boxText(box),
                                 box.min().x(), box.min().y(), box.sizes().x(), box.sizes().y());
  if (!curve.uncertaintyBand.empty()) {
    text += fmt::format("<polygon points=\"{}\" fill=\"{}\" fill-opacity=\"0.2\"/>\n",
                        pointsText(curve.uncertaintyBand), ink);
  }
  text += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.4\" "
                      "stroke-linecap=\"round\" stroke-linejoin=\"round\"/>\n</svg>\n",
                      pointsText(curve.path), ink);
  return text;
}

} // namespace

std::string figureTitle(const std::vector<std::pair<std::string, std::string>>& entries) {
  std::string title;
  for (const auto& [key, value] : entries) {
    if ((key == "project" || key == "method") && !value.empty()) {
      title += (title.empty() ? "" : " · ") + value;
    }
  }
  return title;
}

FigureDrawing layOutFigure(const ExportTable& table, const FigureTexts& texts) {
  constexpr double kOverTimeWidth = 470.0;
  constexpr double kSquareLeft = 660.0;
  constexpr double kSquareSide = FigureDrawing::kWidth - kSquareLeft - kFigureMargin;
  constexpr double kPanelHeight = (FigureDrawing::kHeight - kPanelsTop - 60.0) / 3.0;
  FigureDrawing drawing;
  drawing.items.emplace_back(FigureDrawing::Label{
      boxAt(kFigureMargin, 12.0, FigureDrawing::kWidth - 2.0 * kFigureMargin, 20.0),
      FigureDrawing::Align::Left, false, texts.title});
  const TrajectoryFigure figure = computeTrajectoryFigure(table);
  for (std::size_t axis = 0; axis < figure.panelsOverTime.size(); ++axis) {
    const FigurePanel& panel = figure.panelsOverTime[axis];
    const double top = kPanelsTop + static_cast<double>(axis) * kPanelHeight;
    PanelDrawer drawer(panel,
                       boxAt(kFigureMargin + kAxisSpace, top, kOverTimeWidth, kPanelHeight - 10.0),
                       drawing);
    drawer.drawAxes(texts.timeAxisLabel, axisName(table, panel.verticalAxis),
                    axis + 1 == figure.panelsOverTime.size());
    drawer.drawCurves();
  }
  const Eigen::AlignedBox2d square = boxAt(kSquareLeft, kPanelsTop, kSquareSide, kSquareSide);
  PanelDrawer above(figure.topViewPanel, square, drawing);
  above.drawAxes(axisName(table, figure.topViewPanel.horizontalAxis),
                 texts.topViewTitle + ", " + axisName(table, figure.topViewPanel.verticalAxis),
                 true);
  above.drawCurves();
  drawLegend(table, square, drawing);
  return drawing;
}

std::string figureSvg(const FigureDrawing& drawing, const std::string& title) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\" font-size=\"{2}\" "
      "fill=\"#282828\">\n<title>{3}</title>\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
      FigureDrawing::kWidth, FigureDrawing::kHeight, FigureDrawing::kFontSize, htmlEscaped(title));
  for (const FigureDrawing::Item& item : drawing.items) {
    text += std::visit(
        Overloaded{[](const FigureDrawing::GridLine& line) {
                     return fmt::format("<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" "
                                        "y2=\"{:.2f}\" stroke=\"#dedede\" stroke-width=\"0.8\"/>\n",
                                        line.from.x(), line.from.y(), line.to.x(), line.to.y());
                   },
                   [](const FigureDrawing::PlotFrame& frame) {
                     return fmt::format("<rect {} fill=\"none\" stroke=\"#282828\"/>\n",
                                        boxText(frame.box));
                   },
                   [](const FigureDrawing::Label& label) { return labelText(label); },
                   [](const FigureDrawing::Curve& curve) { return curveText(curve); },
                   [](const FigureDrawing::LegendKey& key) {
                     return fmt::format("<rect {} fill=\"{}\"/>\n", boxText(key.box),
                                        kInks[key.target % kInks.size()]);
                   }},
        item);
  }
  return text + "</svg>\n";
}

} // namespace dewpoint::trajectory
