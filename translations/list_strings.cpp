// SPDX-License-Identifier: GPL-3.0-or-later
// Prints what core declares for people's eyes as source text for lupdate: core knows no Qt, so
// nothing there is marked for translation. script/translate runs it; see docs/translations.md.
#include "core/base/error.h"
#include "core/experiment/studies/figure_experiments.h"
#include "core/setup/doctor/finding.h"
#include "core/tracking/catalog/method_catalog.h"

#include <cstdio>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace {

using Marked = std::set<std::pair<std::string, std::string>>; ///< context, text

/// A text as C++ writes it.
std::string literal(const std::string& text) {
  std::string result = "\"";
  for (const char letter : text) {
    if (letter == '\n') {
      result += "\\n";
      continue;
    }
    if (letter == '"' || letter == '\\') {
      result += '\\';
    }
    result += letter;
  }
  return result + "\"";
}

void addErrors(Marked& marked) {
  // The codes count up from 0; the first number that is no code any more has the general phrase.
  constexpr int kMoreThanEnough = 1000;
  const std::string beyond =
      dewpoint::base::errorPhrase(static_cast<dewpoint::base::ErrorCode>(kMoreThanEnough));
  std::string phrase;
  for (int code = 0; phrase != beyond; ++code) {
    phrase = dewpoint::base::errorPhrase(static_cast<dewpoint::base::ErrorCode>(code));
    marked.emplace("Error", phrase);
  }
}

void addMethods(Marked& marked) {
  for (const auto& method : dewpoint::tracking::methods()) {
    marked.emplace("Method", method.text.title);
    marked.emplace("Method", method.text.summary);
    marked.emplace("Method", dewpoint::tracking::headingOf(method));
    for (const auto& declaration : method.parameters()) {
      marked.emplace("ParameterGroup", dewpoint::tracking::parameterGroupTitle(declaration.group));
      marked.emplace("Parameter", declaration.label);
      marked.emplace("Parameter", declaration.description);
      if (!declaration.unit.empty()) {
        marked.emplace("Unit", declaration.unit);
      }
    }
  }
}

void addExperiments(Marked& marked) {
  for (const auto* experiment : dewpoint::experiment::listedExperiments()) {
    marked.emplace("Experiment", experiment->title);
    marked.emplace("Experiment", experiment->description);
    marked.emplace("Experiment", dewpoint::experiment::experimentGroupTitle(experiment->group));
  }
}

void addFindings(Marked& marked) {
  for (const auto& texts : dewpoint::setup::findingTexts()) {
    for (const std::string_view text : {texts.description, texts.advice}) {
      if (!text.empty()) {
        marked.emplace("Finding", text);
      }
    }
  }
}

} // namespace

int main() {
  Marked marked;
  addErrors(marked);
  addMethods(marked);
  addExperiments(marked);
  addFindings(marked);
  for (const auto& [context, text] : marked) {
    std::printf("QT_TRANSLATE_NOOP(\"%s\", %s)\n", context.c_str(), literal(text).c_str());
  }
}
