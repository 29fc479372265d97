// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/grade.h"

#include <algorithm>
#include <array>

namespace dewpoint::experiment {
namespace {

/// The grades and their names, the easiest first.
struct NamedGrade {
  Grade grade;
  const char* name;
};
constexpr std::array kGrades{NamedGrade{Grade::Ideal, "ideal"}, NamedGrade{Grade::Room, "room"},
                             NamedGrade{Grade::Wild, "wild"}, NamedGrade{Grade::Real, "real"}};

} // namespace

const char* gradeName(Grade grade) {
  const auto* const found = std::ranges::find(kGrades, grade, &NamedGrade::grade);
  return found != kGrades.end() ? found->name : "";
}

std::optional<Grade> gradeFromName(const std::string& name) {
  for (const NamedGrade& grade : kGrades) {
    if (name == grade.name) {
      return grade.grade;
    }
  }
  return std::nullopt;
}

} // namespace dewpoint::experiment
