// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plots/plot_axis_range.h"
#include "ui/plots/plot_declaration.h"
#include "ui/plots/plot_series.h"
#include "ui/selection/selection.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include <memory>
#include <optional>
#include <string>
#include <vector>

class QCustomPlot;

namespace dewpoint::ui {

class PlotCursor;
class PlotRow;
class PlotScroll;
struct PlotPicture;

/// Plots one above the other that share the axis of iterations or time, a cursor and a range. In
/// little room they are scrolled, above the numbers of the axis; without data there is a sentence.
/// Draws new data a few times per second at most, however often refresh() is called; unless a part
/// of the axis is chosen, the whole run is shown.
class PlotStack : public QWidget {
  Q_OBJECT
public:
  explicit PlotStack(QWidget* parent = nullptr);
  ~PlotStack() override;

  /// All plots there are; curves keep nothing of earlier ones.
  void setPlots(std::vector<PlotDeclaration> plots);
  /// Which of them are shown, by id; those without any number yet take no space.
  void setShown(const QStringList& ids);
  /// What is drawn; must outlive the stack, or be replaced.
  void setSeries(const PlotSeries* series);
  /// The series has changed: draws it soon.
  void refresh();
  /// The sentence shown as long as there are no data.
  void setEmptyText(const QString& sentence);
  /// Curves and axes alone, for a stack whose surroundings say what it shows.
  void setBare(bool bare);
  /// A run of fewer iterations than that grows into the axis.
  void setLeastIterations(int least) { range_.setLeastIterations(least); }
  void setAxis(PlotAxis axis);
  PlotAxis axis() const { return range_.axis(); }

  /// Shows the selected range, and selects what the user points at.
  void link(Selection& selection);
  /// The pointer's frame is shown in both.
  void shareCursor(PlotStack& other);
  /// The frame all views show; nothing: the newest.
  void setCurrentFrame(std::optional<std::int64_t> frame);
  /// The frame the pointer is on, here or in another view; nothing: nowhere.
  void setHovered(std::optional<std::int64_t> frame);
  void setSelectedRange(std::optional<SelectedRange> selectedRange);
  std::optional<SelectedRange> selectedRange() const { return selectedRange_; }
  /// The part of the axis that is shown.
  std::pair<double, double> shownRange() const;

  /// The whole run again.
  void showAll();
  /// Nearer by `factor` (above 1) about a position on the axis, or about the cursor.
  void zoom(double factor, std::optional<double> about = std::nullopt);
  /// By a share of the width shown.
  void pan(double share);
  /// This part of the axis.
  void showPart(double lower, double upper);
  bool showsAll() const { return range_.showsAll(); }

  /// Shown curves within the part shown, not thinned out for drawing: one line per row.
  std::string csv() const;
  /// The plots as a figure for paper: a drawing (SVG), or pixels.
  PlotPicture picture(bool asDrawing);
  /// All values at the cursor, with names and units.
  QString valuesText() const;
  /// "frame 132, iteration 660, 4.40 s"; empty before the first.
  QString cursorText() const;
  /// What the last drawing took, milliseconds.
  double lastDrawingMs() const { return lastDrawingMs_; }
  /// Whether no drawing is still to come of what was given last.
  bool isDrawn() const { return !timer_.isActive(); }
  /// Points of the curves as they are drawn.
  int drawnPoints() const;
  QStringList visiblePlots() const;
  /// Those of them whose plots are seen in full, without scrolling.
  QStringList plotsInSight() const;
  /// Whether dots are drawn on any curve.
  bool hasDots() const;

  QSize sizeHint() const override { return {700, 240}; }

Q_SIGNALS:
  /// The pointer (or the arrow keys) is on this frame; negative: it has left.
  void hovered(qint64 frame);
  void frameChosen(qint64 frame);
  void rangeChosen(qint64 first, qint64 last);
  void rangeCleared();
  void cursorMoved();
  void contextMenuWanted(const QPoint& global);

protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

private:
  friend class PlotPointer;
  void rebuild();
  void placeRows(const std::vector<const PlotDeclaration*>& wanted);
  void draw();
  void drawCursor();
  void applyPalette();
  std::vector<const PlotDeclaration*> wantedPlots() const;
  /// Row of the series that the values are of.
  std::optional<std::size_t> cursorRow() const;
  std::optional<std::int64_t> frameAt(int x) const;
  double keyAt(int x) const;

  QCustomPlot* plot_;
  PlotScroll* scroll_;
  PlotCursor* cursor_;
  bool bare_ = false;
  std::vector<PlotDeclaration> plots_;
  QStringList shown_;
  std::vector<std::unique_ptr<PlotRow>> rows_;
  const PlotSeries* series_ = nullptr;
  PlotAxisRange range_;
  std::optional<std::int64_t> currentFrame_;
  std::optional<std::int64_t> hovered_;
  std::optional<SelectedRange> selectedRange_;
  QTimer timer_;
  QElapsedTimer sinceDrawing_;
  double lastDrawingMs_ = 0.0;
};

} // namespace dewpoint::ui
