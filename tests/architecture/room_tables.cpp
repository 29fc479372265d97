// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/architecture/room_tables.h"

#include <utility>

namespace dewpoint::tests {

const std::map<std::string, Names, std::less<>>& floorTable() {
  static const std::map<std::string, Names, std::less<>> kTable = {
      {"base", {}},
      {"geometry", {"base"}},
      {"color", {"base"}},
      {"trajectory", {"base"}},
      {"filter", {"base"}},
      {"simulation", {"geometry", "base"}},
      {"capture", {"geometry", "base"}},
      {"calibration", {"geometry", "base"}},
      {"observation", {"filter", "color", "geometry"}},
      {"tracking", {"observation", "filter", "color", "geometry"}},
      {"camera_motion", {"tracking", "capture", "calibration"}},
      {"project", {"calibration", "tracking", "base"}},
      {"setup", {"project", "capture", "trajectory", "camera_motion"}},
      {"session", {"tracking", "camera_motion", "capture", "project", "trajectory", "calibration"}},
      {"broadcast", {"session"}},
      {"experiment", {"session", "setup", "simulation"}},
  };
  return kTable;
}

const std::map<std::string, std::map<std::string, Names>, std::less<>>& roomTable() {
  static const std::map<std::string, std::map<std::string, Names>, std::less<>> kTable = {
      {"color", {{"", {}}, {"likelihood", {""}}}},
      {"trajectory", {{"", {}}, {"export", {""}}, {"figure", {"", "export"}}, {"jobs", {""}}}},
      {"capture", {{"", {}}, {"devices", {""}}, {"gstreamer", {"", "devices"}}}},
      {"observation",
       {{"background", {}},
        {"boxes", {}},
        {"sphere", {"background"}},
        {"region", {"background", "sphere"}},
        {"people", {"boxes"}}}},
      {"calibration",
       {{"bundle", {}},
        {"formats", {}},
        {"manual", {"bundle"}},
        {"board", {"bundle"}},
        {"wand", {"bundle"}},
        {"planning", {"bundle"}},
        {"world", {}},
        {"quality", {"board", "bundle", "formats", "wand"}},
        {"report", {"board", "manual", "wand"}}}},
      {"tracking",
       {{"", {}},
        {"barrera", {""}},
        {"boxes", {""}},
        {"dewpoint/search", {""}},
        {"dewpoint/track", {"", "dewpoint/search"}},
        {"dewpoint", {"", "dewpoint/search", "dewpoint/track"}},
        {"people", {""}},
        {"catalog", {"", "barrera", "boxes", "dewpoint", "people"}}}},
      {"camera_motion", {{"", {}}, {"agreement", {}}}},
      {"setup",
       {{"new_project", {}},
        {"clicks", {}},
        {"calibration", {"clicks", "new_project"}},
        {"", {"new_project"}},
        {"doctor", {"", "new_project"}}}},
      {"session",
       {{"frames", {}},
        {"people", {"frames"}},
        {"run", {"frames", "people"}},
        {"watch", {"frames", "run"}},
        {"snapshot", {"frames", "people", "watch"}},
        {"view", {"people", "snapshot"}},
        {"log", {"frames", "people", "run", "snapshot"}},
        {"rewind", {"frames", "run", "snapshot"}},
        {"selftest", {"", "frames", "run"}},
        {"take", {"frames", "run"}},
        {"", {"frames", "people", "run", "watch", "snapshot", "log", "rewind"}}}},
      {"broadcast",
       {{"message", {}},
        {"format", {"message"}},
        {"transport", {"message"}},
        {"", {"format", "message", "transport"}}}},
      {"simulation",
       {{"surface", {}},
        {"room", {"surface"}},
        {"sensor", {"room"}},
        {"people", {"room", "sensor", "surface"}},
        {"body", {"people", "room", "surface"}},
        {"scene", {"body", "people", "room", "sensor", "surface"}}}},
      {"experiment",
       {{"metrics", {}},
        {"report", {}},
        {"boxes", {}},
        {"scenarios", {"boxes"}},
        {"scenarios/wild", {"scenarios"}},
        {"scenarios/draft", {"scenarios", "scenarios/wild"}},
        {"scenarios/targets", {"scenarios", "scenarios/draft"}},
        {"scenarios/catalog", {"scenarios", "scenarios/draft", "scenarios/targets"}},
        {"scenarios/people", {"scenarios", "scenarios/draft"}},
        {"clips", {"boxes", "scenarios"}},
        {"baselines", {"boxes", "scenarios"}},
        {"suite", {"baselines", "boxes", "metrics", "report", "scenarios", "scenarios/catalog"}},
        {"studies", {"boxes", "metrics", "report", "scenarios", "scenarios/people"}}}},
  };
  return kTable;
}

const std::vector<Names>& windowFloors() {
  static const std::vector<Names> kFloors = {
      {"text", "style", "jobs", "preferences", "selection", "scene3d"},
      {"widgets"},
      {"document", "session", "actions"},
      {"workbench"},
      {"cameraview", "view3d", "plots", "timeline"},
      {"panels", "trajectory"},
      {"calibration", "color", "correction", "people", "export", "experiments", "start", "help",
       "recording", "broadcast", "cameras"},
      {"mainwindow"},
  };
  return kFloors;
}

bool windowNeighbors(const std::string& from, const std::string& to) {
  static const std::set<std::pair<std::string, std::string>> kArrows = {
      {"style", "scene3d"},    // the colors of targets are those of the 3D view
      {"style", "text"},       // a legend says lengths
      {"session", "document"}, // the run obeys the document
  };
  return kArrows.contains({from, to});
}

bool calibrationArrow(const std::string& from, const std::string& to) {
  return to.empty() || (from == "manual" && to == "points");
}

const std::map<std::string, Names, std::less<>>& commandTable() {
  static const std::map<std::string, Names, std::less<>> kTable = {
      {"common", {}},
      {"project", {"common"}},
      {"calibrate", {"common"}},
      {"track", {"common", "project"}},
      {"live", {"common"}},
      {"trajectory", {"common"}},
      {"simulate", {"common"}},
      {"experiment", {"common", "simulate"}},
      {"reference", {"common"}},
  };
  return kTable;
}

const Names& windowlessPrograms() {
  static const Names kPrograms = {"command_pages", "dewpoint-cli", "python", "wiring"};
  return kPrograms;
}

const Names& windowHeaders() {
  static const Names kHeaders = {"core/calibration/board/board.h",
                                 "core/calibration/board/board_edit.h",
                                 "core/calibration/board/board_print.h",
                                 "core/calibration/formats/format_catalog.h",
                                 "core/calibration/planning/camera_placement.h",
                                 "core/calibration/manual/click_aids.h",
                                 "core/calibration/manual/interactive_pose.h",
                                 "core/calibration/manual/measured_points.h",
                                 "core/calibration/manual/point_drag.h",
                                 "core/calibration/planning/rig_map.h",
                                 "core/geometry/camera_name.h",
                                 "core/geometry/projected_lines.h",
                                 "core/geometry/reference_grid.h",
                                 "core/geometry/rig_view.h",
                                 "core/geometry/world_box.h",
                                 "core/color/color_ranges.h",
                                 "core/color/color_learning.h",
                                 "core/color/color_histogram.h",
                                 "core/geometry/camera.h",
                                 "core/experiment/studies/figure_experiments.h",
                                 "core/project/project.h",
                                 "core/project/project_changes.h",
                                 "core/project/project_check.h",
                                 "core/project/project_load.h",
                                 "core/project/project_save.h",
                                 "core/tracking/boxes/box_filter.h",
                                 "core/tracking/catalog/method_catalog.h",
                                 "core/tracking/parameters.h",
                                 "core/trajectory/trajectory.h",
                                 "core/trajectory/csv_line.h",
                                 "core/trajectory/motion.h",
                                 "core/trajectory/motion_csv.h",
                                 "core/trajectory/figure/figure_drawing.h",
                                 "core/trajectory/export/trajectory_export.h",
                                 "core/trajectory/export/export_catalog.h",
                                 "core/trajectory/export/export_table.h"};
  return kHeaders;
}

} // namespace dewpoint::tests
