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

/// One view in the images of an exported video: a camera view or the bird's-eye view.
struct VideoView {
  std::optional<int> camera; ///< index in the rig; empty for the bird's-eye view
  QString title;
  CameraViewOptions options; ///< layers to draw, for camera views
  double aspect = 1.0;       ///< width / height
  int height = 480; ///< height of the recorded images in pixels; for the bird's-eye view, similar
                    ///< to the cameras
};

/// Composition of the images of an exported video.
struct VideoLayout {
  std::vector<VideoView> views; ///< side by side in a grid; at least one
  QSize size;                   ///< image size, pixels; width and height are even
  bool showsTitles = true;      ///< draws the title of each view in its corner
  bool showsStamp = true;       ///< draws frame, time and recording at the lower edge
  QString recordingName;        ///< name of the recording, drawn at the lower edge
  QPalette palette;
};

/// Returns the video size, in pixels, at which the views have about the size in which they were
/// recorded, limited to 3840 x 2160. Width and height are even.
QSize naturalVideoSize(const std::vector<VideoView>& views);

/// Returns the area of each view in the image: a grid in which the views cover as much as possible.
std::vector<QRect> videoViewAreas(const VideoLayout& look);

/// Returns the text at the lower edge of a video image, for example "take-003 · Frame 133 · 4.400
/// s". Frames are counted from 1, as everywhere in the window.
QString videoStampText(const VideoLayout& look, const TrackSnapshotPtr& snapshot);

/// Returns one image of a video. `scene` is the image of the bird's-eye view, which is enlarged if
/// it is smaller than its area; null if the video has no bird's-eye view. May be called from any
/// thread.
QImage videoPicture(const VideoLayout& look, const TrackSnapshotPtr& snapshot, const QImage& scene);

} // namespace dewpoint::ui
