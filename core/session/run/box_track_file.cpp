// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run/box_track_file.h"

#include "core/base/text_file.h"
#include "core/trajectory/csv_text.h"

#include <fmt/format.h>

namespace dewpoint::session {

namespace {

std::string notesOf(const BoxTrack& track) {
  std::string text = "# dewpoint boxes\n# units: time s, box px from the image's upper left "
                     "corner\n";
  for (const auto& [key, value] : track.header) {
    text += fmt::format("# {}: {}\n", withoutLineBreaks(key), withoutLineBreaks(value));
  }
  return text;
}

} // namespace

std::string boxCsv(const BoxTrack& track, CsvNotes notes) {
  std::string text = notes == CsvNotes::Written ? notesOf(track) : std::string();
  text += "time_s,frame,target,x_px,y_px,width_px,height_px,center_x_px,center_y_px,similarity,"
          "spread_px,ess,visible\n";
  for (const BoxSample& sample : track.samples) {
    const BoxEstimate& one = sample.estimate;
    const Eigen::Vector2d center = one.box.center();
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", sample.time, sample.frame,
                        sample.target, one.box.x, one.box.y, one.box.width, one.box.height,
                        center.x(), center.y(), one.similarity, one.spreadPixels,
                        one.effectiveSampleSize, one.isVisible ? 1 : 0);
  }
  return text;
}

std::string boxMotText(const BoxTrack& track) {
  std::string text;
  for (const BoxSample& sample : track.samples) {
    const BoxEstimate& one = sample.estimate;
    if (one.isVisible) {
      text += fmt::format("{},{},{:.2f},{:.2f},{:.2f},{:.2f},{:.4f},-1,-1,-1\n", sample.frame + 1,
                          sample.target, one.box.x + 1.0, one.box.y + 1.0, one.box.width,
                          one.box.height, one.similarity);
    }
  }
  return text;
}

Status writeBoxTrack(const BoxTrack& track, const std::filesystem::path& folder, CsvNotes notes) {
  return writeTextFile(folder / "boxes.csv", boxCsv(track, notes)).and_then([&] {
    return writeTextFile(folder / "boxes_mot.txt", boxMotText(track));
  });
}

} // namespace dewpoint::session
