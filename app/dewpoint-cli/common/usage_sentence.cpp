// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/common/usage_sentence.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <regex>

namespace dewpoint::app {
namespace {

/// The command that was chosen last: "export", or "experiment" and then "people".
const CLI::App& chosen(const CLI::App& app) {
  const auto subcommands = app.get_subcommands();
  return subcommands.empty() ? app : chosen(*subcommands.front());
}

std::string pathOf(const CLI::App& app) {
  const auto* parent = app.get_parent();
  return parent == nullptr ? app.get_name() : pathOf(*parent) + " " + app.get_name();
}

/// Letters to change, add or leave out to come from one word to the other (Levenshtein).
std::size_t distance(const std::string& one, const std::string& other) {
  std::vector<std::size_t> row(other.size() + 1);
  for (std::size_t k = 0; k <= other.size(); ++k) {
    row[k] = k;
  }
  for (std::size_t i = 1; i <= one.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t k = 1; k <= other.size(); ++k) {
      const std::size_t changed = diagonal + (one[i - 1] == other[k - 1] ? 0 : 1);
      diagonal = std::exchange(row[k], std::min({row[k] + 1, row[k - 1] + 1, changed}));
    }
  }
  return row.back();
}

/// "; did you mean --seed?" when there is something much alike.
std::string guess(const std::string& word, const CLI::App& app) {
  std::vector<std::string> known;
  for (const CLI::Option* option : app.get_options()) {
    known.push_back(option->get_name());
  }
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    known.push_back(command->get_name());
  }
  const auto best = std::ranges::min_element(
      known, {}, [&](const std::string& one) { return distance(word, one); });
  constexpr std::size_t kAlike = 2; // letters
  return best != known.end() && distance(word, *best) <= kAlike
             ? fmt::format("; did you mean {}?", *best)
             : std::string();
}

std::string unknown(const std::string& word, const CLI::App& app) {
  if (word.starts_with('-')) {
    return fmt::format("{}: unknown option {}{}", pathOf(app), word, guess(word, app));
  }
  const bool isCommand = app.get_parent() == nullptr;
  return isCommand ? fmt::format("{}: unknown command {}{}", pathOf(app), word, guess(word, app))
                   : fmt::format("{}: unexpected argument {}", pathOf(app), word);
}

std::string plain(const std::string& number) {
  return fmt::format("{}", std::strtod(number.c_str(), nullptr));
}

/// "--rate: Value -5 not in range 0.100000 to 10000.000000" and the like in plain words.
std::string inWords(const std::string& text) {
  static const std::regex kRange(R"((\S+): Value (.*) not in range (\S+) to (\S+))");
  static const std::regex kChoice(R"((\S+): (.*) not in \{(.*)\})");
  static const std::regex kNumber(R"(Could not convert: (\S+) = (.*))");
  constexpr double kEndless = 1e300;
  std::smatch part;
  if (std::regex_match(text, part, kRange)) {
    const double low = std::strtod(part.str(3).c_str(), nullptr);
    const bool endless = std::strtod(part.str(4).c_str(), nullptr) > kEndless;
    const std::string range = !endless ? plain(part.str(3)) + " to " + plain(part.str(4))
                              : std::abs(low) < 1.0 / kEndless ? "a number above 0"
                                                               : plain(part.str(3)) + " or more";
    return fmt::format("{} must be {}, not {}", part.str(1), range, part.str(2));
  }
  if (std::regex_match(text, part, kChoice)) {
    const std::string choices = std::regex_replace(part.str(3), std::regex(","), ", ");
    return fmt::format("{} must be one of {}, not {}", part.str(1), choices, part.str(2));
  }
  if (std::regex_match(text, part, kNumber)) {
    return fmt::format("{}: {} is not a usable value", part.str(1), part.str(2));
  }
  return text;
}

} // namespace

std::string describeUsageError(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = chosen(app);
  const auto left = app.remaining(true);
  const bool isMissing = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  const bool isExtra = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
  const std::string what = (isMissing || isExtra) && !left.empty()
                               ? unknown(left.front(), command)
                               : fmt::format("{}: {}", pathOf(command), inWords(error.what()));
  return fmt::format("{}{} See '{} --help'.\n", what, what.ends_with('?') ? "" : ".",
                     pathOf(command));
}

} // namespace dewpoint::app
