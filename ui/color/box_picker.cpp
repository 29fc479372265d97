// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/color/box_picker.h"

#include "core/project/project.h"
#include "core/tracking/boxes/box_filter.h"
#include "ui/color/fresh_target.h"
#include "ui/document/document.h"
#include "ui/text/error_sentence.h"

#include <memory>
#include <utility>

namespace dewpoint::ui {

BoxPicker::BoxPicker(Document& document, QObject* parent) : QObject(parent), document_(document) {}

void BoxPicker::pick(const TrackSnapshotPtr& snapshot, int camera, const QRectF& region) {
  const auto index = static_cast<std::size_t>(camera);
  const bool there = snapshot && snapshot->frames && !snapshot->isPreview &&
                     index < snapshot->frames->frames.size() && snapshot->frames->frames[index];
  if (!there) {
    Q_EMIT failed(tr("No box can be set here, because this camera shows no image."));
    return;
  }
  const bool isBox = region.width() > 0.0 && region.height() > 0.0;
  // The corner of a box lies half a pixel before the center of its first pixel.
  const ImageBox drawn{region.x() + 0.5, region.y() + 0.5, region.width(), region.height()};
  job_.start([this, isBox, drawn, camera, target = target_, frame = snapshot->frame,
              shown = snapshot->frames->frames[index]](const BackgroundJob::Progress&) {
    const auto found = isBox ? checkBox(shown->image, drawn).map([&] { return drawn; })
                             : boxFromClick(shown->image, drawn.x, drawn.y);
    return [this, found, camera, frame, target] {
      if (found) {
        applyResult(target, {camera, frame, *found});
      } else {
        Q_EMIT failed(errorText(found.error()));
      }
    };
  });
}

void BoxPicker::applyResult(int target, const TargetBox& box) {
  const Project& now = document_.project();
  const bool isNew = target < 0 || target >= static_cast<int>(now.targets.size());
  const auto index = isNew ? now.targets.size() : static_cast<std::size_t>(target);
  const bool isFirst = isNew || !now.targets[index].box;
  const std::string name = isNew ? newTargetName(now) : now.targets[index].name;
  const auto edited =
      document_.edit(tr("Box of %1").arg(QString::fromStdString(name)), [&](Project& project) {
        if (isNew) {
          project.targets.emplace_back().name = name;
        }
        project.targets[index].box = box;
      });
  if (!edited) {
    Q_EMIT failed(errorText(edited.error()));
    return;
  }
  setTarget(static_cast<int>(index));
  Q_EMIT boxDefined(static_cast<int>(index), isFirst);
}

} // namespace dewpoint::ui
