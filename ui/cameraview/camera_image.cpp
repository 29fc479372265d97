// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/camera_image.h"

#include "core/session/snapshot/snapshot.h"
#include "core/session/view/view_image.h"
#include "ui/style/image.h"

#include <algorithm>
#include <cstddef>

namespace dewpoint::ui {

namespace {

/// Light gray. What moves belongs to nobody yet: it has a color that is no identity's.
const cv::Scalar kMoving(228, 221, 213);

/// The color in which each target is drawn, where a mask has its number: 255 for the first target,
/// 254 for the second.
cv::Mat colorsOfTargets(const std::vector<QColor>& colors) {
  cv::Mat tints(1, 256, CV_8UC3, kMoving);
  for (int k = 0; k < std::min(255, static_cast<int>(colors.size())); ++k) {
    const QColor& tint = colors[static_cast<std::size_t>(k)];
    tints.at<cv::Vec3b>(255 - k) =
        cv::Vec3b(static_cast<uchar>(tint.blue()), static_cast<uchar>(tint.green()),
                  static_cast<uchar>(tint.red()));
  }
  return tints;
}

/// From so many device pixels on, a pixel of a zoomed image is drawn as a square.
constexpr int kSquareFrom = 4;

cv::Mat drawn(const CameraImageSource& source) {
  const cv::Rect part(source.imagePart.x(), source.imagePart.y(), source.imagePart.width(),
                      source.imagePart.height());
  const cv::Size size(source.size.width(), source.size.height());
  const bool isMasked = !source.mask.empty() && source.mask.size() == source.frame->image.size();
  const cv::Mat tints =
      colorsOfTargets(source.isMotionMask ? std::vector<QColor>() : source.maskColors);
  const cv::Mat image = source.frame->image(part);
  const cv::Mat tinted = isMasked ? tintedImage(image, source.mask(part), tints) : image;
  const bool squares = source.isZoomed && size.width >= kSquareFrom * part.width;
  cv::Mat picture = squares ? enlargedImage(tinted, size) : fittedImage(tinted, size);
  if (isMasked) {
    drawMaskOutline(picture, source.mask(part), tints);
  }
  return picture;
}

/// The map of a camera; null where there is none.
QImage mapImage(const std::vector<LikelihoodMap>& maps, int camera) {
  const auto index = static_cast<std::size_t>(camera);
  if (index >= maps.size() || maps[index].area.empty()) {
    return {};
  }
  const cv::Mat drawn = likelihoodImage(maps[index]);
  // ARGB32 lies in memory as blue, green, red, alpha on the machines we support (toQImage()).
  return QImage(drawn.data, drawn.cols, drawn.rows, static_cast<qsizetype>(drawn.step),
                QImage::Format_ARGB32)
      .copy();
}

} // namespace

bool CameraImageSource::operator==(const CameraImageSource& other) const {
  return camera == other.camera && frame == other.frame && mask.data == other.mask.data &&
         isMotionMask == other.isMotionMask && maskColors == other.maskColors &&
         imagePart == other.imagePart && size == other.size && isZoomed == other.isZoomed &&
         mapSnapshot == other.mapSnapshot;
}

CameraImage drawCameraImage(const CameraImageSource& source) {
  CameraImage picture{source, {}, {}, {}};
  const cv::Mat& image = source.frame->image;
  if (image.type() == CV_8UC3) {
    picture.image = toQImage(drawn(source));
  }
  if (source.mapSnapshot) {
    for (const TargetSnapshot& target : source.mapSnapshot->targets) {
      picture.likelihoodMaps.push_back(mapImage(target.maps, source.camera));
    }
    picture.motionMap = mapImage(source.mapSnapshot->motionMaps, source.camera);
  }
  return picture;
}

} // namespace dewpoint::ui
