// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_migration.h"

#include "core/project/project_format.h"

#include <array>

namespace dewpoint::project {
namespace {

/// From format 1: whatever says 1 and has a part of format 2 was edited by hand, and means it.
void migrateFromFormat1(toml::table& /*project*/) {}

/// Step k leads from format k + 1 to the next one.
constexpr std::array<void (*)(toml::table&), kProjectFormat - 1> kSteps{&migrateFromFormat1};

} // namespace

void migrateProject(toml::table& project, std::int64_t format) {
  for (std::int64_t step = format; step >= 1 && step < kProjectFormat; ++step) {
    kSteps[static_cast<std::size_t>(step - 1)](project);
  }
  project.insert_or_assign("format", kProjectFormat);
}

} // namespace dewpoint::project
