// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_pages/declared_command.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace dewpoint::app {
namespace {

std::vector<std::string> listedChoices(const std::string& list) {
  std::vector<std::string> choices;
  std::istringstream stream(list);
  for (std::string choice; std::getline(stream, choice, ',');) {
    choices.push_back(choice);
  }
  return choices;
}

/// The parser describes a value as "TEXT", "TEXT:{a,b}" or "INT:INT in [1 - 256]".
void readKindOfValue(const std::string& text, DeclaredArgument& argument) {
  const std::size_t colon = text.find(':');
  argument.valueKind = text.substr(0, colon);
  if (colon == std::string::npos) {
    return;
  }
  const std::string allowed = text.substr(colon + 1);
  if (allowed.starts_with('{') && allowed.ends_with('}')) {
    argument.choices = listedChoices(allowed.substr(1, allowed.size() - 2));
  } else {
    argument.range = allowed;
  }
}

DeclaredArgument declaredArgument(const CLI::Option& option) {
  DeclaredArgument argument;
  if (option.nonpositional()) {
    for (const std::string& name : option.get_snames()) {
      argument.names.push_back("-" + name);
    }
    for (const std::string& name : option.get_lnames()) {
      argument.names.push_back("--" + name);
    }
  } else {
    argument.names = {option.get_name(true)};
  }
  if (option.get_items_expected_max() > 0) {
    readKindOfValue(option.get_type_name(), argument);
  }
  argument.defaultValue = option.get_default_str();
  argument.description = option.get_description();
  argument.isRequired = option.get_required();
  argument.isRepeatable = option.get_items_expected_max() > 1;
  return argument;
}

DeclaredCommand declaredBelow(const CLI::App& app, std::vector<std::string> path);

void readDeclarations(const CLI::App& app, DeclaredCommand& command) {
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_group().empty()) {
      (option->nonpositional() ? command.options : command.positionals)
          .push_back(declaredArgument(*option));
    }
  }
  for (const CLI::App* below : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (below->get_name().empty()) { // options that belong together, not a command
      readDeclarations(*below, command);
    } else if (!below->get_group().empty()) {
      std::vector<std::string> longer = command.path;
      longer.push_back(below->get_name());
      command.subcommands.push_back(declaredBelow(*below, std::move(longer)));
    }
  }
}

DeclaredCommand declaredBelow(const CLI::App& app, std::vector<std::string> path) {
  DeclaredCommand command;
  command.path = std::move(path);
  command.description = app.get_description();
  command.footer = app.get_footer();
  readDeclarations(app, command);
  return command;
}

} // namespace

DeclaredCommand declaredCommand(const CLI::App& app) {
  return declaredBelow(app, {app.get_name()});
}

std::vector<const DeclaredCommand*> commandAndSubcommands(const DeclaredCommand& command) {
  std::vector<const DeclaredCommand*> all{&command};
  for (const DeclaredCommand& below : command.subcommands) {
    const auto more = commandAndSubcommands(below);
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

std::string joined(const std::vector<std::string>& texts, const std::string& separator) {
  std::string whole;
  for (const std::string& text : texts) {
    whole += (whole.empty() ? "" : separator) + text;
  }
  return whole;
}

std::string pathWithoutProgram(const DeclaredCommand& command) {
  return joined({command.path.begin() + 1, command.path.end()}, " ");
}

std::vector<std::string> optionNames(const DeclaredCommand& command) {
  std::vector<std::string> names;
  for (const DeclaredArgument& option : command.options) {
    names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return names;
}

std::vector<std::string> commandNames(const DeclaredCommand& command) {
  std::vector<std::string> names;
  for (const DeclaredCommand& below : command.subcommands) {
    names.push_back(below.path.back());
  }
  return names;
}

std::string shellIdentifier(const std::string& text) {
  std::string name = text;
  std::ranges::replace_if(
      name, [](unsigned char letter) { return std::isalnum(letter) == 0; }, '_');
  return name;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

std::string singleQuoted(const std::string& text) {
  return "'" + replaced(text, "'", "'\\''") + "'";
}

} // namespace dewpoint::app
