// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/catalog/method_reference.h"

#include <fmt/format.h>

namespace dewpoint::tracking {

std::string parameterText(const ParameterDeclaration& declaration) {
  return fmt::format("{}{}{} ({} to {}){} {}", declaration.defaultValue,
                     declaration.unit.empty() ? "" : " ", declaration.unit, declaration.minimum,
                     declaration.maximum,
                     declaration.isDerivedFromCameras ? ", unless given as the cameras show." : ".",
                     declaration.description);
}

std::string methodReference(const Method& method) {
  std::string text =
      fmt::format("{}: {}. {}\n", method.name, method.text.title, method.text.summary);
  if (!method.text.paper.empty()) {
    text += fmt::format("Paper: {}\n", method.text.paper);
  }
  for (const ParameterDeclaration& declaration : method.parameters()) {
    text += fmt::format("  {}: {}\n", declaration.key, parameterText(declaration));
  }
  return text;
}

} // namespace dewpoint::tracking
