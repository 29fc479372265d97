// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QImage>
#include <QRect>
#include <QSize>
#include <opencv2/core/mat.hpp>

#include <memory>
#include <vector>

namespace dewpoint::capture {
struct Frame;
} // namespace dewpoint::capture
namespace dewpoint::session {
struct TrackSnapshot;
} // namespace dewpoint::session

namespace dewpoint::ui {

using FramePtr = std::shared_ptr<const Frame>;
using TrackSnapshotPtr = std::shared_ptr<const TrackSnapshot>;

/// What the pixels in a camera view are made of; all of it is kept alive here, so that the address
/// of something freed is never taken for that of the next one.
struct PictureSource {
  int camera = 0;
  FramePtr frame;          ///< null: there is no picture
  cv::Mat mask;            ///< as TrackSnapshot::masks; of another size than the image: none
  bool isOfMotion = false; ///< the mask shows what moves, not targets
  QRect part;              ///< of the image, what is drawn of it, pixels
  QSize size;              ///< of that part, device pixels
  bool isZoomed = false;   ///< pixels that are large enough are drawn as squares
  TrackSnapshotPtr maps;   ///< whose likelihood maps are drawn; null: none are

  bool operator==(const PictureSource& other) const;
};

/// The pixels of a camera view.
struct CameraPicture {
  PictureSource source;
  QImage image;
  std::vector<QImage> maps; ///< per target; null where it has no map
  QImage motionMap;         ///< of the whole image; null where there is none
};

/// Draws a picture, which takes long for large images. Any thread.
CameraPicture drawPicture(const PictureSource& source);

} // namespace dewpoint::ui
