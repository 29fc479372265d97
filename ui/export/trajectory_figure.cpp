// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/trajectory_figure.h"

#include "core/base/text_file.h"
#include "ui/style/theme.h"

#include <QBuffer>
#include <QPageSize>
#include <QPainter>
#include <QPainterPath>
#include <QPdfWriter>
#include <QSvgGenerator>

#include <algorithm>
#include <cmath>
#include <vector>

namespace dewpoint::ui {

namespace {

constexpr double kWidth = 1000.0; ///< of the page in the units drawn with; A4 is 1.414 : 1
constexpr double kHeight = 707.0;
constexpr double kMargin = 24.0;
constexpr double kAxisSpace = 58.0; ///< for the numbers beside an axis
constexpr double kBandSigmas = 2.0;
const QColor kInk(40, 40, 40);
const QColor kGrid(222, 222, 222);

/// A stretch of an axis.
struct Range {
  double low = INFINITY;
  double high = -INFINITY;

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double size() const { return high - low; }
  /// A little wider, and never without size.
  Range padded() const {
    const double more = size() > 0.0 ? 0.05 * size() : 0.5;
    return low <= high ? Range{low - more, high + more} : Range{0.0, 1.0};
  }
};

/// Distance of the lines of a grid: 1, 2 or 5 times a power of ten, about five of them.
double gridStep(double size) {
  const double rough = size / 5.0;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double share = rough / power;
  return power * (share < 1.5 ? 1.0 : share < 3.5 ? 2.0 : share < 7.5 ? 5.0 : 10.0);
}

/// A frame with axes, into which curves are drawn.
class Panel {
public:
  Panel(QPainter& painter, QRectF frame, Range horizontal, Range vertical)
      : painter_(painter), frame_(frame), horizontal_(horizontal), vertical_(vertical) {}

  QPointF at(double x, double y) const {
    return {frame_.left() + (x - horizontal_.low) / horizontal_.size() * frame_.width(),
            frame_.bottom() - (y - vertical_.low) / vertical_.size() * frame_.height()};
  }

  void drawAxes(const QString& horizontalName, const QString& verticalName, bool numbersBelow) {
    for (double x = first(horizontal_); x <= horizontal_.high; x += gridStep(horizontal_.size())) {
      const QPointF foot = at(x, vertical_.low);
      line(foot, {foot.x(), frame_.top()}, kGrid);
      if (numbersBelow) {
        text(QRectF(foot.x() - 40, foot.y() + 3, 80, 16), Qt::AlignHCenter, number(x));
      }
    }
    for (double y = first(vertical_); y <= vertical_.high; y += gridStep(vertical_.size())) {
      const QPointF foot = at(horizontal_.low, y);
      line(foot, {frame_.right(), foot.y()}, kGrid);
      text(QRectF(foot.x() - 56, foot.y() - 8, 50, 16), Qt::AlignRight | Qt::AlignVCenter,
           number(y));
    }
    painter_.setPen(QPen(kInk, 1.0));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawRect(frame_);
    if (numbersBelow) {
      text(QRectF(frame_.left(), frame_.bottom() + 18, frame_.width(), 18), Qt::AlignHCenter,
           horizontalName);
    }
    text(QRectF(frame_.left() + 6, frame_.top() + 3, frame_.width(), 18), Qt::AlignLeft,
         verticalName);
  }

