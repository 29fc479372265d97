// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/reference/markdown.h"
#include "app/dewpoint-cli/reference/reference_pages.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace dewpoint::app {
namespace {

/// Those that --help lists, too. A group of options is a command without a name to CLI11.
std::vector<const CLI::App*> listedCommands(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* command) {
    return !command->get_group().empty() && !command->get_name().empty();
  });
}

/// The options of a command, those in its groups included.
std::vector<const CLI::Option*> optionsOf(const CLI::App& command) {
  std::vector<const CLI::Option*> options = command.get_options();
  for (const CLI::App* group :
       command.get_subcommands([](const CLI::App* below) { return below->get_name().empty(); })) {
    std::ranges::copy(group->get_options(), std::back_inserter(options));
  }
  return options;
}

/// What a value of an option looks like: "whole number, 1 to 256" for CLI11's "INT:INT in [1 -
/// 256]".
std::string valueText(const CLI::Option& option) {
  static const std::map<std::string, std::string, std::less<>> kKinds{
      {"TEXT", "text"}, {"INT", "whole number"}, {"UINT", "whole number"}, {"FLOAT", "number"}};
  static const std::regex kRange(R"(\w+ in \[(\S+) - (\S+)\])");
  static const std::regex kChoices(R"(\{(.*)\})");
  const std::string type = option.get_type_name();
  const auto colon = type.find(':');
  const auto kind = kKinds.find(type.substr(0, colon));
  std::string text = kind == kKinds.end() ? type.substr(0, colon) : kind->second;
  std::smatch part;
  if (const std::string check = colon == std::string::npos ? "" : type.substr(colon + 1);
      std::regex_match(check, part, kRange)) {
    text += fmt::format(", {} to {}", part.str(1), part.str(2));
  } else if (std::regex_match(check, part, kChoices)) {
    text = std::regex_replace("one of " + part.str(1), std::regex(","), ", ");
  } else if (!check.empty()) {
    text += fmt::format(", {}", check);
  }
  return option.get_items_expected_max() > 1 ? text + "; more than one" : text;
}

std::string optionTable(const CLI::App& command) {
  std::vector<std::vector<std::string>> rows;
  for (const CLI::Option* option : optionsOf(command)) {
    if (option->get_group().empty() || option->check_lname("help")) {
      continue;
    }
    const std::string name =
        option->get_positional() ? option->get_name(true) : option->get_name(false, true);
    rows.push_back({markdownCode(name), markdownText(valueText(*option)),
                    markdownText(option->get_default_str()),
                    option->get_required() ? "yes" : std::string(),
                    markdownText(option->get_description())});
  }
  return rows.empty()
             ? std::string()
             : markdownTable({"argument or option", "value", "default", "required", "meaning"},
                             rows) +
                   "\n";
}

std::string commandSections(const CLI::App& command, const std::string& path) {
  std::string text = fmt::format("## {}\n\n{}\n\n{}", path, markdownText(command.get_description()),
                                 optionTable(command));
  for (const std::string& alias : command.get_aliases()) {
    text += fmt::format("Also: {}.\n\n", markdownCode(alias));
  }
  for (const CLI::App* below : listedCommands(command)) {
    text += commandSections(*below, path + " " + below->get_name());
  }
  return text;
}

} // namespace

std::string commandsPage(const CLI::App& app) {
  std::string text = fmt::format("# All commands and options\n\n"
                                 "Every command of `{}`, as the program declares it. What the "
                                 "commands do, with examples: [Command line](command-line.md). "
                                 "Every command also has `--help`.\n\n{}\n",
                                 app.get_name(), markdownText(app.get_footer()));
  std::vector<std::vector<std::string>> rows;
  std::string sections;
  for (const CLI::App* command : listedCommands(app)) {
    const std::string name = command->get_name();
    rows.push_back({fmt::format("[{0}](#{0})", name), markdownText(command->get_description())});
    sections += commandSections(*command, name);
  }
  return fmt::format("{}\n{}\n{}", text, markdownTable({"command", "what it does"}, rows),
                     sections);
}

} // namespace dewpoint::app
