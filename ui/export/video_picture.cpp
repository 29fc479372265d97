// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/video_picture.h"

#include "core/session/snapshot/snapshot.h"
#include "ui/text/quantity_text.h"
#include "ui/workbench/image_grid.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace dewpoint::ui {

namespace {

constexpr QSize kLargestVideo(3840, 2160); ///< pixels
constexpr double kLabelMargin = 8.0;       ///< pixels between a label and the edge of its area

ImageGrid gridOf(const std::vector<VideoView>& views, const QSize& size) {
  std::vector<double> aspects;
  aspects.reserve(views.size());
  for (const VideoView& view : views) {
    aspects.push_back(view.aspect);
  }
  return bestImageGrid(aspects, size, 0.0);
}

int toEven(double length) {
  return std::max(2, 2 * static_cast<int>(std::lround(length / 2.0)));
}

/// A label that is readable on any image.
void paintLabel(QPainter& painter, const QRectF& area, Qt::Alignment edge, const QString& text) {
  const QFontMetricsF metrics(painter.font());
  const double most = area.width() - 2.0 * kLabelMargin;
  const double width = std::min(most, metrics.horizontalAdvance(text) + 14.0);
  const QSizeF size(width, metrics.height() + 6.0);
  const double top = edge.testFlag(Qt::AlignBottom) ? area.bottom() - kLabelMargin - size.height()
                                                    : area.top() + kLabelMargin;
  const QRectF place(QPointF(area.left() + kLabelMargin, top), size);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0, 0, 0, 160));
  painter.drawRoundedRect(place, 4.0, 4.0);
  painter.setPen(Qt::white);
  painter.drawText(place.adjusted(7.0, 0.0, -7.0, 0.0), Qt::AlignLeft | Qt::AlignVCenter,
                   metrics.elidedText(text, Qt::ElideRight, place.width() - 14.0));
}

} // namespace

QSize naturalVideoSize(const std::vector<VideoView>& views) {
  // As many columns as a wide screen suits.
  constexpr QSize kScreen(1920, 1080);
  const ImageGrid grid = gridOf(views, kScreen);
  const auto columns = static_cast<std::size_t>(grid.columnCount);
  double width = 0.0;
  double height = 0.0;
  for (std::size_t column = 0; column < columns; ++column) {
    double widest = 0.0;
    double rows = 0.0;
    for (std::size_t k = column; k < views.size(); k += columns) {
      widest = std::max(widest, views[k].aspect * views[k].height);
      rows += views[k].height;
    }
    width += widest;
    height = std::max(height, rows);
  }
  const double shrink =
      std::min({1.0, kLargestVideo.width() / width, kLargestVideo.height() / height});
  return {toEven(width * shrink), toEven(height * shrink)};
}

std::vector<QRect> videoViewAreas(const VideoLayout& look) {
  const ImageGrid grid = gridOf(look.views, look.size);
  const auto columns = static_cast<std::size_t>(grid.columnCount);
  std::vector<QRect> areas(look.views.size());
  double left = 0.0;
  for (std::size_t column = 0; column < columns; ++column) {
    const double right = left + grid.columnWidthShares[column] * look.size.width();
    double top = 0.0;
    for (std::size_t k = column; k < areas.size(); k += columns) {
      const double bottom = top + grid.viewHeightShares[k] * look.size.height();
      areas[k] =
          QRect(QPoint(qRound(left), qRound(top)), QPoint(qRound(right) - 1, qRound(bottom) - 1));
      top = bottom;
    }
    left = right;
  }
  return areas;
}

QString videoStampText(const VideoLayout& look, const TrackSnapshotPtr& snapshot) {
  const QString frame =
      QCoreApplication::translate("VideoDialog", "Frame %1").arg(frameNumberText(snapshot->frame));
  const QString time =
      snapshot->frames ? secondsText(seconds(snapshot->frames->time), 3) : QString();
  QStringList parts{look.recordingName, frame, time};
  parts.removeAll(QString());
  return parts.join(QStringLiteral(" · "));
}

QImage videoPicture(const VideoLayout& look, const TrackSnapshotPtr& snapshot,
                    const QImage& scene) {
  QImage picture(look.size, QImage::Format_RGB32);
  picture.fill(imageBackgroundColor(look.palette));
  QPainter painter(&picture);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  const std::vector<QRect> areas = videoViewAreas(look);
  for (std::size_t k = 0; k < look.views.size(); ++k) {
    const VideoView& view = look.views[k];
    if (view.camera) {
      painter.drawImage(areas[k].topLeft(),
                        cameraPicture(snapshot, *view.camera, view.options, areas[k].size()));
    } else if (!scene.isNull()) {
      painter.drawImage(areas[k], scene);
    }
    if (look.showsTitles) {
      paintLabel(painter, areas[k], Qt::AlignTop, view.title);
    }
  }
  if (look.showsStamp) {
    paintLabel(painter, picture.rect(), Qt::AlignBottom, videoStampText(look, snapshot));
  }
  return picture;
}

} // namespace dewpoint::ui
