// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/export/export_formats.h"

#include <fmt/format.h>

namespace dewpoint::trajectory {

std::string unitsSentence(const ExportTable& table) {
  const char* axes = table.axes == WorldAxes::ZUp
                         ? "Z points up, axes as in the project"
                         : "Y points up, (x, y, z) is (y, z, x) of the project";
  return fmt::format("Lengths in {0}, times in s, covariances in {0}^2; {1}; right-handed.",
                     table.unitName(), axes);
}

} // namespace dewpoint::trajectory
