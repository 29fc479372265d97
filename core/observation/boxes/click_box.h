// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/image_box.h"

#include <opencv2/core/mat.hpp>

#include <optional>

namespace dewpoint::observation {

/// Returns the bounding box of the object that was clicked in an image (CV_8UC3). `pixel` must lie
/// in the image.
///
/// The object size is unknown. The function therefore tries boxes around the click. The sizes range
/// from 7 pixels to 0.7 of the image's smaller side, and the shapes from three times as high as
/// wide to three times as wide as high. Each box is tried in an image that is reduced until the box
/// is about 20 pixels in size, so that highlights, seams and noise average out. The function
/// chooses the box that differs most from its surroundings (BoxContrast), with a penalty that
/// increases with the distance between the click and the center of the box. The result is the
/// figure inside this box (boxWithoutMargin()), which is the object without its margin. If the
/// color region at the click (growRegion()) has about the same box, the region's box is returned
/// instead, because its outline is more exact.
///
/// If the chosen box and the box of the region differ, the chosen box may contain more than the
/// colors of a target can describe. The function then considers figures of all sizes up to the
/// chosen box. Each figure is rated by how well its colors, as TargetColors would learn them,
/// distinguish the figure from its surroundings. The result is the largest figure that is rated
/// nearly as well as the best figure. If the region is part of the object, only figures that
/// contain the region are considered; if no such figure is rated well enough, the result is the
/// region's box. For an object of several colors, the result may be only the part that was clicked.
/// Returns nothing if no box differs from its surroundings.
std::optional<ImageBox> boxAroundClick(const cv::Mat& bgr, const Eigen::Vector2d& pixel);

} // namespace dewpoint::observation
