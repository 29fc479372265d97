// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/image_box.h"

#include <opencv2/core/mat.hpp>

#include <optional>

namespace dewpoint::observation {

/// Returns the bounding box of the object that was clicked in an image (CV_8UC3). `pixel` must lie
/// in the image.
///
/// The size of the object is not known. The function therefore tries boxes around the click: from 7
/// pixels to 0.7 of the image's smaller side, and from three times as high as wide to three times
/// as wide as high. Each is tried in an image reduced so that the box has about 20 pixels;
/// highlights, seams and noise then average out. The function takes the box that differs most from
/// its surroundings (FigureContrast), with a penalty that grows with the distance of the click from
/// the center of the box. The result is then the figure in it (figureBox()), or the box of the
/// color region at the click (growRegion()) if that is about the same, because its outline is more
/// exact when it is right.
///
/// If it is not, the box may hold more than can be followed. Of the figures of all sizes up to it,
/// the function takes the largest whose colors, as TargetColors would learn them, distinguish it
/// from its surroundings nearly as well as those of the best figure. It contains the region if that
/// is part of the object, or is the region. For an object of several colors, the result may be only
/// the part that was clicked. Returns nothing if no box differs from its surroundings.
std::optional<ImageBox> clickBox(const cv::Mat& bgr, const Eigen::Vector2d& pixel);

} // namespace dewpoint::observation
