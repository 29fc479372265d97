// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/image_box.h"

#include <opencv2/core/mat.hpp>

#include <optional>

namespace dewpoint::observation {

/// The bounding box of the object that was clicked in an image (CV_8UC3). The pixel must lie in it.
///
/// The size of the object is not known: boxes of all sizes from 7 pixels to 0.7 of the image's
/// smaller side, from three times as high as wide to three times as wide, are tried around the
/// click, each in the image made so much smaller that it has about 20 pixels (so that highlights,
/// seams and noise average out). Taken is the one that differs most from its surroundings
/// (FigureContrast), less the farther the click is from its center; then the figure in it
/// (figureBox()), or the box of the color region at the click (growRegion()) where it is about the
/// same: its outline is the more exact one, where it is right.
///
/// Where it is not, the box may hold more than what can be followed. Of the figures of all sizes up
/// to it, the largest is taken whose colors, as TargetColors would learn them, tell it from its
/// surroundings nearly as well as those of the best; it holds the region, where that is part of the
/// object, or is the region. An object of several colors may give the part of it that was clicked.
/// Nothing where no box differs from what is around it.
std::optional<ImageBox> clickBox(const cv::Mat& bgr, const Eigen::Vector2d& pixel);

} // namespace dewpoint::observation
