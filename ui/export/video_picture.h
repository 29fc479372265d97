// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/cameraview/camera_picture.h"

#include <QImage>
#include <QRect>
#include <QSize>
#include <QString>

#include <optional>
#include <vector>

namespace dewpoint::ui {

/// View in an exported video.
struct VideoView {
  std::optional<int> camera; ///< index in the rig; empty for the bird's-eye view
  QString title;
  CameraLook look;     ///< for cameras
  double aspect = 1.0; ///< width / height
  int height = 480;    ///< pixels, as recorded; of the bird's-eye view, as large as the cameras
};

/// Composition of the images of an exported video.
struct VideoLook {
  std::vector<VideoView> views; ///< side by side in a grid; at least one
  QSize size;                   ///< pixels; even
  bool titlesShown = true;      ///< the title of each view in its corner
  bool stampShown = true;       ///< frame, time and recording at the lower edge
  QString recording;            ///< name of the recording or take
  QPalette palette;
};

/// Returns the size with even width and height in which the views have about the size in which they
/// were recorded. It is limited to 3840 x 2160.
QSize naturalVideoSize(const std::vector<VideoView>& views);

/// Returns the area of each view in the image: a grid in which the views cover as much as possible.
std::vector<QRect> videoAreas(const VideoLook& look);

/// Returns the text "take-003 · Frame 133 · 4.400 s". Frames are counted from 1, as everywhere in
/// the window.
QString videoStamp(const VideoLook& look, const TrackSnapshotPtr& snapshot);

/// Draws one image of a video. `scene` is the image of the bird's-eye view, which is enlarged if it
/// is smaller than its area; null if there is none. May be called from any thread.
QImage videoPicture(const VideoLook& look, const TrackSnapshotPtr& snapshot, const QImage& scene);

} // namespace dewpoint::ui
