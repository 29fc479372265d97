// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plots/plot_declaration.h"
#include "ui/plots/plot_navigation.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

namespace dewpoint::ui {

class PlotCanvas;
class PlotCursor;
class PlotExport;
class PlotPointer;
class PlotRow;
class PlotScroll;

/// Stack of plots that share an axis of iterations or time, a cursor and a range. If there is not
/// enough room, the plots scroll above the axis numbers, and a whole number of them is visible.
/// While there are no data, a sentence is shown. New data are drawn at most a few times per second,
/// no matter how often `refresh()` is called. The whole run is shown unless part of the axis is
/// selected.
class PlotStack : public QWidget {
  Q_OBJECT
public:
  explicit PlotStack(QWidget* parent = nullptr);
  ~PlotStack() override;

  /// Sets all plots. Data of earlier plots are discarded.
  void setPlots(std::vector<PlotDeclaration> plots);
  /// Sets which plots are shown, by id. Plots without data take up no space.
  void setShownPlots(const QStringList& ids);
  /// Sets the data to draw. The series must outlive the stack or be replaced.
  void setSeries(const PlotSeries* series);
  /// Schedules a redraw because the series has changed.
  void refresh();
  /// Sets the sentence shown while there are no data.
  void setEmptyText(const QString& sentence);
  /// Sets whether only curves and axes are shown, without titles and readouts.
  void setCurvesOnly(bool bare);
  /// Sets the minimum length of the axis in iterations. A shorter run fills the axis gradually.
  void setMinIterations(int least) { navigation_->setMinIterations(least); }
  void setAxis(PlotAxis axis);
  PlotAxis axis() const { return navigation_->axis(); }

  /// Connects the stack with the selection shared by all views: shows the selected range, and
  /// changes the selection when the user selects a frame or a range in the plots.
  void connectSelection(Selection& selection);
  /// Connects the cursors of two stacks: the frame under the pointer in one is also marked in the
  /// other.
  void shareCursor(PlotStack& other);
  /// Sets the frame that all views show; empty: the newest frame.
  void setCurrentFrame(std::optional<std::int64_t> frame) { navigation_->setCurrentFrame(frame); }
  /// Sets the frame under the pointer, in these plots or in another view; empty if there is none.
  void setHoveredFrame(std::optional<std::int64_t> frame) { navigation_->setHoveredFrame(frame); }
  std::optional<SelectedRange> selectedRange() const { return navigation_->selectedRange(); }
  /// Returns the visible part of the axis.
  std::pair<double, double> shownRange() const { return navigation_->shownRange(); }
  /// Shows the whole run again.
  void showWholeRun() { navigation_->showWholeRun(); }
  /// Shows this part of the axis.
  void showRange(double lower, double upper) { navigation_->showRange(lower, upper); }
  bool showsWholeRun() const { return navigation_->showsWholeRun(); }

  /// Returns an object that exports the plots as currently shown, for use in other programs.
  PlotExport plotExport();
  /// Returns all values at the cursor, with names and units.
  QString valuesText() const;
  /// Returns the position of the cursor as text: "frame 132, 4.40 s", or "frame 132, iteration 660,
  /// 4.40 s" if the axis counts iterations. Empty before the first frame.
  QString cursorText() const { return placeText(navigation_->cursorRow()); }
  /// Returns the frame that all views show as text, for example "frame 132, 4.40 s".
  QString shownFrameText() const { return placeText(navigation_->shownRow()); }
  /// Returns the duration of the last redraw in milliseconds.
  double lastDrawingMs() const { return lastDrawingMs_; }
  /// Returns whether the newest data and settings are drawn.
  bool isDrawn() const { return !timer_.isActive(); }
  /// Returns the number of points in the drawn curves.
  int drawnPointCount() const;
  QStringList visiblePlots() const;
  /// Returns the plots that are fully visible without scrolling.
  QStringList fullyVisiblePlots() const;
  /// Returns the plots that are only partly visible without scrolling.
  QStringList partlyVisiblePlots() const;
  /// Returns whether any curve shows dots.
  bool hasDots() const;

  QSize sizeHint() const override { return {700, 240}; }

Q_SIGNALS:
  /// Emitted when the pointer, or the cursor moved by arrow keys, reaches this frame. A negative
  /// number means that it is on no frame.
  void frameHovered(qint64 frame);
  void cursorMoved();
  void contextMenuRequested(const QPoint& global);

protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

private:
  void rebuild();
  void arrangeRows(const std::vector<const PlotDeclaration*>& wanted);
  /// Sets the heights of the plots so that a whole number of them is visible.
  void fitRows();
  void draw();
  void drawCursor();
  /// Sets the cursor and the values beside the plots, without a redraw.
  void placeCursor();
  /// Shows the frame and the values at the cursor in a label at the pointer, or hides the label.
  /// Without a pointer, the cursor is moved by keys, and the label contains all plots.
  void showLabel(const std::optional<QPoint>& pointer);
  QString placeText(const std::optional<std::size_t>& row) const;
  void applyPalette();
  std::vector<const PlotDeclaration*> plotsToShow() const;
  const PlotSeries* series() const { return navigation_->series(); }

  PlotCanvas* plot_;
  PlotScroll* scroll_;
  PlotCursor* cursor_;
  PlotNavigation* navigation_;
  PlotPointer* pointer_;
  bool curvesOnly_ = false;
  std::vector<PlotDeclaration> plots_;
  QStringList shown_;
  std::vector<std::unique_ptr<PlotRow>> rows_;
  QTimer timer_;
  QElapsedTimer sinceDrawing_;
  int fittedHeight_ = -1; ///< visible height that the rows fit, pixels
  double lastDrawingMs_ = 0.0;
};

} // namespace dewpoint::ui
