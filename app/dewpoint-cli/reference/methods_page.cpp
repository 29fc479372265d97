// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/reference/markdown.h"
#include "app/dewpoint-cli/reference/reference_pages.h"
#include "core/tracking/catalog/method_catalog.h"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace dewpoint::app {
namespace {

std::string defaultText(const ParameterDeclaration& declaration) {
  const std::string text = fmt::format("{:g}", declaration.defaultValue);
  return declaration.isDerivedFromCameras ? text + ", or from the cameras" : text;
}

std::string meaningText(const ParameterDeclaration& declaration) {
  std::string text = markdownText(declaration.description);
  if (!declaration.upperLimitKey.empty()) {
    text += fmt::format(" Never more than {}.", markdownCode(declaration.upperLimitKey));
  }
  return text;
}

std::string parameterTable(const Method& method) {
  std::vector<std::vector<std::string>> rows;
  for (const ParameterDeclaration& declaration : method.parameters()) {
    const char* kind = declaration.kind == ParameterKind::Integer ? "whole number, " : "";
    rows.push_back({markdownCode(declaration.key), markdownText(declaration.label),
                    std::string(parameterGroupTitle(declaration.group)),
                    markdownText(declaration.unit),
                    fmt::format("{}{:g} to {:g}", kind, declaration.minimum, declaration.maximum),
                    defaultText(declaration), meaningText(declaration)});
  }
  return markdownTable({"key", "in the window", "group", "unit", "range", "default", "meaning"},
                       rows);
}

std::string methodSection(const Method& method) {
  const std::string origin = method.text.paper.empty()
                                 ? "Dewpoint's own method."
                                 : fmt::format("Reproduces {}.", markdownText(method.text.paper));
  const int cameras = method.family.minCameraCount;
  const std::string needs =
      fmt::format("Needs at least {} camera{}{}.", cameras, cameras == 1 ? "" : "s",
                  method.family.needsCalibration ? ", calibrated" : "; no calibration");
  return fmt::format("### {}\n\n**{}.** {} {} {}\n\n{}\n", method.name,
                     markdownText(method.text.title), markdownText(method.text.summary), origin,
                     needs, parameterTable(method));
}

} // namespace

std::string methodsPage() {
  std::string text =
      "# Methods and their parameters\n\nEvery method and every parameter, as the program declares "
      "them. Set a parameter in the panel *Parameters*, in the table `[parameters]` of a [project "
      "file](project-file.md#parameters), or with `--set key=value` on the [command "
      "line](command-line.md#parameters). Where a default says \"or from the cameras\", Dewpoint "
      "computes a value that fits your cameras, unless you set one.\n";
  std::string_view heading;
  for (const Method* method : methodsInDisplayOrder()) {
    if (headingOf(*method) != heading) {
      heading = headingOf(*method);
      text += fmt::format("\n## {}\n\n", markdownText(heading));
    }
    text += methodSection(*method);
  }
  return text;
}

} // namespace dewpoint::app