  void drawCurve(const QPainterPath& path, const QColor& color) {
    painter_.save();
    painter_.setClipRect(frame_);
    painter_.setBrush(Qt::NoBrush);
    painter_.setPen(QPen(color, 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter_.drawPath(path);
    painter_.restore();
  }
  void drawBand(const QPolygonF& band, QColor color) {
    color.setAlphaF(0.2F);
    painter_.save();
    painter_.setClipRect(frame_);
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(color);
    painter_.drawPolygon(band);
    painter_.restore();
  }
  const QRectF& frame() const { return frame_; }

private:
  static double first(const Range& range) {
    const double step = gridStep(range.size());
    return std::ceil(range.low / step) * step;
  }
  static QString number(double value) {
    return QString::number(std::abs(value) < 1e-9 ? 0.0 : value, 'g', 5);
  }
  void line(QPointF from, QPointF to, const QColor& color) {
    painter_.setPen(QPen(color, 0.8));
    painter_.drawLine(from, to);
  }
  void text(const QRectF& box, int flags, const QString& words) {
    painter_.setPen(kInk);
    painter_.drawText(box, flags | Qt::TextDontClip, words);
  }

  QPainter& painter_;
  QRectF frame_;
  Range horizontal_;
  Range vertical_;
};

/// The dark twin of a target's color, which reads on white.
QColor inkOf(const ExportTable& table, std::size_t target) {
  return targetColor(table.targets[target], static_cast<int>(target)).darker(115);
}

double sigmaOf(const ExportCell& cell, int axis) {
  return cell.covariance ? std::sqrt(std::max(0.0, (*cell.covariance)(axis, axis))) : 0.0;
}

/// Calls `stretch(begin, end)` for each run of rows without a gap.
template <class Stretch> void forStretches(const std::vector<ExportCell>& cells, Stretch stretch) {
  for (std::size_t begin = 0; begin < cells.size();) {
    std::size_t end = begin;
    while (end < cells.size() && cells[end].present) {
      ++end;
    }
    if (end > begin) {
      stretch(begin, end);
    }
    begin = end + 1;
  }
}

void drawOverTime(Panel& panel, const ExportTable& table, int axis) {
  for (std::size_t target = 0; target < table.targets.size(); ++target) {
    const auto& cells = table.cells[target];
    forStretches(cells, [&](std::size_t begin, std::size_t end) {
      QPainterPath path(panel.at(table.times[begin], cells[begin].position[axis]));
      QPolygonF upper;
      QPolygonF lower;
      for (std::size_t row = begin; row < end; ++row) {
        const double value = cells[row].position[axis];
        const double off = kBandSigmas * sigmaOf(cells[row], axis);
        path.lineTo(panel.at(table.times[row], value));
        upper << panel.at(table.times[row], value + off);
        lower.prepend(panel.at(table.times[row], value - off));
      }
      panel.drawBand(upper + lower, inkOf(table, target));
      panel.drawCurve(path, inkOf(table, target));
    });
  }
}

/// The two axes that lie on the floor.
std::pair<int, int> floorAxes(const ExportTable& table) {
  return table.axes == WorldAxes::ZUp ? std::pair(0, 1) : std::pair(2, 0);
}

void drawFromAbove(Panel& panel, const ExportTable& table) {
  const auto [first, second] = floorAxes(table);
  for (std::size_t target = 0; target < table.targets.size(); ++target) {
    const auto& cells = table.cells[target];
    forStretches(cells, [&](std::size_t begin, std::size_t end) {
      const auto place = [&, a = first, b = second](std::size_t row) {
        return panel.at(cells[row].position[a], cells[row].position[b]);
      };
      QPainterPath path(place(begin));
      for (std::size_t row = begin; row < end; ++row) {
        path.lineTo(place(row));
      }
      panel.drawCurve(path, inkOf(table, target));
    });
  }
}

Range rangeOf(const ExportTable& table, int axis) {
  Range range;
  for (const auto& column : table.cells) {
    for (const ExportCell& cell : column) {
      if (cell.present) {
        range.include(cell.position[axis]);
      }
    }
  }
  return range.padded();
}

/// Both directions in the same scale.
std::pair<Range, Range> withEqualScale(Range horizontal, Range vertical, const QRectF& frame) {
  const double scale =
      std::max(horizontal.size() / frame.width(), vertical.size() / frame.height());
  const auto widened = [scale](const Range& range, double length) {
    const double middle = 0.5 * (range.low + range.high);
    return Range{middle - 0.5 * scale * length, middle + 0.5 * scale * length};
  };
  return {widened(horizontal, frame.width()), widened(vertical, frame.height())};
}

void drawLegend(QPainter& painter, const ExportTable& table, QRectF place) {
  for (std::size_t target = 0; target < table.targets.size(); ++target) {
    painter.fillRect(QRectF(place.left(), place.top() + 5, 14, 4), inkOf(table, target));
    painter.setPen(kInk);
    painter.drawText(QRectF(place.left() + 20, place.top() - 2, place.width() - 20, 18),
                     Qt::AlignLeft | Qt::AlignVCenter,
                     QString::fromStdString(table.targets[target]));
    place.translate(0, 18);
  }
}

constexpr const char* kAxisNames[] = {"x", "y", "z"};

QString axisName(const ExportTable& table, int axis) {
  return QStringLiteral("%1 (%2)").arg(QLatin1String(kAxisNames[axis]),
                                       QLatin1String(table.unitName()));
}

} // namespace

void drawTrajectoryFigure(QPainter& painter, const QRectF& page, const ExportTable& table,
                          const FigureWords& words) {
  painter.save();
  painter.translate(page.topLeft());
  const double scale = std::min(page.width() / kWidth, page.height() / kHeight);
  painter.scale(scale, scale);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(QRectF(0, 0, kWidth, kHeight), Qt::white);
  QFont font(QStringLiteral("sans-serif"));
  font.setPixelSize(13);
  painter.setFont(font);
  painter.setPen(kInk);
  painter.drawText(QRectF(kMargin, 12, kWidth - 2 * kMargin, 20), Qt::AlignLeft, words.title);

  Range time;
  for (const double t : table.times) {
    time.include(t);
  }
  time = time.padded();
  const double top = 44.0;
  const double height = (kHeight - top - 60.0) / 3.0;
  for (int axis = 0; axis < 3; ++axis) {
    Panel panel(painter, QRectF(kMargin + kAxisSpace, top + axis * height, 470.0, height - 10.0),
                time, rangeOf(table, axis));
    panel.drawAxes(words.time, axisName(table, axis), axis == 2);
    drawOverTime(panel, table, axis);
  }
  const QRectF square(660.0, top, kWidth - 660.0 - kMargin, kWidth - 660.0 - kMargin);
  const auto [first, second] = floorAxes(table);
  const auto [across, along] =
      withEqualScale(rangeOf(table, first), rangeOf(table, second), square);
  Panel above(painter, square, across, along);
  above.drawAxes(axisName(table, first),
                 words.topView + QStringLiteral(", ") + axisName(table, second), true);
  drawFromAbove(above, table);
  drawLegend(painter, table, QRectF(square.left(), square.bottom() + 54.0, square.width(), 18.0));
  painter.restore();
}

Status writeTrajectoryFigure(const ExportTable& table, const FigureWords& words,
                             const std::filesystem::path& file) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  const QRectF page(0, 0, kWidth, kHeight);
  if (file.extension() == ".pdf") {
    QPdfWriter device(&buffer);
    device.setPageLayout(QPageLayout(QPageSize(QPageSize::A4), QPageLayout::Landscape, {}));
    device.setTitle(words.title);
    QPainter painter(&device);
    drawTrajectoryFigure(painter, QRectF(0, 0, device.width(), device.height()), table, words);
  } else {
    QSvgGenerator device;
    device.setOutputDevice(&buffer);
    device.setSize(page.size().toSize());
    device.setViewBox(page);
    device.setTitle(words.title);
    QPainter painter(&device);
    drawTrajectoryFigure(painter, page, table, words);
  }
  return writeTextFile(file, buffer.data().toStdString());
}

} // namespace dewpoint::ui
