// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/snapped_click.h"

#include "core/calibration/manual/click_aids.h"

#include <cstddef>

namespace dewpoint::ui {
namespace {

constexpr double kSnapPx = 7.0; ///< of the image

} // namespace

Eigen::Vector2d snappedClick(const TrackSnapshotPtr& snapshot, int camera,
                             const Eigen::Vector2d& pixel, bool exact) {
  const auto index = static_cast<std::size_t>(camera);
  if (exact || !snapshot || !snapshot->frames || index >= snapshot->frames->frames.size() ||
      !snapshot->frames->frames[index]) {
    return pixel;
  }
  return snapToCorner(snapshot->frames->frames[index]->image, pixel, kSnapPx).value_or(pixel);
}

} // namespace dewpoint::ui
