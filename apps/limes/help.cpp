#include "help.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <sstream>
#include <vector>

#include "limes/core/error.h"
#include "limes/core/text.h"

#ifndef LIMES_VERSION
#define LIMES_VERSION "unknown"
#endif

namespace limes::app {
namespace {

/// Usage first, one blank line between groups, the help flags last.
class HelpLayout : public CLI::Formatter {
 public:
  HelpLayout() { column_width(30); }

  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode) const override {
    std::string text = app->get_description() + "\n\n" + make_usage(app, std::move(name));
    const auto positionals = app->get_options(
        [](const CLI::Option* o) { return o->get_positional() && !o->get_group().empty(); });
    if (!positionals.empty()) text += make_group("Input", true, positionals);
    // Help comes last although its flag was declared first.
    std::vector<std::string> groups = app->get_groups();
    std::stable_partition(groups.begin(), groups.end(),
                          [](const std::string& g) { return g != "Help"; });
    for (const std::string& group : groups) {
      const auto options = app->get_options(
          [&](const CLI::Option* o) { return o->get_group() == group && o->nonpositional(); });
      if (!group.empty() && !options.empty()) text += make_group(group, false, options);
    }
    text += make_subcommands(app, CLI::AppFormatMode::Normal);
    const std::string footer = make_footer(app);
    if (!footer.empty()) text += "\n" + footer;
    return text;
  }

  std::string make_usage(const CLI::App* app, std::string name) const override {
    const bool has_commands = !app->get_subcommands({}).empty();
    std::string usage = "Usage: " + name + (has_commands ? " COMMAND" : "");
    for (const CLI::Option* o : app->get_options())
      if (o->get_positional())
        usage += o->get_required() ? " " + o->get_name(true) : " [" + o->get_name(true) + "]";
    for (const CLI::Option* o : app->get_options())
      if (o->nonpositional() && o->get_required())
        usage += " " + shortest_name(*o) + " " +
                 o->get_option_text().substr(0, o->get_option_text().find(' '));
    return usage + " [options]\n";
  }

 private:
  static std::string shortest_name(const CLI::Option& option) {
    if (!option.get_snames().empty()) return "-" + option.get_snames().front();
    return "--" + option.get_lnames().front();
  }
};

/// Number of letters to insert, delete or replace to turn one word into the other.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

std::string suggestion(std::string_view word, const std::vector<std::string>& known) {
  std::string best;
  std::size_t distance = std::max<std::size_t>(word.size() / 3, 1) + 1;
  for (const std::string& k : known) {
    const std::size_t d = edit_distance(word, k);
    if (d < distance) {
      best = k;
      distance = d;
    }
  }
  return best.empty() ? "" : fmt::format("; did you mean {}?", best);
}

const CLI::App& chosen_command(const CLI::App& program) {
  const auto chosen = program.get_subcommands();
  return chosen.empty() ? program : *chosen.front();
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* o : command.get_options())
    if (!o->get_group().empty())
      for (const std::string& name : o->get_lnames())
        names.push_back("--" + name);
  return names;
}

std::string unexpected_argument(const CLI::App& program) {
  const CLI::App& command = chosen_command(program);
  const auto arguments = program.remaining(true);
  if (arguments.empty()) return "an argument that was not expected";
  const std::string& word = arguments.front();
  if (&command == &program && !word.starts_with('-')) {
    std::vector<std::string> names;
    for (const CLI::App* c : program.get_subcommands({}))
      names.push_back(c->get_name());
    const std::string near = suggestion(word, names);
    return fmt::format("there is no command {}{}", quote(word),
                       near.empty() ? fmt::format("; known are {}", fmt::join(names, ", ")) : near);
  }
  if (!word.starts_with('-')) return fmt::format("unexpected argument {}", quote(word));
  const std::string name = word.substr(0, word.find('='));
  return fmt::format("there is no option {}{}", quote(name),
                     suggestion(name, option_names(command)));
}

/// A shell variable that is not set must not read as an option that is not given.
void refuse_empty_value(CLI::Option& option) {
  const std::string name =
      option.get_positional() ? option.get_name(true) : "--" + option.get_lnames().front();
  option.check([name](const std::string& value) {
    if (value.empty()) throw UsageError("{}: the value is empty", name);
    return std::string();
  });
}

}  // namespace

std::string version() {
  return LIMES_VERSION;
}

void set_up_program(CLI::App& program) {
  program.name("limes");
  program.description("Subdivision surfaces you can compute on.");
  program.formatter(std::make_shared<HelpLayout>());
  program.option_defaults()->group("Help");
  program.set_help_flag("-h,--help", "Show this help");
  program.set_version_flag("--version", "limes " + version(), "Show the version");
  program.require_subcommand(1);
  program.footer(
      "'limes COMMAND --help' explains a command.\n\n"
      "Results go to files and standard output, remarks and progress to standard error.\n"
      "Exit codes: 0 done, 1 internal error, 2 wrong usage, 3 bad input, 4 did not converge,\n"
      "5 cannot write, 130 interrupted. With an error, standard output stays empty.");
}

void set_up_commands(CLI::App& program) {
  for (CLI::App* command : program.get_subcommands({})) {
    command->group("Commands");
    command->set_help_flag("-h,--help", "Show this help")->group("Help");
    for (CLI::Option* option : command->get_options())
      if (option->get_items_expected_max() > 0) refuse_empty_value(*option);
  }
}

std::string help_text(const CLI::App& program) {
  return program.help();  // of the chosen command, if there is one
}

std::string usage_message(const CLI::App& program, const CLI::ParseError& error) {
  const CLI::App& command = chosen_command(program);
  // A misspelt option also leaves the right one missing: the cause comes first.
  const bool missing = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  if (dynamic_cast<const CLI::ExtrasError*>(&error) ||
      (missing && !program.remaining(true).empty()))
    return unexpected_argument(program);
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error)) {
    const std::string what = error.what();
    const std::string option = what.substr(0, what.find(':'));
    const bool twice = what.find("At Most") != std::string::npos;
    return fmt::format("{} {}", option, twice ? "is given more than once" : "needs a value");
  }
  if (&command == &program)
    return missing ? "a command is missing; 'limes --help' lists them" : error.what();
  return fmt::format("{}; see 'limes {} --help'", error.what(), command.get_name());
}

}  // namespace limes::app
