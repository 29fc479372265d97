// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/report/space_drawing.h"

#include "core/base/markup.h"
#include "core/calibration/report/report_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace dewpoint::calibration {
namespace {

constexpr double kHeight = 380.0;
constexpr double kMargin = 28.0;
constexpr double kFrustumPart = 0.08; // of the scene's size: how long a camera is drawn

struct Label {
  std::string text;
  Eigen::Vector3d at;
};

struct SpaceScene {
  std::vector<SpaceLine> lines;
  std::vector<Label> labels;
};

double sizeOf(const CameraRig& cameras, const std::vector<SpaceLine>& lines) {
  Eigen::AlignedBox3d box;
  for (const Camera& camera : cameras) {
    box.extend(camera.center());
  }
  for (const SpaceLine& line : lines) {
    for (const Eigen::Vector3d& point : line.points) {
      box.extend(point);
    }
  }
  return std::max(1e-3, box.sizes().norm());
}

void addCamera(SpaceScene& scene, const Camera& camera, double length) {
  const Eigen::Isometry3d world = camera.cameraFromWorld.inverse();
  const auto& in = camera.intrinsics;
  const double x = length * std::min(1.0, 0.5 * in.width / in.focalX);
  const double y = x * in.height / in.width;
  const Eigen::Vector3d corners[] = {
      {-x, -y, length}, {x, -y, length}, {x, y, length}, {-x, y, length}};
  SpaceLine outline{"camera", {}};
  for (const auto& corner : corners) {
    scene.lines.push_back({"camera", {world.translation(), world * corner}});
    outline.points.push_back(world * corner);
  }
  outline.points.push_back(world * corners[0]);
  scene.lines.push_back(outline);
  scene.lines.push_back({"camera",
                         {world * corners[0], world * Eigen::Vector3d(0, -1.5 * y, length),
                          world * corners[1]}}); // what is up
  scene.labels.push_back({camera.name, world.translation()});
}

SpaceScene sceneOf(const CameraRig& cameras, const std::vector<SpaceLine>& lines) {
  SpaceScene scene;
  const double size = sizeOf(cameras, lines);
  scene.lines = lines;
  for (const Camera& camera : cameras) {
    addCamera(scene, camera, kFrustumPart * size);
  }
  const char* names[] = {"X", "Y", "Z"};
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d end = 1.5 * kFrustumPart * size * Eigen::Vector3d::Unit(axis);
    scene.lines.push_back({"axis", {Eigen::Vector3d::Zero(), end}});
    scene.labels.push_back({names[axis], end});
  }
  return scene;
}

/// The scene from far away, along `view` (rows: right and down in the drawing), fitted.
std::string drawn(const SpaceScene& scene, const Eigen::Matrix<double, 2, 3>& view,
                  const char* label) {
  Eigen::AlignedBox2d box;
  for (const SpaceLine& line : scene.lines) {
    for (const auto& point : line.points) {
      box.extend(Eigen::Vector2d(view * point));
    }
  }
  const Eigen::Vector2d sizes = box.sizes().cwiseMax(1e-9);
  const double scale =
      std::min((kDrawingWidth - 2.0 * kMargin) / sizes.x(), (kHeight - 2.0 * kMargin) / sizes.y());
  const Eigen::Vector2d middle(0.5 * kDrawingWidth, 0.5 * kHeight);
  const auto toDrawing = [&](const Eigen::Vector3d& point) {
    return Eigen::Vector2d(middle + scale * (view * point - box.center()));
  };
  std::string svg = fmt::format("<svg role=\"img\" aria-label=\"{0}\" viewBox=\"0 0 {1} {2}\" "
                                "width=\"{1}\"><text x=\"4\" y=\"14\">{0}</text>\n",
                                label, kDrawingWidth, kHeight);
  auto out = std::back_inserter(svg);
  for (const SpaceLine& line : scene.lines) {
    fmt::format_to(out, "<polyline class=\"{}\" points=\"", line.kind);
    for (const auto& point : line.points) {
      const Eigen::Vector2d at = toDrawing(point);
      fmt::format_to(out, "{:.1f},{:.1f} ", at.x(), at.y());
    }
    svg += "\"/>\n";
  }
  for (const Label& words : scene.labels) {
    const Eigen::Vector2d at = toDrawing(words.at);
    fmt::format_to(out, "<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", at.x() + 4.0, at.y() - 4.0,
                   htmlEscaped(words.text));
  }
  double bar = std::pow(10.0, std::floor(std::log10(0.3 * kDrawingWidth / scale)));
  bar *= 5.0 * bar * scale < 0.3 * kDrawingWidth   ? 5.0
         : 2.0 * bar * scale < 0.3 * kDrawingWidth ? 2.0
                                                   : 1.0;
  fmt::format_to(out,
                 "<path class=\"axis\" d=\"M8 {0:.1f}h{1:.1f}\"/><text x=\"{2:.1f}\" "
                 "y=\"{3:.1f}\">{4:g} m</text>\n</svg>\n",
                 kHeight - 8.0, bar * scale, 14.0 + bar * scale, kHeight - 4.0, bar);
  return svg;
}

} // namespace

std::string spaceDrawing(const CameraRig& cameras, const std::vector<SpaceLine>& lines,
                         const char* label) {
  const SpaceScene scene = sceneOf(cameras, lines);
  Eigen::Matrix<double, 2, 3> above;
  above << 1.0, 0.0, 0.0, 0.0, -1.0, 0.0;
  // Turned by 30 degrees about Z, looked at 25 degrees from above.
  const double turn = 0.5236;
  const double lift = 0.4363;
  Eigen::Matrix<double, 2, 3> side;
  side << std::cos(turn), std::sin(turn), 0.0, std::sin(lift) * std::sin(turn),
      -std::sin(lift) * std::cos(turn), -std::cos(lift);
  return drawn(scene, side, label) + drawn(scene, above, "from above");
}

} // namespace dewpoint::calibration
