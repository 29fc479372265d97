// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/project_handle.h"
#include "app/python/python_error.h"
#include "app/wiring/open_project.h"
#include "core/setup/clicks/footage_learning.h"
#include "core/tracking/target_shape_name.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <optional>
#include <pybind11/stl.h>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

namespace py = pybind11;

namespace dewpoint::app {
namespace {

/// The name of a camera, or its number from 0.
using CameraKey = std::variant<std::string, int>;
using Pixel = std::array<double, 2>;
using PixelBox = std::array<double, 4>;
/// Camera, frame, pixel.
using Click = std::tuple<CameraKey, std::int64_t, Pixel>;

/// What a lesson taught, as Python reads it.
struct ColorLesson {
  Target target;
  std::optional<double> radius;
  std::vector<std::tuple<std::string, double, double>> found; ///< camera, x, y
  int score = 0;
  double targetShare = 0.0;
  double backgroundShare = 0.0;
};

int cameraOf(const Project& project, const CameraKey& key) {
  const auto& cameras = project.cameras;
  if (const int* const number = std::get_if<int>(&key)) {
    if (*number >= 0 && *number < static_cast<int>(cameras.size())) {
      return *number;
    }
    raiseBadValue("camera", fmt::format("there are {} cameras, counted from 0; not {}",
                                        cameras.size(), *number));
  }
  const auto& name = std::get<std::string>(key);
  const auto found = std::ranges::find_if(
      cameras, [&](const ProjectCamera& camera) { return camera.camera.name == name; });
  if (found == cameras.end()) {
    raiseBadValue("camera",
                  fmt::format("none of the {} cameras is called {}", cameras.size(), name));
  }
  return static_cast<int>(found - cameras.begin());
}

ColorSample sampleOf(const Project& project, const Click& click, bool excluded) {
  const auto& [camera, frame, pixel] = click;
  if (frame < 0) {
    raiseBadValue("frame", fmt::format("frames are counted from 0; not {}", frame));
  }
  ColorSample sample;
  sample.isExcluded = excluded;
  sample.camera = cameraOf(project, camera);
  sample.frame = frame;
  sample.x = pixel[0];
  sample.y = pixel[1];
  return sample;
}

setup::FootageClicks clicksFrom(const Project& project, const CameraKey& camera, std::int64_t frame,
                                const std::optional<Pixel>& pixel,
                                const std::optional<PixelBox>& box, const std::vector<Click>& more,
                                const std::vector<Click>& exclude) {
  if (pixel.has_value() == box.has_value()) {
    raiseBadValue("pixel", "expected either a pixel on the target or a box around it");
  }
  setup::FootageClicks clicks;
  const Pixel at = pixel.value_or(box ? Pixel{(*box)[0], (*box)[1]} : Pixel{});
  ColorSample& first = clicks.samples.emplace_back(sampleOf(project, {camera, frame, at}, false));
  if (box) {
    first.width = (*box)[2];
    first.height = (*box)[3];
    if (!first.isBox()) {
      raiseBadValue("box", "x, y, width and height are expected, the last two above 0");
    }
  }
  for (const Click& click : more) {
    clicks.samples.push_back(sampleOf(project, click, false));
  }
  for (const Click& click : exclude) {
    clicks.samples.push_back(sampleOf(project, click, true));
  }
  return clicks;
}

ColorLesson lessonFrom(const setup::FootageLearningResult& taught) {
  const ColorAssessment& assessment = taught.learningResult.color.assessment;
  ColorLesson lesson{taught.project.targets[taught.target],
                     taught.learningResult.radius,
                     {},
                     assessment.score(),
                     assessment.targetShare,
                     assessment.backgroundShare};
  for (const ColorSample& sample : taught.learningResult.samples) {
    if (sample.isFoundByGeometry) {
      const auto& camera = taught.project.cameras[static_cast<std::size_t>(sample.camera)];
      lesson.found.emplace_back(camera.camera.name, sample.x, sample.y);
    }
  }
  return lesson;
}

ColorLesson learnColorIn(ProjectHandle& handle, const CameraKey& camera, std::int64_t frame,
                         const std::optional<Pixel>& pixel, const std::optional<PixelBox>& box,
                         const std::optional<std::string>& target,
                         const std::optional<double>& radius,
                         const std::optional<std::string>& shape, const std::vector<Click>& more,
                         const std::vector<Click>& exclude) {
  auto clicks = clicksFrom(handle.project, camera, frame, pixel, box, more, exclude);
  clicks.targetName = target;
  clicks.radius = radius;
  if (shape) {
    clicks.shape = targetShapeFromName(*shape);
    if (!clicks.shape) {
      raiseBadValue("shape",
                    fmt::format("one of {}; not {}", fmt::join(targetShapeNames(), ", "), *shape));
    }
  }
  SessionInputs inputs = openProjectInputs(handle);
  auto taught = [&] {
    const py::gil_scoped_release release;
    return setup::learnFromFootage(std::move(inputs.project), *inputs.source,
                                   inputs.backgroundImages, std::move(clicks));
  }();
  if (!taught) {
    raiseProjectError(handle, taught.error());
  }
  ColorLesson lesson = lessonFrom(*taught);
  handle.project = std::move(taught->project);
  return lesson;
}

} // namespace

void bindColorLearning(py::module_& module, ProjectClass& project) {
  py::class_<ColorLesson>(module, "ColorLesson", "What Project.learn_color() found.")
      .def_readonly("target", &ColorLesson::target, "The target with its new color.")
      .def_readonly("found", &ColorLesson::found,
                    "Where other cameras show it: (camera, x, y) for each.")
      .def_readonly("radius", &ColorLesson::radius,
                    "The radius that the images show, meters, or None.")
      .def_readonly("score", &ColorLesson::score,
                    "How well the color sets the target apart, 0 to 100.")
      .def_readonly("target_share", &ColorLesson::targetShare,
                    "Share of the sampled colors that match, 0 to 1.")
      .def_readonly("background_share", &ColorLesson::backgroundShare,
                    "Share of the background that also has this color.")
      .def("__repr__", [](const ColorLesson& lesson) {
        return fmt::format("<dewpoint.ColorLesson {}, {} of 100>", lesson.target.name,
                           lesson.score);
      });
  project.def(
      "learn_color", learnColorIn, py::arg("camera") = 0, py::arg("frame") = 0, py::kw_only(),
      py::arg("pixel") = py::none(), py::arg("box") = py::none(), py::arg("target") = py::none(),
      py::arg("radius") = py::none(), py::arg("shape") = py::none(),
      py::arg("more") = std::vector<Click>(), py::arg("exclude") = std::vector<Click>(),
      "Learns the color of a target from a pixel (x, y) on it, or a box (x, y, width, height) "
      "around it, in a frame of a camera (its name, or its number from 0). The project's target is "
      "changed; another name makes another target. more, exclude: further clicks (camera, frame, "
      "(x, y)) on the target, and on what is not the target.");
}

} // namespace dewpoint::app
