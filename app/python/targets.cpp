// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/bindings.h"
#include "app/python/python_error.h"
#include "core/tracking/target.h"
#include "core/tracking/target_shape_name.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <pybind11/stl.h>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace dewpoint::app {
namespace {

using Bounds = std::pair<double, double>;
/// Hue, saturation and intensity, each from and to.
using Color = std::tuple<Bounds, Bounds, Bounds>;
/// Camera, frame, and x, y, width, height in pixels.
using FirstBox = std::tuple<int, std::int64_t, double, double, double, double>;

Color colorFrom(const ColorRange& range) {
  return {Bounds{range.hueMin, range.hueMax}, Bounds{range.saturationMin, range.saturationMax},
          Bounds{range.intensityMin, range.intensityMax}};
}

ColorRange rangeFrom(const Color& color) {
  const auto& [hue, saturation, intensity] = color;
  return {hue.first,         hue.second,      saturation.first,
          saturation.second, intensity.first, intensity.second};
}

TargetShape shapeFrom(const std::string& name) {
  const auto shape = targetShapeFromName(name);
  if (!shape) {
    raiseBadValue("shape",
                  fmt::format("one of {}; not {}", fmt::join(targetShapeNames(), ", "), name));
  }
  return *shape;
}

std::optional<FirstBox> boxOf(const Target& target) {
  if (!target.box) {
    return std::nullopt;
  }
  const ImageBox& box = target.box->box;
  return FirstBox{target.box->camera, target.box->frame, box.x, box.y, box.width, box.height};
}

Target makeTarget(const std::string& name, double radius, const std::vector<Color>& colors,
                  const std::string& shape, const std::optional<FirstBox>& box) {
  Target target;
  target.name = name;
  target.radius = radius;
  target.shape = shapeFrom(shape);
  for (const Color& color : colors) {
    if (&color == &colors.front()) {
      target.color = rangeFrom(color);
    } else {
      target.otherColors.push_back(rangeFrom(color));
    }
  }
  if (box) {
    const auto& [camera, frame, x, y, width, height] = *box;
    target.box = TargetBox{camera, frame, {x, y, width, height}};
  }
  return target;
}

std::vector<Color> colorsOfTarget(const Target& target) {
  std::vector<Color> colors;
  for (const ColorRange& range : target.colors()) {
    colors.push_back(colorFrom(range));
  }
  return colors;
}

/// The target with another name, radius or shape; the samples of its colors stay.
Target replaced(Target target, const std::optional<std::string>& name,
                const std::optional<double>& radius, const std::optional<std::string>& shape) {
  target.name = name.value_or(target.name);
  target.radius = radius.value_or(target.radius);
  target.shape = shape ? shapeFrom(*shape) : target.shape;
  return target;
}

} // namespace

void bindTargets(py::module_& module) {
  py::class_<Target>(module, "Target",
                     "What is tracked. A value: assign Project.targets to change it in a project.")
      .def(py::init(&makeTarget), py::arg("name"), py::kw_only(), py::arg("radius") = 0.0,
           py::arg("colors") = std::vector<Color>(), py::arg("shape") = "auto",
           py::arg("box") = py::none(),
           "radius in meters, 0 if unknown; colors: ranges ((hue, hue), (saturation, saturation), "
           "(intensity, intensity)), hue in degrees, the others from 0 to 1; shape: auto, ball or "
           "any; box: (camera, frame, x, y, width, height) for methods that follow boxes.")
      .def_readonly("name", &Target::name, "Its name.")
      .def_readonly("radius", &Target::radius, "Meters; 0 when unknown.")
      .def_property_readonly("colors", colorsOfTarget,
                             "Its colors, each ((hue, hue), (saturation, saturation), (intensity, "
                             "intensity)).")
      .def_property_readonly(
          "shape", [](const Target& target) { return nameOf(target.shape); },
          "Its shape: auto (determined from the images), ball or any.")
      .def_property_readonly("box", boxOf,
                             "Its first box, (camera, frame, x, y, width, height), or None.")
      .def("replace", replaced, py::kw_only(), py::arg("name") = py::none(),
           py::arg("radius") = py::none(), py::arg("shape") = py::none(),
           "The same target with another name, radius or shape.")
      .def("__eq__", [](const Target& one, const Target& other) { return one == other; })
      .def("__repr__", [](const Target& target) {
        return fmt::format("<dewpoint.Target {}, radius {} m>", target.name, target.radius);
      });
}

} // namespace dewpoint::app
