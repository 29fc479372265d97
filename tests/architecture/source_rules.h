// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::tests {

/// Longest file the project allows, in lines.
constexpr int kLineLimit = 400;

/// The names a source file includes, in order, as they stand between the quotes or angles;
/// comments do not count.
std::vector<std::string> includesOf(std::string_view text);

/// Everything one source file does against the house rules (docs/architecture.md), one sentence
/// each; empty when it is fine. `path` is relative to the repository, such as "core/base/time.h".
std::vector<std::string> violations(const std::string& path, std::string_view text);

/// How often a source file asks of which kind a method is (docs/architecture.md, "Methods"): names
/// a value of TargetSource or RunTableKind, where a `switch` over them counts once, or asks for an
/// ability only to know whether it is there. Or of which kind an estimate is: calls box() or
/// person() of a target without using at once what they return. Comments do not count.
int kindQuestions(std::string_view text);

/// How often a source file contains `sought`, such as "findsTargets()". Comments do not count.
int occurrencesOf(std::string_view sought, std::string_view text);

/// The classes of which a source file defines member functions, each once.
std::set<std::string> classesDefinedIn(std::string_view text);

} // namespace dewpoint::tests
