#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "commands.h"
#include "limes/io/io.h"
#include "options.h"
#include "table.h"
#include "terminal.h"

namespace limes::app {
namespace {

void print_text() {
  std::vector<std::vector<std::string>> rows{
      {"FORMAT", "EXTENSION", "READ", "WRITE", "TAGS", "NAMES"}};
  const auto mark = [](bool yes) { return std::string(yes ? "yes" : "-"); };
  for (const Format& f : all_formats)
    rows.push_back({std::string(f.name), std::string(f.extension), mark(f.read != nullptr),
                    mark(f.write != nullptr), mark(f.tags), mark(f.names)});
  std::string text = format_table(rows);
  for (const Format& f : all_formats) {
    text += fmt::format("\n{}\n", f.extension);
    if (f.read) text += fmt::format("  read:  {}\n", f.reads);
    if (f.write) text += fmt::format("  write: {}\n", f.writes);
  }
  print(text);
}

void print_json() {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Format& f : all_formats)
    list.push_back({{"name", f.name},
                    {"extension", f.extension},
                    {"read", f.read != nullptr},
                    {"write", f.write != nullptr},
                    {"tags", f.tags},
                    {"names", f.names},
                    {"reads", f.reads},
                    {"writes", f.writes}});
  print_object({{"formats", std::move(list)}});
}

}  // namespace

void add_formats(CLI::App& program) {
  const auto json = std::make_shared<bool>(false);
  CLI::App& app = *program.add_subcommand("formats", "List the file formats and their limits");
  app.add_flag("--json", *json, "Print one JSON object on standard output")->group(run_group);
  app.footer("TAGS: creases, corners, holes, boundary rule. NAMES: groups and parts of faces.");
  app.final_callback([json] { *json ? print_json() : print_text(); });
}

}  // namespace limes::app
